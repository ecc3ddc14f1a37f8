"""What hung in a hook by ropes and bodies of `mechanics` was no hook load.

A module on a spreader bar that `mechanics` says gave a hook load of 0.0 kN and a GO: nothing was
held against the rated capacity. With reeving its hoist load alone was right.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from lift_text import spoiled

G = 9.81
MODULE, BAR, HOOK_BLOCK = 60e3, 3e3, 2e3
LIFT = """\
format: 1
lift: {title: A module on a spreader bar}
duration: 40 s
ground: {level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, mass: none}
  thin: {axial_stiffness: 60 MN, damping_time: 20 ms, mass: none, diameter: 28 mm}
load:
  name: module
  shape: {box: [10 m, 3 m, 3 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 60 t, contingency: 1.05}
  centre_of_gravity: {at: [0.3 m, 0 m, 1.5 m]}
  stands_on: ground
  lugs:
    L1: {at: [-4 m, 0 m, 3 m], capacity: 80 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 16 m]
    rated_capacity: 60 t
    hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}
mechanics:
  bodies:
    bar:
      at: [0 m, 0 m, 9.1 m]
      joint: {type: free}
      mass: 3 t
      inertia: {xx: 0.1 t m^2, yy: 17.7 t m^2, zz: 17.7 t m^2}
  ropes:
    up_1: {rope: sling, length: 8 m, route: [{type: end, body: hook}, {type: end, body: bar, at: [-4 m, 0 m, 0.2 m]}]}
    up_2: {rope: sling, length: 8 m, route: [{type: end, body: bar, at: [4 m, 0 m, 0.2 m]}, {type: end, body: hook}]}
    down_1: {rope: sling, length: 6 m, route: [{type: end, body: bar, at: [-4 m, 0 m, -0.2 m]}, {type: end, body: module, at: [-4.3 m, 0 m, 1.5 m]}]}
    down_2: {rope: sling, length: 6 m, route: [{type: end, body: bar, at: [4 m, 0 m, -0.2 m]}, {type: end, body: module, at: [3.7 m, 0 m, 1.5 m]}]}
plan:
  - {step: hoist, hoist: hook, by: 2 m, speed: 3 m/min}
  - {step: hold, hold: until_end}
limits: {rule: yard}
"""  # noqa: E501
REEVED = spoiled(
    "    hoist: {",
    "    reeving: {ropes: 1, parts_each: 8, rope: thin, sheave_diameter: 0.6 m, upper_sheaves_at: 40 m}\n"
    "    block: {mass: 2 t, height: 2 m}\n"
    "    drum: {diameter: 1 m}\n"
    "    hoist: {",
    LIFT,
)


@pytest.mark.parametrize("text", [LIFT, REEVED], ids=["as told", "in falls"])
def test_ropes_of_mechanics_are_hook_load(text: str) -> None:
    """At rest (60 + 3) t g, whichever end of a rope is at the hook; in motion the mean of that."""
    rest = Statics(parse_scenario(text)).equilibrium().recording
    assert rest.column("hook_load", "hook")[-1] == pytest.approx((MODULE + BAR) * G, rel=1e-9)
    recording = gantline.simulate(parse_scenario(text))
    static = recording.metrics()["static_hook_load"]
    assert static == pytest.approx((MODULE + BAR) * G, rel=2e-3)  # of what still swings after 15 s


def test_a_crane_that_is_too_small_is_no_go() -> None:
    """(60 + 3) t x 1.05 on 60 t: 110.25 %; what hangs by ropes of `mechanics` is raised as a whole."""
    checks = check_recording(Statics(parse_scenario(LIFT)).equilibrium().recording)
    [found] = [one for one in checks if one.name == "hoist_load_of_rated_capacity"]
    assert found.verdict is Verdict.FAILED
    assert found.value == pytest.approx(63 * 1.05 / 60, rel=1e-9)


def test_what_holds_the_load_without_a_lug_is_not_checked_in_silence() -> None:
    """Only slings have lugs. A rope on which 200 kg hang below the load of 60 t bears nothing of it."""
    weight = "    weight: {at: [4.7 m, 0 m, 1.5 m], joint: {type: point}, mass: 200 kg}\n  ropes:\n"
    tail = "    tail: {rope: sling, length: 1 m, route: [{type: end, body: module, at: [4.4 m, 0 m, 1 m]}, "
    text = spoiled("  ropes:\n    up_1", f"{weight}{tail}{{type: end, body: weight}}]}}\n    up_1", LIFT)
    rest = Statics(parse_scenario(text)).equilibrium()
    assert rest.tension("tail") == pytest.approx(200 * G, rel=1e-9)
    [found] = [one for one in check_recording(rest.recording) if one.name == "lug_load_of_capacity"]
    assert (found.verdict, found.value) == (Verdict.NOT_CHECKED, None)
    assert found.remark == "carries module as a rope of 'mechanics', which has no lug: down_1, down_2"


@pytest.mark.parametrize("text", [LIFT, REEVED], ids=["as told", "in falls"])
def test_bodies_that_hang_in_a_hook_by_a_joint_are_hook_load(text: str) -> None:
    """The bar on a ball joint in place of its upper ropes, which hang slack beside it."""
    joined = spoiled(
        "      at: [0 m, 0 m, 9.1 m]\n      joint: {type: free}",
        "      parent: hook\n      at: [0 m, 0 m, -6.9 m]\n      joint: {type: ball}",
        text,
    )
    joined = "".join(line for line in joined.splitlines(keepends=True) if not line.startswith("    up_"))
    rest = Statics(parse_scenario(joined)).equilibrium().recording
    assert rest.column("hook_load", "hook")[-1] == pytest.approx((MODULE + BAR) * G, rel=1e-9)
