"""The shackle at the top of a sling was held against the tension at the middle of the sling.

A lumped sling has half of its weight in its tension, and the check of the rope adds the other half at the
upper end. The shackle there, which bears all of it, did without: 10 t on a plumb sling of 60 m and 2 t pulled
its upper shackle of 12 t with 92 % of its working load limit, where it is 100 %; with nodes it was 100 %.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of

LOAD, LENGTH, PER_METRE, LIMIT, GRAVITY = 10e3, 60.0, 33.0, 12e3, 9.81
LIFT = f"""\
format: 1
lift: {{title: A load on one heavy sling}}
duration: 20 s
ropes: {{heavy: {{axial_stiffness: 400 MN, damping_time: 10 ms, mass: {PER_METRE} kg/m}}}}
shackles: {{bow: {{working_load_limit: {LIMIT} kg}}}}
load:
  name: pump
  shape: {{box: [2 m, 2 m, 2 m]}}
  position: [0 m, 0 m, 10 m]
  weight: {{calculated: {LOAD} kg}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{L1: {{at: [0 m, 0 m, 2 m], main_plate: xz}}}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, {12.0 + LENGTH} m]
    hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}
slings:
  S1: {{from: hook, to: pump.L1, length: {LENGTH} m, rope: heavy, rope_weight: WAY,
    shackles: {{top: bow, bottom: bow}}}}
plan: [{{step: hold, hold: until_end}}]
limits: {{rule: yard, load_tilt: 5 deg}}
"""


def checked(recording: Recording, name: str) -> Check:
    [check] = checks_of(recording, name)
    return check


@pytest.mark.parametrize("way", ["lumped", "distributed", "none"])
@pytest.mark.parametrize("is_run", [True, False])
def test_the_upper_shackle_bears_the_whole_sling(way: str, is_run: bool) -> None:
    """(M + m L) g over the working load limit, at rest."""
    scenario = parse_scenario(LIFT.replace("WAY", way))
    recording = gantline.simulate(scenario) if is_run else gantline.Statics(scenario).equilibrium().recording
    sling = 0.0 if way == "none" else PER_METRE * LENGTH
    used = (LOAD + sling) / LIMIT
    check = checked(recording, "shackle_load_of_working_load_limit")
    assert check.value == pytest.approx(used, rel=1e-3)
    assert check.element == "S1 top"


def test_so_does_it_in_motion() -> None:
    """The peak of a load at rest is its static force."""
    recording = gantline.simulate(parse_scenario(LIFT.replace("WAY", "lumped")))
    check = checked(recording, "shackle_dynamic_load_of_strength")
    assert check.element == "S1 top"
    assert check.value == pytest.approx((LOAD + PER_METRE * LENGTH) / LIMIT, rel=2e-3)
    assert "with own weight" in check.formula or "+ own weight 9.7 kN" in check.formula
    assert pytest.approx(9.7e3, rel=2e-3) == PER_METRE * LENGTH * GRAVITY / 2
