"""`to: 42 m` of a hook counted from where the boom head was at the start.

A drum stands on the boom head and goes up and down with it. A plan that luffed a boom of 110 m from 60 to 55
degrees and then hoisted its hook to 42 m had it at 36.8 m, without a word; and hoisting it to 36 m, from the
34.8 m at which it then hung, was refused as a step down.
"""

from __future__ import annotations

import math

import pytest

from boom_lift import TACKLES, boom_lift
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics

LUFF = "{step: out, luff: fc, speed: 30 deg/min, to: 55 deg}"
#: How far the head of 110 m comes down from 60 to 55 deg [m].
SUNK = 110.0 * (math.sin(math.radians(60.0)) - math.sin(math.radians(55.0)))


def plan(*steps: str) -> str:
    return "\n".join((*steps, "{step: end, hold: until_end}"))


@pytest.mark.parametrize(
    "steps",
    [
        (LUFF, "{step: up, hoist: H1, speed: 3 m/min, to: 42 m}"),
        ("{step: up, hoist: H1, speed: 3 m/min, to: 42 m}", f"{LUFF[:-1]}, starts: with_previous}}"),
    ],
)
def test_a_hook_comes_to_its_height_under_a_boom_that_has_luffed(steps: tuple[str, str]) -> None:
    """At rest, after the boom and beside it: 42 m, on rope that stretches by 11 ppm of 60 m."""
    rest = Statics(parse_scenario(boom_lift(plan(*steps), duration=300.0))).equilibrium().recording
    assert rest.column("hook_height", "fc.H1")[-1] == pytest.approx(42.0, abs=1e-3)


def test_in_tackles_that_stretch() -> None:
    """The angle is that of the drum but for what tackles stretch: a mrad or two on 110 m."""
    steps = LUFF, "{step: up, hoist: H1, speed: 3 m/min, to: 42 m}"
    lift = boom_lift(plan(*steps), duration=300.0, luffing=TACKLES)
    rest = Statics(parse_scenario(lift)).equilibrium().recording
    above = 55.0 - math.degrees(rest.column("boom_angle", "fc")[-1])
    lower = 110.0 * (math.sin(math.radians(55.0)) - math.sin(math.radians(55.0 - above)))
    assert 0.0 < lower < 0.3
    assert rest.column("hook_height", "fc.H1")[-1] == pytest.approx(42.0 - lower, abs=2e-3)


def test_a_program_sees_the_hook_go_with_its_boom() -> None:
    """Height and speed of a hook that a program hoists while the plan luffs: as its body's, but for swing."""
    run = Simulation(parse_scenario(boom_lift(plan(LUFF), duration=12.0)))
    begin, body = run.drive_state("H1", motion="hoist")[0], run.now("body_position", "fc.H1")[2]
    run.command("H1", speed=0.04, motion="hoist")
    run.advance_to(8.0)
    height, speed = run.drive_state("H1", motion="hoist")
    moved = run.now("body_position", "fc.H1")[2] - body
    assert begin == 40.0
    assert height - begin < -1.0
    # Falls of 60 m trail a head that sets off with 0.083 m/s^2 by up to 2 a/g, 17 mrad: 9 mm up.
    assert height - begin == pytest.approx(moved, abs=1e-2)
    assert speed == pytest.approx(run.now("body_velocity", "fc.H1")[2], rel=2e-2)


def test_the_plan_knows_which_way_the_hook_goes() -> None:
    """34.8 m after luffing: 36 m is up, and no way down."""
    assert pytest.approx(34.84, abs=0.01) == 40.0 - SUNK
    parse_scenario(boom_lift(plan(LUFF, "{step: up, hoist: H1, speed: 3 m/min, to: 36 m}")))
    with pytest.raises(ScenarioError, match=r"the hook is at 34\.8\S* m or lower"):
        parse_scenario(boom_lift(plan(LUFF, "{step: down, lower: H1, speed: 3 m/min, to: 36 m}")))


def test_an_angle_that_nobody_knows_is_told() -> None:
    """A boom that luffs until something holds: the height counts from its last angle, and that is told."""
    luff = "{step: out, luff: fc, speed: 30 deg/min, until: {hoist_load: {hook: fc.H1, above: 2000 kN}}}"
    steps = plan(luff, "{step: up, hoist: H1, speed: 3 m/min, to: 42 m}")
    (warning,) = Simulation(parse_scenario(boom_lift(steps, duration=1.0))).run().attributes["warnings"][:1]
    told = "plan[2].to: step 'up' takes fc.H1 to 42.00 m as if fc.boom stood at 60.0 deg; it has luffed"
    assert warning.partition(": ")[2].startswith(told)
