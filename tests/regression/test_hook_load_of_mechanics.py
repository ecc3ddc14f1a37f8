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
from hung_by_mechanics import LIFT
from lift_text import spoiled
from of_recording import checks_of

G = 9.81
MODULE, BAR, HOOK_BLOCK = 60e3, 3e3, 2e3
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
    [found] = checks_of(rest.recording, "lug_load_of_capacity")
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
