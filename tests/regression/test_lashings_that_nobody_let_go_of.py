"""A load that was hoisted against its own lashings was GO WITH WARNINGS, and the warnings said they carry it.

60 t went up by 50 mm on four slings with two lashings to the ground still on. They pulled it down with 80 kN,
hook and slings had so much more than its weight, and what was told was that lug and slings were not checked
because the lashings "carry box as ropes of 'mechanics'". What holds a load down from above, an edge or a
deck, has failed long since (`stays_clear`); where no limit asks for lugs or slings nothing was said at all.
"""

from __future__ import annotations

from math import hypot

import pytest

from gantline.checks import Verdict, check_recording
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

WEIGHT = 60e3 * 9.81
#: Axial stiffness of a lashing [N], its length, how far it reaches aside, and up while the load stands [m].
STIFFNESS, LENGTH, REACH, HEIGHT = 10e6, 2.01, 1.73, 1.0
SLINGS = """\
  S1: {from: hook, to: box.L1, length: 12 m}
  S2: {from: hook, to: box.L2, length: 12 m}
  S3: {from: hook, to: box.L3, length: 12 m}
  S4: {from: hook, to: box.L4, length: 12 m}
"""


def lift(
    lashings: str = "", drums: str = "", let_go: str = "", bodies: str = "", to: str = "world"
) -> Scenario:
    ropes = f"""\
  ropes:
    A: {{rope: lashing, length: {LENGTH} m, {lashings}
        route: [{{type: end, body: box, at: [4 m, 0 m, 0 m]}},
                {{type: end, body: {to}, at: [{4 + REACH} m, 0 m, 0 m]{drums and ", drum: A"}}}]}}
    B: {{rope: lashing, length: {LENGTH} m, {lashings}
        route: [{{type: end, body: box, at: [-4 m, 0 m, 0 m]}},
                {{type: end, body: {to}, at: [{-4 - REACH} m, 0 m, 0 m]{drums and ", drum: B"}}}]}}
"""
    return parse_scenario(f"""\
format: 1
lift: {{title: Lashings}}
duration: 60 s
ground: {{level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}}
ropes:
  sling: {{axial_stiffness: 90 MN, damping_time: 10 ms, minimum_breaking_force: 1500 kN, mass: none}}
  lashing: {{axial_stiffness: {STIFFNESS} N, damping_time: 20 ms, minimum_breaking_force: 600 kN, mass: none}}
load:
  name: box
  shape: {{box: [8 m, 6 m, 3 m]}}
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, {HEIGHT} m]}}
  stands_on: ground
  lugs:
    L1: {{at: [-3 m,  2 m, 3 m], capacity: 40 t}}
    L2: {{at: [ 3 m,  2 m, 3 m], capacity: 40 t}}
    L3: {{at: [ 3 m, -2 m, 3 m], capacity: 40 t}}
    L4: {{at: [-3 m, -2 m, 3 m], capacity: 40 t}}
cranes:
  hook:
    {{type: fixed_hook, at: [0 m, 0 m, 14.4 m], rated_capacity: 100 t,
      hoist: {{speed: 2 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
{SLINGS}mechanics:
{bodies}{drums}{ropes}plan:
  - {{step: lift off, hoist: hook, speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: clear, hoist: hook, speed: 1 m/min, by: 50 mm}}
  - {{step: hold, hold: until_end{let_go}}}
""")


def held(recording: Recording) -> float:
    """By hand, of two lashings at the height of the load's middle: 2 T sin, T = EA (l - L)/L [N]."""
    up = float(recording.column("body_position", "box")[-1, 2])
    way = hypot(REACH, up)
    return 2.0 * STIFFNESS * (way / LENGTH - 1.0) * up / way


def hangs(recording: Recording) -> float:
    return float(recording.column("hook_load", "hook")[-1])


def test_a_load_that_is_tied_down_is_no_go() -> None:
    run = simulate(lift())
    (found,) = checks_of(run, "let_go_below")
    assert (found.verdict, found.element) == (Verdict.FAILED, "box")
    # A hundredth: the hook load still rings by that.
    assert hangs(run) - WEIGHT == pytest.approx(held(run), rel=0.01)
    assert found.remark.startswith("tied to the world by A, B: that holds it down with ")
    assert "14 % of its weight, while it hangs" in found.remark


def test_so_it_is_at_rest() -> None:
    """An equilibrium has what is by hand to a newton, and the hook that and the weight."""
    rest = Statics(lift()).equilibrium().recording
    (found,) = checks_of(rest, "let_go_below")
    assert found.verdict is Verdict.FAILED
    assert hangs(rest) == pytest.approx(WEIGHT + held(rest), abs=1.0)
    assert f"with {held(rest) / 1e3:.1f} kN" in found.remark


def test_lashings_to_what_is_fixed_on_a_deck_are_told_too() -> None:
    """A grillage, a plain body that is fixed to the world here."""
    grillage = "  bodies:\n    grillage: {joint: {type: fixed}, mass: 1 t}\n"
    (found,) = checks_of(simulate(lift(bodies=grillage, to="grillage")), "let_go_below")
    assert found.remark.startswith("tied to grillage by A, B: that holds it down with ")


def test_what_pulls_down_is_not_said_to_carry() -> None:
    checks = check_recording(simulate(lift()))
    (lugs,) = [one for one in checks if one.name == "lug_load_of_capacity"]
    assert "pulls box down as a rope of 'mechanics', which has no lug: A, B" in lugs.remark


def test_lashings_that_are_let_go_of_hold_nothing() -> None:
    """Those that are cut, and those that break, as a rope does that stands for the mud below a foot."""
    assert not checks_of(simulate(lift(let_go=", cut: [A, B]")), "let_go_below")
    assert not checks_of(simulate(lift(lashings="breaks_at: 20 kN,")), "let_go_below")


def test_who_hauls_on_a_drum_means_it() -> None:
    drums = "".join(
        f"    {name}: {{diameter: 0.5 m, rotating_mass: 50 kg, "
        "drive: {speed: 5 m/min, acceleration: 0.1 m/s^2}}\n"
        for name in ("A", "B")
    )
    assert not checks_of(simulate(lift(drums=f"  drums:\n{drums}")), "let_go_below")
