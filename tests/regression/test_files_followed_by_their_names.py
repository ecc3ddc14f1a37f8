"""`gantline view LIFT` did not follow a file whose name has a blank, and followed words that name none.

Which files a lift names was read from its text, right or wrong, by what ends like the name of a file: of
`my hull.stl` that is `hull.stl`, so that the page stayed as it was when the hull was saved anew, and a word
of a comment was followed. The reader knows what it opens.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from gantline.cli.draft import Draft
from gantline.opened import GONE, noted_opened, state_of
from gantline.scenario import ScenarioError
from gantline.scenario.file.shipped import shipped
from gantline.simulation import Simulation

LIFT = shipped()["pulleys"].read_text(encoding="utf-8")
LIBRARY = "format: 1\nropes: {thin: {inextensible: true}}\n"


def named(tmp_path: Path, name: str = "my yard") -> Path:
    """A lift with a library whose name has a blank and, as `library` may, no ending."""
    file = tmp_path / "lift.yaml"
    file.write_text(LIFT.replace("format: 1\n", f"format: 1\nlibrary: '{name}'  # see other.step\n"))
    return file


def test_what_is_opened_is_noted_with_how_it_was(tmp_path: Path) -> None:
    file, library = named(tmp_path), tmp_path / "my yard"
    library.write_text(LIBRARY)
    with noted_opened() as opened:
        Simulation(file)
    assert opened == {file: state_of(file), library: state_of(library)}
    library.write_text(LIBRARY + "# saved since\n")
    assert opened[library] != state_of(library)
    Simulation(file)
    assert set(opened) == {file, library}, "nothing is noted afterwards"


def test_of_a_lift_that_is_refused_what_was_opened_until_then(tmp_path: Path) -> None:
    """Also one that is not there: it is what has to come."""
    file = named(tmp_path)
    with noted_opened() as opened, pytest.raises(ScenarioError, match="my yard"):
        Simulation(file)
    assert opened == {file: state_of(file), tmp_path / "my yard": GONE}


@pytest.mark.parametrize(
    ("lift", "beside"),
    [
        ("goliath", {"block.3docx"}),
        ("crane_barge_in_swell", {"crane_barge.nc"}),
        ("off_a_barge", {"crane_barge.nc", "cargo_barge.nc", "both_barges.nc"}),
    ],
)
def test_cad_and_databases_are_noted(lift: str, beside: set[str]) -> None:
    """Read once for all lifts of a program they are noted each time."""
    for _ in range(2):
        with noted_opened() as opened:
            Simulation(shipped()[lift])
        found = {file.name for file in opened if file != shipped()[lift]}
        assert found == beside


def _waits(for_what: Callable[[], bool]) -> None:
    deadline = time.monotonic() + 60.0
    while not for_what():
        assert time.monotonic() < deadline, "it never came"
        time.sleep(0.005)


@pytest.mark.usefixtures("player")
def test_the_page_follows_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """First refused, since it is not there; then it comes; a word of a comment makes no report."""
    monkeypatch.setattr("gantline.cli.draft._EVERY", 0.01)
    draft = Draft(named(tmp_path))
    following = threading.Thread(target=draft.follow, daemon=True)
    following.start()
    try:
        _waits(lambda: draft.state() == "1")
        assert "The lift file is refused." in draft.text()
        # At once, as editors save it.
        (tmp_path / "new").write_text(LIBRARY)
        (tmp_path / "new").replace(tmp_path / "my yard")
        _waits(lambda: draft.state() == "2")
        assert "One rope, two moving sheaves and a box" in draft.text()
        (tmp_path / "other.step").write_text("ISO-10303-21;")
        time.sleep(0.2)
        assert draft.state() == "2"
    finally:
        draft.end()
        following.join(timeout=60.0)
