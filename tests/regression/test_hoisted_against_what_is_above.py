"""A load that is hoisted against beams above it was GO WITH WARNINGS, at four times its weight.

50 t with a gap of 1 m to two beams went up by 1.2 m: hooks pulled with 2.1 MN for 491 kN, the metric of the
load transferred was 100 %, and nothing but the capacities of the gear could tell it. Where these were large
enough there was one warning, `stays_clear`: "it meets what is in its way, see wind, tag lines and how it
swings". Below one beam alone the load was told to heel over "on what it stands on in place of coming clear",
with a centre of gravity 6 m too high.
"""

from __future__ import annotations

from math import hypot

import pytest

from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from of_recording import checks_of

WEIGHT = 50e3 * 9.81
#: Axial stiffness of a sling [N], its length, and how far its lug is aside of the hook [m].
STIFFNESS, LENGTH, ASIDE = 60e6, 11.2, 1.5
#: Height of the lugs under the beams and of the hook at the end [m].
LUGS, HOOK = 4.0, 15.3


def lift(*beams: str, to: float = HOOK) -> Scenario:
    structures = "".join(
        f"  {name}: {{type: box, x: {x}, y: [-3 m, 3 m], z: [{LUGS} m, 5 m]}}\n"
        for name, x in (("fore", "[2.5 m, 6 m]"), ("aft", "[-6 m, -2.5 m]"))
        if name in beams
    )
    return parse_scenario(f"""\
format: 1
lift: {{title: Below beams}}
duration: 60 s
ground: {{level: 0 m, stiffness: 200 MN/m, damping: 2 MN s/m, friction: 0.4}}
{f"structures:{chr(10)}{structures}" if beams else ""}
ropes:
  sling: {{axial_stiffness: {STIFFNESS} N, damping_time: 20 ms, minimum_breaking_force: 9 MN, mass: none}}
load:
  name: cube
  shape: {{box: [6 m, 3 m, 3 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 50 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs:
    A: {{at: [-{ASIDE} m, 0 m, 3 m], capacity: 500 t}}
    B: {{at: [{ASIDE} m, 0 m, 3 m], capacity: 500 t}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 14 m], rated_capacity: 500 t,
    hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
slings:
  A: {{from: hook, to: cube.A, rope: sling, length: {LENGTH} m}}
  B: {{from: hook, to: cube.B, rope: sling, length: {LENGTH} m}}
plan:
  - {{step: up, hoist: hook, speed: 3 m/min, to: {to} m}}
  - {{step: look, hold: until_end}}
limits: {{hoist_load_of_rated_capacity: 100 %, sling_factor_on_breaking_force: 3}}
""")


def told(recording: Recording) -> Check:
    (found,) = checks_of(recording, "stays_clear")
    return found


def test_between_two_beams() -> None:
    """T = EA (l - L)/L, l the way from hook to lug; what the slings lift beyond its weight holds it down."""
    high = HOOK - LUGS
    way = hypot(high, ASIDE)
    held = 2.0 * STIFFNESS * (way / LENGTH - 1.0) * high / way - WEIGHT
    run = simulate(lift("fore", "aft"))
    found = told(run)
    assert (found.verdict, found.element) == (Verdict.FAILED, "cube")
    # Eight places give by 1 mm together, of 0.15 m that the slings stretch beyond what the load does.
    assert -run.column("load_borne", "cube")[-1] == pytest.approx(held, rel=0.01)
    assert "in 'up': that holds it down with" in found.remark
    assert checks_of(run, "hangs_stably") == []


def test_at_rest() -> None:
    found = told(Statics(lift("fore", "aft")).equilibrium(60.0).recording)
    assert (found.verdict, found.element, found.time) == (Verdict.FAILED, "cube", None)


def test_below_one_beam() -> None:
    """It is no load that heels over on what it stands on."""
    run = simulate(lift("fore"))
    assert told(run).verdict is Verdict.FAILED
    assert checks_of(run, "hangs_stably") == []


@pytest.mark.parametrize("beams", [(), ("fore", "aft")], ids=["none", "not reached"])
def test_what_hangs_clear(beams: tuple[str, ...]) -> None:
    run = simulate(lift(*beams, to=14.9))
    assert checks_of(run, "stays_clear") == []
