"""The first page had the speeds of hoists and trolleys, and none of winches, booms and slewing cranes.

`docs/guides/report.md` promises steps with their speeds; of `floating_crane` 14 steps of 31 read `haul` or
`veer` and no more, though the crew has to keep 0.42 m/min at the stern and 0.51 m/min at the bow.
"""

from __future__ import annotations

import math

import pytest

from gantline.report.steps import step_rows
from gantline.report.subject import Subject
from sample_lift import ringing_lift, sample_rig


@pytest.mark.parametrize(
    ("kind", "speed", "shown"),
    [
        ("haul", 0.42 / 60, "haul 0.42 m/min"),
        ("veer", 0.51 / 60, "veer 0.51 m/min"),
        ("luff", math.radians(0.5) / 60, "luff 0.5 deg/min"),
        ("slew", 0.2 * 2 * math.pi / 60, "slew 72 deg/min"),
        ("haul_in", 0.2, "haul in 12 m/min"),
        ("pump", None, "pump"),
    ],
)
def test_a_step_says_how_fast_it_moves(kind: str, speed: float | None, shown: str) -> None:
    rig = sample_rig()
    rig["plan"] = [{"step": "one", "kind": kind, "speed": speed}]
    assert step_rows(Subject(ringing_lift(rig=rig)))[0]["does"] == shown
