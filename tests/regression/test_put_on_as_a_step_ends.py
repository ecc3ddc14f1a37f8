"""What a step requires of slings, where the next step puts others on.

A step ends as the next begins, and the sample there had the slings of both: one that the next step puts on,
slack as it goes on, failed what the step before required of every sling, or of the spread of an equalizer. At
rest the same step was ok.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict, check_recording
from gantline.checks.check import Check
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from hooked_lift import hooked_lift
from mechanics import G

MASS, STIFFNESS = 200e3, 200e6
#: Both hang from one hook 10 m above the lugs: A1 and A2 nearly plumb, B1 with 1 m of slack.
HOOKS = {"A": (0.0, 0.0, 20.0)}
LUGS = {"1": (-1.0, 0.0, 4.0), "2": (1.0, 0.0, 4.0), "3": (0.0, 0.0, 4.0)}
SLINGS = {"A1": ("A", "1", 10.0), "A2": ("A", "2", 10.0), "B1": ("A", "3", 11.0)}
PLAN = """\
plan:
  - {step: look, hold: HELD s, require: {sling_tension: above 900 kN}}
  - {step: on,   hold: 5 s, attach: sling.B1, REQUIRED}
simulation: {sample_interval: 0.5 s}
"""
LATER = "require: {sling_tension: above 900 kN}"


def lift(held: float, required: str = "report: [sling_tension]") -> Scenario:
    more = PLAN.replace("HELD", str(held)).replace("REQUIRED", required)
    text = hooked_lift(HOOKS, LUGS, SLINGS, mass=MASS, position=(0.0, 0.0, 6.0), more=more)
    lasting = text.replace("duration: 10 s", f"duration: {held + 5.0} s")
    return parse_scenario(lasting.replace("as_given", "rest"))


def required(scenario: Scenario) -> dict[str | None, Check]:
    checks = check_recording(Simulation(scenario).run())
    return {one.step: one for one in checks if one.name == "sling_tension"}


@pytest.mark.parametrize("held", [5.0, 5.2])
def test_a_sling_that_the_next_step_puts_on_is_not_asked(held: float) -> None:
    """m g/2 in each of both, and a little more since they are not plumb: at a sample, and between two."""
    check = required(lift(held))["look"]
    assert check.verdict is Verdict.OK and check.element in ("A1", "A2")
    assert check.value == pytest.approx(MASS * G / 2, rel=0.01)


def test_it_is_asked_from_then_on() -> None:
    check = required(lift(5.0, LATER))["on"]
    assert check.verdict is Verdict.FAILED and check.element == "B1" and check.value == 0.0


def test_at_rest_it_is_the_same() -> None:
    rest = Statics(lift(5.0)).equilibrium(5.0)
    (check,) = (one for one in check_recording(rest.recording, ["look"]) if one.name == "sling_tension")
    assert check.verdict is Verdict.OK
