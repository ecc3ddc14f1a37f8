"""Report, pictures and last good state of another run, which stayed beside the recording of a new one.

A run that could not go on left the report and all pictures of the good run before it beside its own
recording; a good run left the `state.bin` of a failed one, from which `gantline statics --state` answered.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from fake_core import FakeCore, core
from gantline.cli.app import app
from gantline.results import open_recording
from sample_lift import sample_recording, sample_rig

__all__ = ["core"]

pytestmark = pytest.mark.usefixtures("player")

#: Of a run that makes no report and no pictures of its own.
ALONE = ("--no-plots", "--no-report")
#: What others wrote, or other verbs, and what is no file.
OTHERS = ("cases.json", "equilibrium.nc", "motion_1.nc", "photo.png", "equalizer_of_1998.png", "notes.html")


def run(folder: Path, *words: str) -> tuple[int, set[str]]:
    """Exit code, and what is in the folder then."""
    result = CliRunner().invoke(app, ["run", "lift.yaml", "-o", str(folder), *words])
    assert "Traceback" not in result.output
    return result.exit_code, {one.name for one in folder.iterdir()}


def test_a_run_that_fails_leaves_nothing_of_the_one_before(core: type[FakeCore], tmp_path: Path) -> None:
    code, good = run(tmp_path)
    assert code in (0, 1, 4)
    assert {"recording.nc", "report.html", "system.png", "equalizer_e1.png"} <= good
    for name in OTHERS:
        (tmp_path / name).write_text("of another", encoding="utf-8")
    core.fails_at = 2
    code, failed = run(tmp_path, *ALONE)
    assert code == 3
    assert failed == {"recording.nc", "state.bin", *OTHERS}
    assert open_recording(tmp_path / "recording.nc").attributes["status"] == "failed"


def test_a_good_run_leaves_nothing_of_one_that_failed(core: type[FakeCore], tmp_path: Path) -> None:
    core.fails_at = 2
    assert run(tmp_path, *ALONE) == (3, {"recording.nc", "state.bin"})
    core.fails_at = float("inf")
    _, good = run(tmp_path, "--no-plots", "--no-report")
    assert good == {"recording.nc"}


def test_pictures_of_the_equalizers_before_go_too(core: type[FakeCore], tmp_path: Path) -> None:
    """The recording that is there says which equalizers had pictures."""
    rig = sample_rig()
    rig["equalizers"][0]["name"] = "e9"
    sample_recording(np.arange(2.0), rig=rig, tension=np.zeros((2, 5))).save(tmp_path / "recording.nc")
    for name in ("e8", "e9"):
        (tmp_path / f"equalizer_{name}.png").write_text("of another", encoding="utf-8")
    core.fails_at = 2
    assert run(tmp_path, *ALONE) == (3, {"recording.nc", "state.bin", "equalizer_e8.png"})


def test_a_comparison_leaves_no_state_of_the_one_before(core: type[FakeCore], tmp_path: Path) -> None:
    words = ["compare", "lift.yaml", "lift.yaml", "-o", str(tmp_path), "--no-plots"]
    core.fails_at = 2
    assert CliRunner().invoke(app, words).exit_code == 3
    assert (tmp_path / "a.state.bin").is_file() and (tmp_path / "b.state.bin").is_file()
    core.fails_at = float("inf")
    assert CliRunner().invoke(app, words).exit_code == 0
    assert not list(tmp_path.glob("*.state.bin"))


def test_a_link_stays_and_what_it_leads_to_goes(core: type[FakeCore], tmp_path: Path) -> None:
    """As where a report is written: the link stays a link."""
    folder, there = tmp_path / "out", tmp_path / "there.html"
    folder.mkdir()
    there.write_text("of another run", encoding="utf-8")
    (folder / "report.html").symlink_to(there)
    core.fails_at = 2
    assert run(folder, *ALONE) == (3, {"recording.nc", "state.bin", "report.html"})
    assert (folder / "report.html").is_symlink() and not there.exists()
    core.fails_at = float("inf")
    run(folder, "--no-plots")
    assert (folder / "report.html").is_symlink() and there.is_file()
