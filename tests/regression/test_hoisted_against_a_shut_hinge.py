"""A load hoisted against a hinge that nobody had opened was GO WITH WARNINGS, at three times its weight.

60 t stood upright over their foot pin, and their hook was hoisted by 0.2 m. The load could not follow:
slings stretched, the hook pulled with 1.8 MN, and the hinge held the load down with 1.2 MN, twice its weight.
A table said so and no check did; what was warned of was that no static forces are known.
"""

from __future__ import annotations

from collections.abc import Callable
from math import hypot

import pytest

from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

WEIGHT = 60e3 * 9.81
STIFFNESS, LENGTH = 60e6, 10.0
#: Height of the post, where its lugs are beside its middle, and height of the hook at the start [m].
HEIGHT, ASIDE, HOOK = 12.0, 1.0, 21.9


def lift(up: float, lugs: float = HEIGHT) -> Scenario:
    return parse_scenario(f"""\
format: 1
lift: {{title: A hinge that nobody opens}}
duration: 40 s
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes:
  sling: {{axial_stiffness: {STIFFNESS} N, damping_time: 10 ms, minimum_breaking_force: 3500 kN, mass: none}}
load:
  name: post
  shape: {{box: [3 m, 3 m, {HEIGHT} m]}}
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 5 m]}}
  stands_on: ground
  lugs:
    A: {{at: [-{ASIDE} m, 0 m, {lugs} m], capacity: 200 t}}
    B: {{at: [{ASIDE} m, 0 m, {lugs} m], capacity: 200 t}}
hinges:
  foot: {{at: [0 m, 0 m, 0 m], axis: [0, 1, 0], held_by: world}}
cranes:
  hook:
    {{type: fixed_hook, at: [0 m, 0 m, {HOOK - HEIGHT + lugs} m], rated_capacity: 200 t,
      hoist: {{speed: 2 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling, length: {LENGTH} m}}
slings:
  A: {{from: hook, to: post.A}}
  B: {{from: hook, to: post.B}}
plan:
  - {{step: up, hoist: hook, speed: 1 m/min, by: {up} m}}
  - {{step: hold, hold: until_end}}
""")


def held(up: float) -> float:
    """By hand: what two slings pull upwards, T = EA (l - L)/L each, less the weight [N]."""
    high = HOOK + up - HEIGHT
    way = hypot(high, ASIDE)
    return 2.0 * STIFFNESS * (way / LENGTH - 1.0) * high / way - WEIGHT


def run_of(one: Scenario) -> Recording:
    return simulate(one)


def rest_of(one: Scenario) -> Recording:
    return Statics(one).equilibrium().recording


@pytest.mark.parametrize("found_by", [run_of, rest_of])
def test_a_load_that_its_hinge_holds_down_is_no_go(found_by: Callable[[Scenario], Recording]) -> None:
    (found,) = checks_of(found_by(lift(0.2)), "let_go_below")
    assert (found.verdict, found.element) == (Verdict.FAILED, "post")
    # The ground pushes no more, and pins are rigid: all that slings stretch is known.
    assert f"foot is shut and holds it down with {held(0.2) / 1e3:.1f} kN, 203 % of" in found.remark


def test_a_hundredth_of_the_weight_is_let_be() -> None:
    assert 0.0 < held(0.1) < 0.02 * WEIGHT
    assert not checks_of(run_of(lift(0.1)), "let_go_below")


def test_what_is_lifted_below_its_centre_of_gravity_needs_to_be_held_down() -> None:
    """Lugs nearer to the hinge than the centre of gravity: nothing is said of what such a lift takes."""
    assert not checks_of(rest_of(lift(0.2, lugs=4.0)), "let_go_below")
