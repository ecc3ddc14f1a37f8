"""What hung still in the middle of a lift, and no longer at its end.

Static forces were means over the end of a run alone. A plan that ended by setting the load down had none:
design weight and the factors of the rule were left out without a word, checks compared the simulated peak
by itself, and a NO-GO of 130 % became a GO of 86 % by one more step of the plan. A hook that had handed its
load over, or the lower end of a load that was turned, was held against what was left in it at the end.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario

CONTINGENCY, DYNAMIC = 1.15, 1.1
LIFT = f"""\
format: 1
lift: {{title: four slings lift a module}}
duration: 70 s
ground: {{friction: 0.5}}
ropes:
  sling: {{construction: 6x36 IWRC, grade: 1960, diameter: 44 mm, damping_time: 10 ms}}
load:
  name: module
  shape: {{box: [6 m, 4 m, 3 m]}}
  weight: {{calculated: 40 t, contingency: {CONTINGENCY}}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs:
    A: {{at: [-2.5 m,  1.5 m, 3 m], capacity: 13.2 t}}
    B: {{at: [ 2.5 m,  1.5 m, 3 m], capacity: 13.2 t}}
    C: {{at: [-2.5 m, -1.5 m, 3 m], capacity: 13.2 t}}
    D: {{at: [ 2.5 m, -1.5 m, 3 m], capacity: 13.2 t}}
cranes:
  crane:
    {{type: fixed_hook, at: [0 m, 0 m, 11 m], rated_capacity: 46 t,
     hoist: {{speed: 3 m/min, acceleration: 0.05 m/s^2}}}}
slings:
  A: {{from: crane, to: module.A, length: 8.6 m, rope: sling}}
  B: {{from: crane, to: module.B, length: 8.6 m, rope: sling}}
  C: {{from: crane, to: module.C, length: 8.6 m, rope: sling}}
  D: {{from: crane, to: module.D, length: 8.6 m, rope: sling}}
plan:
  - {{step: lift off, hoist: crane, speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: hoist, hoist: crane, speed: 3 m/min, by: 0.2 m}}
  - {{step: hold point, hold: 20 s}}
rules: {{dynamic_amplification_factor: {DYNAMIC}}}
"""
SET_DOWN = "  - {step: set down, lower: crane, speed: 1 m/min, by: 0.4 m}\nrules:"
SECOND = """\
  second: {type: fixed_hook, at: [0 m, 0 m, 11.01 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
slings:
  A2: {from: second, to: module.A, length: 8.7 m, rope: sling}
  B2: {from: second, to: module.B, length: 8.7 m, rope: sling}
  C2: {from: second, to: module.C, length: 8.7 m, rope: sling}
  D2: {from: second, to: module.D, length: 8.7 m, rope: sling}
"""
HANDED_OVER = """\
  - {step: take over, lower: crane, speed: 1 m/min, by: 0.5 m}
  - {step: let it hang, hold: until_end}
rules:"""


def checks_of(text: str) -> dict[str, Check]:
    return {one.name: one for one in check_recording(gantline.simulate(parse_scenario(text)))}


def test_a_load_that_is_set_down_is_judged_as_it_hung() -> None:
    hanging = checks_of(LIFT)
    landed = checks_of(LIFT.replace("rules:", SET_DOWN))
    for name in ("lug_load_of_capacity", "hoist_load_of_rated_capacity"):
        before, after = hanging[name], landed[name]
        assert before.verdict is after.verdict is Verdict.FAILED
        assert before.value is not None and after.value == pytest.approx(before.value, rel=1e-6)
        assert f"x {DYNAMIC}" in after.formula
    # By hand: 40 t x 1.15 x 1.1 and the slings, about 0.3 t, in a hook of 46 t.
    assert landed["hoist_load_of_rated_capacity"].value == pytest.approx(1.10, abs=0.01)
    assert landed["hook_dynamic_factor"].value == pytest.approx(1.02, abs=0.02)


def test_a_hook_that_has_handed_its_load_over_is_judged_as_it_held_it() -> None:
    text = LIFT.replace("slings:\n", SECOND).replace("rules:", HANDED_OVER)
    alone, handed = checks_of(LIFT), checks_of(text)
    used = handed["hoist_load_of_rated_capacity"]
    assert (used.element, used.verdict) == ("crane", Verdict.FAILED)
    assert used.value == pytest.approx(alone["hoist_load_of_rated_capacity"].value, rel=0.01)
    factor = handed["hook_dynamic_factor"].value
    assert factor is not None and factor < 1.1  # not the peak over the few kilonewtons that are left in it


def test_a_load_that_never_hung_still_is_a_warning() -> None:
    """Without a hold there is nothing to raise to the design weight, and the check says so."""
    text = LIFT.replace("  - {step: hold point, hold: 20 s}\nrules:", SET_DOWN)
    recording = gantline.simulate(parse_scenario(text))
    checks = check_recording(recording)
    lug = next(one for one in checks if one.name == "lug_load_of_capacity")
    assert lug.verdict is Verdict.WARNING
    assert "never hung still" in lug.remark
    assert not verdict_of(checks).startswith("GO;")
