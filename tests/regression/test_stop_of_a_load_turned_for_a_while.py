"""Stop if tilt is over 1.0 deg, above a plan with a step that waits for 20 deg.

A load that hangs still turned was told apart; one that the plan turns until it tilts by so much, and then
turns back, never hangs still so, and the first page of its report asked for a stop where the plan goes on.
"""

from __future__ import annotations

import gantline
from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift

HOOKS = {"A": (-4.0, 0.0, 20.0), "B": (4.0, 0.0, 20.0)}
LUGS = {"1": (-4.0, 0.0, 4.0), "2": (4.0, 0.0, 4.0)}
SLINGS = {"S1": ("A", "1", 10.0), "S2": ("B", "2", 10.0)}
PLAN = """\
plan:
  - {step: turn, hoist: A, speed: 0.1 m/s, until: {load_tilt: {above: 20 deg}}}
  - {step: back, lower: A, speed: 0.1 m/s, to: 20 m}
  - {step: end, hold: until_end}
"""


def test_it_is_held_against_its_plan() -> None:
    """Lugs 8 m apart: 8 m · sin 20 deg = 2.7 m up in 28 s, and back in as much; it brakes within 0.1 s."""
    text = hooked_lift(HOOKS, LUGS, SLINGS, position=(0.0, 0.0, 6.0), more=PLAN)
    subject = Subject(gantline.simulate(parse_scenario(text.replace("duration: 10 s", "duration: 100 s"))))
    (told,) = (one for one in stop_if(subject) if "tilt" in one)
    assert told.startswith("tilt is more than 1.0 deg off the plan, in which it tilts by up to 2")
    assert 20.0 < float(told.split()[-2]) < 22.0
