"""A mooring line of 3300 m between ends 315 m apart lay on the bed in heaps: in order.

Only a run said something, of a barge that "starts 13.6 m from where the lift file has it".
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from afloat import barge, lift_of, written
from gantline.assembly import assemble
from gantline.scenario import load_scenario

#: From the fairlead 6 m over the water to an anchor 300 m ahead, 30 m deep [m].
APART = math.hypot(300.0, 36.0)


@pytest.mark.parametrize(("length", "is_told"), [(3300.0, True), (2 * APART + 21, True), (600.0, False)])
def test_a_line_that_holds_nothing_is_told(tmp_path: Path, length: float, is_told: bool) -> None:
    line = {
        "vessel": "barge",
        "fairlead": ["100 m", "0 m", "10 m"],
        "to": ["400 m", "0 m", "-30 m"],
        "rope": "moor",
        "sea_bed": "-30 m",
        "length": f"{length} m",
    }
    given = lift_of(
        barge(),
        ropes={"moor": {"construction": "6x36 IWRC", "grade": 1960, "diameter": "44 mm"}},
        mooring_lines={"bow": line},
    )
    found = [one for one in assemble(load_scenario(written(tmp_path, given))).warnings if "bow" in one]
    said = f"mooring line bow is {length:.5g} m long, its ends are {APART:.4g} m apart"
    assert found == ([f"{said}: it is slack, and holds next to nothing"] if is_told else [])
