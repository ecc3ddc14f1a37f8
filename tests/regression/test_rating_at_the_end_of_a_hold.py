"""How much of a chart a load uses at a hold point, where the plan goes on after it.

The sample at the end of a hold was not one of the time that the load hung still, since the next step begins
to move there. So contingency and the rule's factor were left out: a girder of 84 t at two crawler cranes used
61.3 % at its hold point and 70.3 % at the end of the lift, at the same radius, and a step that required
`hoist_load_of_rating: below 65 %` was in order. The end of a luff between two other motions had neither.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.checks.readings import hold_points, hook_readings
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from girder_and_crawler import HOOK_BLOCK, LOAD, RATED, girder_lift

G = 9.81
#: Contingency, and the factor of the rule.
CONTINGENCY, DYNAMIC = 1.1, 1.2

REST = """\
rules: {dynamic_amplification_factor: 1.2}
plan:
  - {step: hang, hold: 20 s}
  - {step: hold point, hold: 20 s, require: {hoist_load_of_rating: below 50 %}}
  - {step: luff, luff: crane, speed: 3 deg/min, by: 0.2 deg, require: {hoist_load_of_rating: below 50 %}}
  - {step: hoist, hoist: crane.H, speed: 4 m/min, by: 1 m}
  - {step: hold, hold: until_end}
"""

WEIGHT = "calculated: 40 t, contingency: 1.1, simulate: calculated"
LIFT = girder_lift("A load that hangs still on its way up", 80, REST, WEIGHT)


@pytest.fixture(scope="module")
def lift() -> Recording:
    return gantline.simulate(parse_scenario(LIFT))


def by_rule() -> float:
    """Load with contingency and factor, hook block as it is, over what is rated [1]."""
    return (LOAD * CONTINGENCY * DYNAMIC + HOOK_BLOCK) / RATED


def test_a_hold_point_has_contingency_and_factor(lift: Recording) -> None:
    used = {
        point.step.step: reading.used
        for point in hold_points(lift)
        for reading in hook_readings(lift, point.at)
        if reading.name == "crane.H"
    }
    assert used["hold point"] == pytest.approx(by_rule(), rel=1e-3)
    assert used["hold"] == pytest.approx(by_rule(), rel=1e-3)


@pytest.mark.parametrize("step", ["hold point", "luff"])
def test_a_step_that_requires_a_share_of_the_chart_has_them(lift: Recording, step: str) -> None:
    (check,) = (one for one in check_recording(lift) if one.step == step)
    assert check.value == pytest.approx(by_rule(), rel=1e-3)
    # As simulated it is 42 %: load and hook block alone.
    assert (LOAD + HOOK_BLOCK) / RATED < 0.5 < by_rule()
    assert check.verdict is Verdict.FAILED


@pytest.mark.parametrize(("rated", "used"), [(RATED, CONTINGENCY * DYNAMIC * LOAD / RATED), (0.0, None)])
def test_a_chart_for_what_hangs_in_the_hook(lift: Recording, rated: float, used: float | None) -> None:
    """Without hook block and falls; where the chart has nothing, nothing may hang, whichever the factors."""
    rig = lift.attributes["rig"]
    chart = {**rig["rating_charts"][0], "includes_hook_block": False, "rated": [rated * G, rated * G]}
    attributes = {**lift.attributes, "rig": {**rig, "rating_charts": [chart]}}
    changed = Recording(lift.variables, lift.coordinates, attributes)
    (check,) = (one for one in check_recording(changed) if one.step == "hold point")
    assert check.verdict is Verdict.FAILED
    assert check.value == (used and pytest.approx(used, rel=1e-3))
    if used is None:
        still = "nothing may hang where the load hangs still"
        assert check.remark.startswith(still) and "nothing may hang at 14.00 m" in check.remark


def test_two_cranes_that_lift_together_have_them_too() -> None:
    """Each has half of the girder by a sling of its own, plumb above its lug; as simulated that is 22 %."""
    crane = LIFT[LIFT.index("  crane:\n") : LIFT.index("slings:\n")]
    first, second = (
        crane.replace("crane:", f"{name}:").replace("[0 m, 0 m]", f"[{x} m, 0 m]")
        for name, x in (("west", -4), ("east", 4))
    )
    plan = "plan:\n  - {step: hold point, hold: 20 s, require: {hoist_load_of_rating: below 25 %}}\n"
    slings = "".join(
        f"  {lug}: {{from: {name}.H, to: girder.{lug}, length: {(6.4**2 - 16) ** 0.5} m, rope: sling}}\n"
        for lug, name in (("W", "west"), ("E", "east"))
    )
    text = LIFT.replace(crane, first + second)
    text = (
        text[: text.index("slings:\n")]
        + f"slings:\n{slings}"
        + text[text.index("rules:") : text.index("plan:")]
    )
    text += plan + "  - {step: hoist, hoist: [west.H, east.H], speed: 4 m/min, by: 1 m}\n"
    checks = check_recording(gantline.simulate(parse_scenario(text), duration=45.0))
    (check,) = (one for one in checks if one.step == "hold point")
    assert check.value == pytest.approx((LOAD / 2 * CONTINGENCY * DYNAMIC + HOOK_BLOCK) / RATED, rel=1e-3)
    assert check.verdict is Verdict.FAILED
