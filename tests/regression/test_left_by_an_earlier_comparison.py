"""Table, numbers and pictures of an earlier comparison stayed beside the recordings of a new one.

With `--no-plots`, and where a comparison was stopped before B or ended for want of room, its folder held the
new `a.nc` and the `comparison.txt`, `b.nc` and `compare_sling_tension.png` of other lifts.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from gantline.cli.app import app
from sample_lift import ringing_lift, sample_recording

#: What others wrote.
OTHERS = {"a.png", "compare_prices.png", "notes.txt"}


def compare(folder: Path, *words: str) -> tuple[int, set[str]]:
    """Exit code, and what is in the folder then."""
    result = CliRunner().invoke(app, ["compare", *words, "-o", str(folder)])
    assert "Traceback" not in result.output
    return result.exit_code, {one.name for one in folder.iterdir()}


@pytest.fixture
def recordings(tmp_path: Path) -> list[str]:
    """Two that differ."""
    time = np.linspace(0.0, 40.0, 2001)
    other = sample_recording(time, tension=np.full((2001, 5), 6e5))
    return [str(one.save(tmp_path / name)) for name, one in (("x.nc", ringing_lift()), ("y.nc", other))]


def test_pictures_of_the_comparison_before_go(recordings: list[str], tmp_path: Path) -> None:
    folder = tmp_path / "out"
    code, drawn = compare(folder, *recordings)
    assert code == 0
    written = {"a.nc", "b.nc", "comparison.json", "comparison.txt"}
    assert written | {"compare_sling_tension.png", "compare_load_motion.png"} <= drawn
    for name in OTHERS:
        (folder / name).write_text("of another", encoding="utf-8")
    assert compare(folder, *recordings, "--no-plots") == (0, written | OTHERS)


def test_where_there_is_no_new_comparison_there_is_no_old_one(
    recordings: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ended before B: what there is is of A alone."""
    from gantline.cli import compare as module

    folder = tmp_path / "out"
    compare(folder, *recordings)
    simulate = module._simulate

    def until_b(side: module._Side, place: Path) -> None:
        if side.letter == "B":
            raise KeyboardInterrupt
        simulate(side, place)

    monkeypatch.setattr(module, "_simulate", until_b)
    CliRunner().invoke(app, ["compare", *recordings, "-o", str(folder)])
    assert {one.name for one in folder.iterdir()} == {"a.nc"}
