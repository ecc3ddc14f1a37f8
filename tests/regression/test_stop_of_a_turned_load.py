"""Stop if tilt is over 1.0 deg, said the first page of the report of a column that was upended.

Where a lift sets no `load_tilt` the usual degree was written down, for a load too that its plan turns by 87.
A sheet that says to stop where nobody can is not read where it matters.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift

#: Two hooks, each plumb over its lug.
APART, LENGTH = 8.0, 10.0
HOOKS = {"A": (-APART / 2, 0.0, 20.0), "B": (APART / 2, 0.0, 20.0)}
LUGS = {"1": (-APART / 2, 0.0, 4.0), "2": (APART / 2, 0.0, 4.0)}
SLINGS = {"S1": ("A", "1", LENGTH), "S2": ("B", "2", LENGTH)}
PLAN = """\
plan:
  - {step: turn, hoist: A, speed: 0.1 m/s, by: HEIGHT m}
  - {step: end, hold: until_end}
"""


def told(height: float, more: str = "") -> str:
    text = hooked_lift(HOOKS, LUGS, SLINGS, position=(0.0, 0.0, 6.0), more=PLAN + more)
    text = text.replace("duration: 10 s", "duration: 80 s").replace("HEIGHT", str(height))
    subject = Subject(gantline.simulate(parse_scenario(text)))
    return next(one for one in stop_if(subject) if "tilt" in one)


def test_a_load_that_is_turned_on_purpose_is_held_against_its_plan() -> None:
    """Lugs 8 m apart, one 3 m up: asin(3/8), but for slings of 10 m that lean as the lugs come together."""
    text = told(3.0)
    assert text.startswith("tilt is more than 1.0 deg off the plan, in which it hangs still at up to ")
    planned = float(text.split()[-2])
    assert planned == pytest.approx(math.degrees(math.asin(3.0 / APART)), abs=1.0)


def test_a_level_load_and_one_with_a_limit_are_held_against_that() -> None:
    assert told(0.05) == "tilt is over 1.0 deg"
    assert told(3.0, "limits: {load_tilt: 25 deg}\n") == "tilt is over 25.0 deg"
