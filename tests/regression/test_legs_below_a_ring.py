"""Four legs below one ring pulled at it by more than hangs there.

A suction anchor of 95 t, 99.75 t of design weight, hung in four legs, 28 deg from plumb, from the one lower
lug of a ring. `lug_load_of_capacity` and the table of `gantline export --lugs` added the sizes of the legs'
tensions: 1109 kN at rest, 978.5 kN of which hang there, and 1499 kN in a wave that the sling above the ring
felt with 1331 kN: 101.9 % of the lug's 150 t, NO-GO. The pull along z, for those who design the ring, was
that much too.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import check_recording
from gantline.checks.lug_figures import lug_figures
from gantline.scenario import parse_scenario
from gantline.statics import Statics

MASS, CONTINGENCY, G = 95e3, 1.05, 9.81
ASIDE, LEG, EA = 2.0, 6.0, 180e6
LIFT = f"""\
format: 1
lift: {{title: Four legs below a ring}}
duration: 5 s
ropes:
  leg: {{axial_stiffness: {EA / 1e6} MN, mass: none}}
load:
  name: anchor
  shape: {{box: [5.5 m, 5.5 m, 9 m]}}
  position: [0 m, 0 m, 3 m]
  weight: {{calculated: {MASS / 1e3} t, contingency: {CONTINGENCY}}}
  centre_of_gravity: {{at: [0 m, 0 m, 5 m]}}
  lugs:
    a: {{at: [ 2 m,  2 m, 9 m]}}
    b: {{at: [-2 m,  2 m, 9 m]}}
    c: {{at: [-2 m, -2 m, 9 m]}}
    d: {{at: [ 2 m, -2 m, 9 m]}}
spreaders:
  ring:
    mass: 0.5 t
    size: [0.5 m, 0.5 m, 0.3 m]
    lugs: {{T: {{at: [0 m, 0 m, 0.15 m]}}, B: {{at: [0 m, 0 m, -0.15 m], capacity: 150 t}}}}
cranes:
  crane: {{type: fixed_hook, at: [0 m, 0 m, 22.6 m], hoist: {{speed: 3 m/min, acceleration: 0.05 m/s^2}}}}
slings:
  soft: {{from: crane, to: ring.T, length: 5 m, rope: leg}}
  a: {{from: ring.B, to: anchor.a, length: {LEG} m, rope: leg}}
  b: {{from: ring.B, to: anchor.b, length: {LEG} m, rope: leg}}
  c: {{from: ring.B, to: anchor.c, length: {LEG} m, rope: leg}}
  d: {{from: ring.B, to: anchor.d, length: {LEG} m, rope: leg}}
plan:
  - {{step: hold, hold: until_end}}
limits: {{rule: yard, load_tilt: 5 deg}}
"""
HANGS = MASS * CONTINGENCY * G


def test_a_ring_is_pulled_by_what_hangs_below_it() -> None:
    rest = Statics(parse_scenario(LIFT)).equilibrium()
    legs = [rest.tension(f"sling.{name}") for name in "abcd"]
    sideways = math.hypot(ASIDE, ASIDE)
    stretched = LEG * (1.0 + MASS * G / (4.0 * EA * math.cos(math.asin(sideways / LEG))))
    assert sum(legs) * math.cos(math.asin(sideways / stretched)) == pytest.approx(MASS * G, rel=1e-5)

    (used,) = [check for check in check_recording(rest.recording) if check.name == "lug_load_of_capacity"]
    assert used.element == "ring.B"
    assert used.value == pytest.approx(HANGS / (150e3 * G), rel=1e-6)
    (ring,) = [one for one in lug_figures(rest.recording) if one.lug == "ring.B"]
    assert ring.force == pytest.approx(HANGS, rel=1e-6)
    assert ring.pull == pytest.approx((0.0, 0.0, -HANGS), rel=1e-6, abs=1.0)
    assert ring.text.endswith(" as vectors")


def test_slings_far_apart_pull_no_less_than_one_of_them() -> None:
    """Two slings at 75 deg from plumb, from one lug: their sum is half of each, and each pulls at the lug."""
    aside = 6.0 * math.sin(math.radians(75.0))
    text = LIFT
    for name in "bd":
        text = text.replace(
            f"  {name}: {{from: ring.B, to: anchor.{name}, length: {LEG} m, rope: leg}}\n", ""
        )
    for name, sign in (("a", 1), ("c", -1)):
        at = next(line for line in text.splitlines() if line.startswith(f"    {name}: {{at:"))
        text = text.replace(at, f"    {name}: {{at: [{sign * aside} m, 0 m, 9 m]}}")
    text = text.replace("[5.5 m, 5.5 m, 9 m]", "[12 m, 5.5 m, 9 m]").replace("22.6 m", "18.8 m")
    rest = Statics(parse_scenario(text)).equilibrium()
    one = CONTINGENCY * rest.tension("sling.a")
    assert one > HANGS
    (ring,) = [found for found in lug_figures(rest.recording) if found.lug == "ring.B"]
    assert ring.force == pytest.approx(one, rel=1e-6)
