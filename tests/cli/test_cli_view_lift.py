"""`gantline view LIFT`: the report of a lift file while it is written, anew at each save."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from gantline.cli.draft import Draft
from gantline.opened import GONE, state_of
from gantline.results.recording import Recording
from gantline.scenario.file.shipped import shipped
from gantline.simulation import Simulation
from lift_text import DEAD_CENTRE

LIFT = shipped()["pulleys"].read_text(encoding="utf-8")
TITLE = "One rope, two moving sheaves and a box"
NOTICE = '<div class="notice" role="alert">'


@pytest.fixture(autouse=True)
def at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Files are looked at more often, so that no test waits."""
    monkeypatch.setattr("gantline.cli.draft._EVERY", 0.01)


def waits(for_what: Callable[[], bool]) -> None:
    """Wait until something holds that another thread brings about."""
    deadline = time.monotonic() + 60.0
    while not for_what():
        assert time.monotonic() < deadline, "it never came"
        time.sleep(0.005)


def written(file: Path, text: str) -> Path:
    """Save a file as an editor does that puts a new one in its place; its time is another in any case."""
    before = file.stat().st_mtime_ns if file.exists() else 0
    other = file.with_suffix(".part")
    other.write_text(text, encoding="utf-8")
    os.utime(other, ns=(before + 1_000_000_000, before + 1_000_000_000))
    return other.replace(file)


@contextmanager
def following(file: Path) -> Iterator[Draft]:
    draft = Draft(file)
    thread = threading.Thread(target=draft.follow, daemon=True)
    thread.start()
    try:
        yield draft
    finally:
        draft.end()
        thread.join(timeout=60.0)
        assert not thread.is_alive()


@pytest.mark.usefixtures("player")
def test_a_report_at_each_save_and_what_is_wrong_above_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path / "scenario.yaml", LIFT)
    with following(file) as draft:
        assert f"{file} is being simulated" in draft.text() or draft.state() != "0"
        waits(lambda: draft.state() == "1")
        assert TITLE in draft.text() and NOTICE not in draft.text()
        assert '<meta name="gantline-reload" content="version">' in draft.text()
        assert capsys.readouterr().out.startswith(f"{TITLE}")
        written(file, LIFT.replace("duration:", "duratoin:"))
        waits(lambda: draft.state() == "2")
        refused = draft.text()
        assert TITLE in refused and NOTICE in refused
        assert "The lift file is refused; below is how it was before." in refused
        assert "duratoin" in refused and "did you mean" in refused
        told = capsys.readouterr()
        assert told.out == "" and told.err.startswith(f"error: {file}:")
        file.unlink()
        written(file, LIFT)
        waits(lambda: draft.state() == "3")
        assert NOTICE not in draft.text()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["scenario.yaml"], "nothing is written"


@pytest.mark.usefixtures("player")
def test_a_file_that_begins_wrong_says_so_alone(tmp_path: Path) -> None:
    file = written(tmp_path / "lift.yaml", "format: 1\nlift: {title: A <b>hook</b>}\n")
    with following(file) as draft:
        waits(lambda: draft.state() == "1")
        page = draft.text()
        assert "The lift file is refused." in page and "how it was before" not in page
        assert 'id="gantline-data"' not in page and "<b>" not in page
        written(file, LIFT)
        waits(lambda: draft.state() == "2")
        assert TITLE in draft.text() and 'id="gantline-data"' in draft.text()


@pytest.mark.usefixtures("player")
def test_files_that_a_lift_names_are_followed_too(tmp_path: Path) -> None:
    """A library; what stands in a comment is no file that is opened."""
    library = written(tmp_path / "yard.yaml", "format: 1\n# sheaves as in drawing.step\nropes: {}\n")
    file = written(tmp_path / "scenario.yaml", LIFT.replace("format: 1\n", "format: 1\nlibrary: yard.yaml\n"))
    with following(file) as draft:
        waits(lambda: draft.state() == "1")
        written(tmp_path / "drawing.step", "ISO-10303-21;")
        written(library, "format: 1\n# sheaves as in drawing.step\nropes: {thin: {inextensible: true}}\n")
        waits(lambda: draft.state() == "2")


@pytest.mark.usefixtures("player")
def test_a_simulation_that_a_save_overtakes_begins_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nobody waits for the report of what is no longer written there."""
    file = written(tmp_path / "scenario.yaml", LIFT.replace("One rope", "One old rope"))
    run, stopped = Simulation.run, []

    def overtaken(self: Simulation, **how: Callable[[float], bool]) -> Recording:
        if "One old rope" in self.scenario.text:
            written(file, LIFT)
            assert how["on_progress"](0.0) is False
            stopped.append(True)
            self.status = "stopped"
            return self.recording()
        return run(self, **how)  # type: ignore[arg-type]

    monkeypatch.setattr(Simulation, "run", overtaken)
    with following(file) as draft:
        waits(lambda: draft.state() == "1")
        assert stopped and TITLE in draft.text() and "One old rope" not in draft.text()


@pytest.mark.usefixtures("player")
def test_a_run_that_cannot_go_on_is_shown_up_to_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path / "scenario.yaml", DEAD_CENTRE)
    with following(file) as draft:
        waits(lambda: draft.state() == "1")
        assert NOTICE in draft.text()
        assert capsys.readouterr().err.startswith("error: ")


def test_a_lift_that_is_not_there_ends_it(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["view", str(tmp_path / "nothing.yaml")])
    assert result.exit_code == 2
    assert result.stderr.startswith(f"error: {tmp_path / 'nothing.yaml'}: cannot be read (no such file")
    assert state_of(tmp_path / "nothing.yaml") == GONE
