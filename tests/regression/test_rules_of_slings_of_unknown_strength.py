"""Rules with all factors on the breaking force of slings were a GO with slings that none was applied to.

40 t on two slings, under rules with load, consequence, material and termination factor. Of slings that have a
stiffness and no breaking force, and of slings without shackles, whose bending is not known,
`rope_load_of_breaking_force` was one of "not checked", as where nobody asks for it; the lift was a GO without
a warning, since capacities of hook and lugs are known: at 219 kN of a breaking force of 300 kN, too, since
the bound of 2.3 is that of a lift without such rules.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Outcome, Verdict, check_recording, outcome_of
from gantline.scenario import parse_scenario
from gantline.statics import Statics

LIFT = """\
format: 1
lift: {title: Two slings from somewhere}
duration: 5 s
ropes:
  sling: {axial_stiffness: 90 MN, mass: none, damping_time: 10 ms}
load:
  name: tank
  shape: {box: [8 m, 3 m, 4 m]}
  position: [0 m, 0 m, 1 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs: {W: {at: [-4 m, 0 m, 4 m], capacity: 40 t}, E: {at: [4 m, 0 m, 4 m], capacity: 40 t}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 13 m]
    rated_capacity: 60 t
    hoist: {speed: 6 m/min, acceleration: 0.02 m/s^2}
sling_defaults: {rope: sling}
slings:
  W: {from: hook, to: tank.W, length: 8.94 m}
  E: {from: hook, to: tank.E, length: 8.94 m}
plan:
  - {step: hold, hold: until_end}
rules:
  dynamic_amplification_factor: 1.1
  load_factor: 1.3
  consequence_factor: 1.3
  material_factor: 1.5
  termination_factor: 1.12
limits: {rule: yard, load_tilt: 2 deg}
"""


def _checks(lift: str) -> list[Check]:
    return check_recording(Statics(parse_scenario(lift)).equilibrium().recording)


def test_what_the_rules_ask_for_is_missed() -> None:
    checks = _checks(LIFT)
    (check,) = [one for one in checks if one.name == "rope_load_of_breaking_force"]
    assert check.verdict is Verdict.WARNING
    assert "factors on the breaking force of slings, and no sling is held against it" in check.remark
    assert "minimum breaking force not known" in check.remark
    assert outcome_of(checks) is Outcome.GO_WITH_WARNINGS


def test_slings_whose_bending_is_not_known_are_missed() -> None:
    """219 kN, static, over 300 kN."""
    checks = _checks(LIFT.replace("90 MN, mass", "90 MN, minimum_breaking_force: 300 kN, mass"))
    (check,) = [one for one in checks if one.name == "rope_load_of_breaking_force"]
    assert check.verdict is Verdict.WARNING and "no shackles given" in check.remark
    assert outcome_of(checks) is Outcome.GO_WITH_WARNINGS


def test_slings_that_are_known_are_in_order() -> None:
    """On a bow of 176 mm, D/d = 4, (K5) has the bending factor 1/(1 - 0.5/2) = 4/3, more than 1.12.

    The force of each by the slope of 4 m to 8 m up, times 1.1 x 1.3 x 1.3 x 1.5 x 4/3 of 1350 kN.
    """
    known = "90 MN, minimum_breaking_force: 1350 kN, diameter: 44 mm, mass"
    bow = "bow_diameter: 176 mm, pin_diameter: 80 mm"
    shackles = f"shackles:\n  wb: {{working_load_limit: 60 t, mass: 40 kg, {bow}}}\n"
    lift = LIFT.replace("90 MN, mass", known).replace("load:\n  name", f"{shackles}load:\n  name")
    lift = lift.replace("{rope: sling}", "{rope: sling, shackles: {top: wb, bottom: wb}}")
    (check,) = [one for one in _checks(lift) if one.name == "rope_load_of_breaking_force"]
    force = 40e3 * 9.81 / 2.0 * math.hypot(4.0, 8.0) / 8.0
    used = force * 1.1 * 1.3 * 1.3 * 1.5 * 4.0 / 3.0 / 1350e3
    assert check.value == pytest.approx(used, rel=1e-2) and check.verdict is Verdict.OK


def test_without_such_rules_nobody_asks() -> None:
    checks = _checks(LIFT.replace("  termination_factor: 1.12\n", ""))
    (check,) = [one for one in checks if one.name == "rope_load_of_breaking_force"]
    assert check.verdict is Verdict.NOT_CHECKED
