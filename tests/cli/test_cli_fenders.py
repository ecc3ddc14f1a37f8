"""Tables of fenders: what vessels press on them with, and of their capacity."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gantline
from lift_text import MOORED, spoiled
from verbs import gantline as verb


def test_run_and_statics_have_what_fenders_bear(tmp_path: Path) -> None:
    """A fender that the barge is pressed on from the start, 0.2 m of 1 m, by the line astern; of 5 MN."""
    pressed = ("wall: [-1 m, 0 m], facing: 0 deg,", "wall: [-0.8 m, 0 m], facing: 0 deg, thickness: 1 m,")
    text = spoiled("stiffness: 5 MN/m}", "stiffness: 5 MN/m, capacity: 5 MN}", spoiled(*pressed, MOORED))
    file = tmp_path / "lift.yaml"
    file.write_text(text, encoding="utf-8")
    found = verb(
        "run", str(file), "-o", str(tmp_path / "out"), "--no-plots", "--no-report", columns=120
    ).output
    force = gantline.open_recording(tmp_path / "out" / "recording.nc").column("fender_force", "f1")
    row = re.search(r"^Fender +at the end +peak +at +of capacity \(peak\)\n  f1 +(.*)$", found, re.MULTILINE)
    assert row is not None
    at_end, peak, _, used = re.split("  +", row[1])
    assert (at_end, peak) == (f"{force[-1] / 1e3:.1f} kN", f"{force.max() / 1e3:.1f} kN")
    assert used == f"{force.max() / 5e6:.1%}".replace("%", " %")
    assert float(force[0]) == pytest.approx(0.2 * 5e6)
    rest = verb("statics", str(file), columns=120).output
    assert re.search(r"^Fender +force +of capacity\n  f1 +\d", rest, re.MULTILINE), rest
