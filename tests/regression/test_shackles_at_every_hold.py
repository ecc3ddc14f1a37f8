"""Shackles were held to their side load at one hold point alone, that at which their sling bears most.

A beam is turned by two hooks, its lugs stand across it: level, the sling W bears 70 % of it in the plane of
its lug; with the other end raised until the beam slopes by 25 deg it bears 66 %, 25 deg out of that plane,
where three quarters of a working load limit remain. Static load over working load limit and, with contingency
or a factor of the rule, the dynamic one were those of the level hold, 86 % of 18 t, and the lift a GO; at the
other hold they are 107 %.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Outcome, Verdict, check_recording, outcome_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

#: Half of the distance between lugs, centre of gravity from the middle and below the lugs [m], slope [rad].
HALF, OFF, BELOW, SLOPE = 5.0, 2.0, 0.9, math.radians(25.0)
#: Load, working load limit [t], contingency, and what the chart leaves of the limit from 20 to 30 deg.
MASS, LIMIT, CONTINGENCY, LEFT = 20.0, 18.0, 1.1, 0.75
RAISED = 2.0 * HALF * math.sin(SLOPE)
HOOK = "rated_capacity: 40 t, hoist: {speed: 6 m/min, acceleration: 0.02 m/s^2}"
LIFT = f"""\
format: 1
lift: {{title: A beam is turned by two hooks}}
duration: 90 s
ground: {{level: 0 m, friction: 0.5}}
ropes:
  sling: {{axial_stiffness: 300 MN, mass: none, minimum_breaking_force: 3 MN, damping_time: 10 ms}}
shackles:
  wb18: {{working_load_limit: {LIMIT} t, mass: 15 kg, bow_diameter: 60 mm, pin_diameter: 42 mm}}
load:
  name: beam
  shape: {{box: [10 m, 2 m, 2 m]}}
  weight: {{calculated: {MASS} t, contingency: {CONTINGENCY}}}
  centre_of_gravity: {{at: [-{OFF} m, 0 m, {2.0 - BELOW} m]}}
  stands_on: ground
  lugs:
    W: {{at: [-{HALF} m, 0 m, 2 m], main_plate: yz, capacity: 25 t}}
    E: {{at: [{HALF} m, 0 m, 2 m], main_plate: yz, capacity: 25 t}}
cranes:
  W: {{type: fixed_hook, at: [-{HALF} m, 0 m, 42 m], {HOOK}}}
  E: {{type: fixed_hook, at: [{HALF} m, 0 m, 42 m], {HOOK}}}
sling_defaults: {{rope: sling, shackles: {{top: wb18, bottom: wb18}}}}
slings:
  W: {{from: W, to: beam.W, length: 40.01 m}}
  E: {{from: E, to: beam.E, length: 40.01 m}}
plan:
  - {{step: up,    hoist: [W, E], speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: clear, hoist: [W, E], speed: 1 m/min, by: 0.2 m}}
  - {{step: level, hold: 10 s}}
  - {{step: turn,  hoist: E, speed: 6 m/min, by: {RAISED} m}}
  - {{step: slope, hold: until_end, require: {{load_tilt: above 24 deg}}}}
limits: {{rule: yard, sling_factor_on_breaking_force: 5, lug_out_of_plane_angle: 30 deg}}
"""


@pytest.fixture(scope="module")
def checks() -> list[Check]:
    return check_recording(simulate(parse_scenario(LIFT)))


@pytest.mark.parametrize("name", ["shackle_load_of_working_load_limit", "shackle_dynamic_load_of_strength"])
def test_the_hold_with_the_side_load_counts(checks: list[Check], name: str) -> None:
    """By moments about the lug E, (half - off - below tan(slope)) over 2 half, of the design weight.

    Slings of 40 m lean by 0.7 deg as the hooks stay 10 m apart, which is 0.5 % of the share.
    """
    level = (HALF + OFF) / (2.0 * HALF)
    sloping = level - BELOW * math.tan(SLOPE) / (2.0 * HALF)
    used = MASS * CONTINGENCY * sloping / (LIMIT * LEFT)
    assert MASS * CONTINGENCY * level / LIMIT < 1.0 < used
    (check,) = [one for one in checks if one.name == name]
    assert check.value == pytest.approx(used, rel=1e-2)
    assert check.verdict is Verdict.FAILED
    assert check.element == "W bottom" and "x 0.75 at 2" in check.formula
    assert outcome_of(checks) is Outcome.NO_GO
