"""A title with a comma and a number behind it was taken for a decimal comma.

``lift: {title: Model of a manifold, 1 to 50}`` is two keys to YAML. The message asked "a decimal comma? write
a point, such as 26.5 m", where quotes are missing: a newcomer looked for a number in the line.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import ScenarioError, load_scenario


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("lift: {title: Model of a manifold, 1 to 50}", "a text with a comma in it stands in quotes"),
        ("ground: {level: 26,0 m}", "a decimal comma? write 26.0 m"),
    ],
)
def test_it_is_told_what_is_missing(tmp_path: Path, line: str, told: str) -> None:
    file = tmp_path / "lift.yaml"
    file.write_text(f"format: 1\n{line}\n")
    with pytest.raises(ScenarioError) as caught:
        load_scenario(file)
    assert told in str(caught.value)
    assert ("decimal comma" in str(caught.value)) == ("decimal comma" in told)
