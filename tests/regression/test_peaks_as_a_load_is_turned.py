"""What a hook bears as a load is turned from one hold to another was held to its rating without contingency.

A beam of 20 t hangs from two hooks by lugs 3 m above its centre of gravity. Level, each bears half of it;
with the end at the hook E raised until the beam slopes by 35 deg E bears 71 %, and half again once it has
been let down. It hangs still level alone. So for E there were 11 t, half of the design weight, and the
simulated peak, 14.2 t of 14.5 t: a GO at 98 %. With the contingency of 1.1 it is 108 % as it slopes, which a
run that holds there told. So it was with its sling, its shackles and its lug, and with the charts of cranes.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Outcome, Verdict, check_recording, outcome_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

#: Half of the distance between lugs, lugs over the centre of gravity, slings [m], slope [rad].
HALF, ABOVE, SLINGS, SLOPE = 5.0, 3.0, 100.0, math.radians(35.0)
#: Load and what hook, lug and shackle may bear [t], contingency.
MASS, RATED, CONTINGENCY = 20.0, 14.5, 1.1
RAISED = 2.0 * HALF * math.sin(SLOPE)
HOOK = f"rated_capacity: {RATED} t, hoist: {{speed: 10 m/min, acceleration: 0.02 m/s^2}}"
LIFT = f"""\
format: 1
lift: {{title: A beam is turned and let down again}}
duration: 145 s
ground: {{level: 0 m, friction: 0.5}}
ropes:
  sling: {{axial_stiffness: 300 MN, mass: none, minimum_breaking_force: 3 MN, damping_time: 10 ms}}
shackles:
  wb: {{working_load_limit: {RATED} t, mass: 10 kg, bow_diameter: 60 mm, pin_diameter: 42 mm}}
load:
  name: beam
  shape: {{box: [10 m, 2 m, 4 m]}}
  weight: {{calculated: {MASS} t, contingency: {CONTINGENCY}}}
  centre_of_gravity: {{at: [0 m, 0 m, {4.0 - ABOVE} m]}}
  stands_on: ground
  lugs:
    W: {{at: [-{HALF} m, 0 m, 4 m], capacity: {RATED} t}}
    E: {{at: [{HALF} m, 0 m, 4 m], capacity: {RATED} t}}
cranes:
  W: {{type: fixed_hook, at: [-{HALF} m, 0 m, {4.0 + SLINGS} m], {HOOK}}}
  E: {{type: fixed_hook, at: [{HALF} m, 0 m, {4.0 + SLINGS} m], {HOOK}}}
sling_defaults: {{rope: sling, shackles: {{top: wb, bottom: wb}}}}
slings:
  W: {{from: W, to: beam.W, length: {SLINGS + 0.01} m}}
  E: {{from: E, to: beam.E, length: {SLINGS + 0.01} m}}
plan:
  - {{step: up,    hoist: [W, E], speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: clear, hoist: [W, E], speed: 3 m/min, by: 0.5 m}}
  - {{step: level, hold: 10 s}}
  - {{step: turn,  hoist: E, speed: 10 m/min, by: {RAISED} m}}
  - {{step: back,  lower: E, speed: 10 m/min, by: {RAISED} m}}
  - {{step: end,   hold: until_end}}
limits: {{rule: yard, sling_factor_on_breaking_force: 5, load_tilt: 40 deg}}
"""
HELD = LIFT.replace("  - {step: back", "  - {step: look, hold: 20 s}\n  - {step: back")
#: The same by two crawler cranes of which a chart rates the hook load, one at either end.
CRANE = """\
    type: crawler
    rating_includes_hook_block: false
    tracks: {length: 9 m, width: 1.5 m, gauge: 8.4 m, stiffness: 2000 MN/m}
    base_mass: 190 t
    central_ballast: 95 t
    counterweight: {mass: 250 t, behind: 6.5 m}
    boom: {heel_pins: {ahead: 1.6 m, height: 2.5 m}, length: 63 m, radius: 14 m, mass: 60 t}
    rating: {radius: [12 m, 16 m], rated: [14.5 t, 14.5 t], off_lead: 5 deg, side_lead: 5 deg}
    hooks: {H: {type: H, height: 24 m}}
"""
HOOK_TYPES = """\
hook_types:
  H:
    rated_capacity: 400 t
    block: {mass: 1 t, height: 2 m}
    reeving: {parts_each: 4, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m, sheave_block_mass: 1 kg}
    drum: {diameter: 0.8 m}
    hoist: {speed: 10 m/min, acceleration: 0.02 m/s^2}
"""
NAMES = ["hoist_load_of_rated_capacity", "lug_load_of_capacity", "shackle_dynamic_load_of_strength"]
#: By moments about the lug W, of the design weight.
USED = MASS * CONTINGENCY * (0.5 + ABOVE * math.tan(SLOPE) / (2.0 * HALF)) / RATED


@pytest.fixture(scope="module")
def checks() -> list[Check]:
    return check_recording(simulate(parse_scenario(LIFT)))


def _of(checks: list[Check], name: str) -> Check:
    (check,) = [one for one in checks if one.name == name]
    return check


@pytest.mark.parametrize("name", NAMES)
def test_the_design_weight_counts_as_it_is_turned(checks: list[Check], name: str) -> None:
    """Slings of 100 m lean by 0.5 deg as the hooks stay 10 m apart, which is 0.5 % of the share."""
    check = _of(checks, name)
    assert USED / CONTINGENCY < 1.0 < USED
    assert check.value == pytest.approx(USED, rel=1e-2)
    assert check.verdict is Verdict.FAILED
    assert "x 1.1 to the design weight" in check.formula and check.element.endswith(
        ("E", "E top", "E bottom")
    )
    assert outcome_of(checks) is Outcome.NO_GO


def test_a_hold_there_tells_the_same(checks: list[Check]) -> None:
    held = check_recording(simulate(parse_scenario(HELD)))
    for name in NAMES:
        assert _of(held, name).value == pytest.approx(_of(checks, name).value, rel=5e-3)


def _by_crawlers() -> str:
    head, _, rest = LIFT.partition("cranes:\n")
    tail = rest[rest.index("sling_defaults:") :]
    for name in "WE":
        tail = tail.replace(f"from: {name}", f"from: {name}.H").replace(
            f"hoist: {name},", f"hoist: {name}.H,"
        )
    tail = tail.replace("hoist: E,", "hoist: E.H,").replace("lower: E,", "lower: E.H,")
    tail = tail.replace("[W, E]", "[W.H, E.H]")
    tail = tail.replace(f"{SLINGS + 0.01}", "20.01").replace("0.5 m}", "0.5 m, acceleration: 0.01 m/s^2}")
    west = f"  W:\n    position: [-{HALF + 14.0} m, 0 m]\n{CRANE}"
    east = f"  E:\n    position: [{HALF + 14.0} m, 0 m]\n    heading: 180 deg\n{CRANE}"
    rope = "  hoist: {axial_stiffness: 36 MN, damping_time: 20 ms, mass: none, diameter: 28 mm}\n"
    head = head.replace("ropes:\n", f"ropes:\n{rope}")
    return f"{head}cranes:\n{west}{east}{HOOK_TYPES}{tail}"


def test_the_chart_of_a_crane_too() -> None:
    """What hangs in the hook, all of it of the load and its shackles, times the contingency."""
    recording = simulate(parse_scenario(_by_crawlers()))
    check = _of(check_recording(recording), "hoist_load_of_rating")
    most = float(recording.column("hook_load", "E.H").max())
    assert check.value == pytest.approx(most * CONTINGENCY / (RATED * 1e3 * recording.rig.gravity), rel=1e-3)
    assert check.verdict is Verdict.FAILED and "x 1.1 to the design weight" in check.formula
