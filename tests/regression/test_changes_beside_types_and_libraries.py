"""Changes of a lift with types: lines of what a type gives, and a library that was changed to no effect.

`Scenario.changed({"c2.boom": "3 m"})` of a crane whose boom is of its type named the line of the type, in a
library even with the name of the lift file before it. And `{"library": "other.yaml"}`, in Python or in `set:`
of a case, was taken and changed nothing: libraries are read with the file.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import Scenario, ScenarioError, load_scenario

SCENARIO = Path(__file__).parents[2] / "scenarios/floating_crane_and_crawlers/scenario.yaml"


def with_a_library(folder: Path, cases: str = "") -> Path:
    """The lift, with the crawler cranes' type in a library; a case more."""
    text = SCENARIO.read_text(encoding="utf-8")
    types = text[text.index("crane_types:") :].split("\n\n")[0]
    (folder / "yard.yaml").write_text(f"format: 1\n{types}\n", encoding="utf-8")
    text = text.replace(types, "").replace("format: 1\n", "format: 1\nlibrary: yard.yaml\n", 1)
    lift = folder / "lift.yaml"
    lift.write_text(text.replace("\ncases:", f"\ncases:{cases}", 1), encoding="utf-8")
    return lift


def refused(scenario: Scenario, path: str, text: str) -> list[tuple[int | None, str | None, str]]:
    with pytest.raises(ScenarioError) as caught:
        scenario.changed({path: text})
    return [(one.line, one.file, one.path) for one in caught.value.problems]


@pytest.mark.parametrize("path", ["c2.boom", "c2.boom.radius"])
def test_the_line_is_that_of_the_crane(tmp_path: Path, path: str) -> None:
    lift = with_a_library(tmp_path)
    lines = lift.read_text(encoding="utf-8").splitlines()
    (line,) = [number for number, one in enumerate(lines, 1) if one.startswith("  c2: ")]
    assert refused(load_scenario(lift), path, "999 m") == [(line, None, f"cranes.{path}")]
    # What the library says is in its own file, as it was.
    ((_, file, _),) = refused(load_scenario(lift), "crane_types.crawler_400.boom.radius", "999 m")
    assert file == str(tmp_path / "yard.yaml")


def test_a_library_is_read_with_its_file(tmp_path: Path) -> None:
    sentence = "a library is read with its file"
    for scenario in (load_scenario(SCENARIO), load_scenario(with_a_library(tmp_path))):
        with pytest.raises(ScenarioError, match=sentence):
            scenario.changed({"library": "other.yaml"})
    with pytest.raises(ScenarioError, match=sentence):
        load_scenario(with_a_library(tmp_path, "\n  other: {set: {library: other.yaml}}"))
