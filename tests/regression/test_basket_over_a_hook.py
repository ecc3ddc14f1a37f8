"""A rope of `mechanics` that runs over a hook, as a basket does, was no hook load.

Of a hook that moves as told it was 0.0 kN without a word, and a GO; of one in falls a warning said that it
was left out. What ropes of `mechanics` weigh at a hook in falls was left out as well: a strop of 2 t gave
89 t of hook load for 90 t that hung there.
"""

from __future__ import annotations

import pytest

from gantline.checks import Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from lift_text import spoiled
from of_recording import checks_of

G = 9.7
HUNG, HOOK_BLOCK, PER_METRE = 60e3, 2e3, 50.0
LIFT = """\
format: 1
lift: {title: A basket over a hook}
duration: 1 s
ropes:
  heavy: {axial_stiffness: 200 MN, damping_time: 20 ms, mass: 50 kg/m, minimum_breaking_force: 3000 kN}
  thin: {axial_stiffness: 60 MN, damping_time: 20 ms, mass: none, diameter: 28 mm}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 16 m]
    rated_capacity: 60 t
    hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}
mechanics:
  bodies:
    hung:
      joint: {type: free, position: [0 m, 0 m, 3 m]}
      mass: 60 t
      inertia: {xx: 100 t m^2, yy: 100 t m^2, zz: 100 t m^2}
  ropes:
    basket:
      rope: heavy
      length: LENGTH
      route:
        - {type: end, body: hung, at: [-1 m, 0.2 m, 3 m]}
        - GUIDE
        - {type: end, body: hung, at: [1 m, 0.2 m, 3 m]}
plan:
  - {step: hold, hold: until_end}
simulation: {gravity: 9.7 m/s^2}
start: rest
"""
REEVED = spoiled(
    "    hoist: {",
    "    reeving: {ropes: 1, parts_each: 7, rope: thin, sheave_diameter: 0.6 m, upper_sheaves_at: 40 m}\n"
    "    block: {mass: 2 t, height: 2 m}\n"
    "    drum: {diameter: 1 m}\n"
    "    hoist: {",
    LIFT,
)
OVER = {
    "eye": ("21 m", "{type: eye, body: hook, at: [0 m, 0 m, -0.1 m]}"),
    "half turn": (
        "21.5 m",
        "{type: half_turn, body: hook, enter: [-0.4 m, 0 m, -0.1 m], leave: [0.4 m, 0 m, -0.1 m], "
        "bulge: [0, 0, 1], sheave_mass: 10 kg}",
    ),
    "sheave": (
        "21.5 m",
        "{type: sheave, body: hook, at: [0 m, 0 m, -0.1 m], axis: [0, 1, 0], diameter: 0.8 m, "
        "sheave_mass: 10 kg}",
    ),
}


def at_rest(text: str, guide: str) -> Recording:
    length, words = OVER[guide]
    changed = text.replace("LENGTH", length).replace("GUIDE", words)
    return Statics(parse_scenario(changed)).equilibrium().recording


@pytest.mark.parametrize("guide", OVER)
@pytest.mark.parametrize("text", [LIFT, REEVED], ids=["as told", "in falls"])
def test_a_rope_that_runs_over_a_hook_is_hook_load(text: str, guide: str) -> None:
    """All that hangs there: (60 t + 50 kg/m x its length) g, and at the falls the hook block too."""
    recording = at_rest(text, guide)
    length = float(OVER[guide][0].removesuffix(" m"))
    hangs = (HUNG + PER_METRE * length) * G
    assert recording.column("hook_load", "hook")[-1] == pytest.approx(hangs, rel=1e-8)
    hook_block = HOOK_BLOCK * G if text is REEVED else 0.0
    assert recording.column("hoist_load", "hook")[-1] == pytest.approx(hangs + hook_block, rel=1e-8)
    [found] = checks_of(recording, "hoist_load_of_rated_capacity")
    assert found.verdict is Verdict.FAILED  # 61 t on 60 t
    assert found.value == pytest.approx(hangs / (60e3 * G), rel=1e-8)


def test_a_rope_that_ends_at_a_hook_in_falls_weighs_there() -> None:
    """A strop with half of its 50 kg/m x 10 m on the hook, which nobody counted."""
    text = REEVED.replace("LENGTH", "10 m").replace("        - GUIDE\n", "")
    text = text.replace("{type: end, body: hung, at: [-1 m, 0.2 m, 3 m]}", "{type: end, body: hook}")
    text = text.replace("[1 m, 0.2 m, 3 m]", "[0 m, 0 m, 3 m]")
    recording = Statics(parse_scenario(text)).equilibrium().recording
    hangs = (HUNG + PER_METRE * 10.0) * G
    assert recording.column("hook_load", "hook")[-1] == pytest.approx(hangs, rel=1e-8)
    assert recording.column("hoist_load", "hook")[-1] == pytest.approx(hangs + HOOK_BLOCK * G, rel=1e-8)


def test_one_that_parts_pulls_no_more() -> None:
    """Cut at 0.5 s: what is lumped on the hook stays there, half of the rope."""
    length, words = OVER["half turn"]
    text = REEVED.replace("LENGTH", length).replace("GUIDE", words)
    text = text.replace("      rope: heavy\n", "      rope: heavy\n      cut_at: 0.5 s\n")
    recording = simulate(parse_scenario(text))
    load = recording.column("hook_load", "hook")
    assert load[0] == pytest.approx((HUNG + PER_METRE * 21.5) * G, rel=1e-6)
    assert load[-1] == pytest.approx(recording.rig.hooks[0].direct_weight, rel=1e-9)
