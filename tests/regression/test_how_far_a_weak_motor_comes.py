"""A hoist whose motor is short of power ends a step lower than the plan has it, and only a time was said.

A step `by: 10 m` that took its motor all its power for 46 s came up by 4.9 m, so that the next one, which
lowered, set the load down again: `hoist_follows` said from when and for how long the motor pulled all it
could.
"""

from __future__ import annotations

import re

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from mechanics import G
from weak_hoist import HOOK_BLOCK, standing

HOIST = "{step: hoist, hoist: crane, speed: 1 m/min, by: 0.5 m}"
MASS, POWER = 2.0, 200.0


def test_it_is_said_how_far_the_hook_goes() -> None:
    """With all its power P a motor lifts W at P/W over ideal sheaves: 9.7 mm/s, where 16.7 are asked for."""
    text = standing(HOIST, MASS, f"capacity: 30 kN, power: {POWER} W", 60.0)
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    (check,) = (one for one in checks if one.name == "hoist_follows")
    assert check.verdict is Verdict.WARNING
    lasted, rise = map(float, re.findall(r"for ([\d.]+) s.* up by ([\d.]+) m$", check.remark)[0])
    # The remark has centimetres.
    assert rise == pytest.approx(lasted * POWER / ((1e3 * MASS + HOOK_BLOCK) * G), abs=5.1e-3)
