"""Fleet angles onto a drum of several ropes, and onto one of which all ropes are wound against the rest.

What such a drum has paid out is counted as `<drum>/against`; the drum itself has no rope, and no turns. With
a `first_sheave` its checks ended in a traceback, "drum_wraps has no 'winch'; it has winch/against". Of ropes
of two diameters side by side the one that the lift file names last counted, 1.43 deg of 20 mm beside 2.15 deg
of 30 mm.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.checks import Check
from gantline.scenario import parse_scenario
from of_recording import checks_of

TURNS, LAYER, AWAY = 6.0, 5.0, 1.2


def angles(*ropes: tuple[str, str]) -> list[Check]:
    """Of a drum at rest with ropes, each of a kind and `with` or `against` the rest."""
    bodies, routes = "", ""
    for number, (kind, wound) in enumerate(ropes):
        joint = "joint: {type: slider, axis: [0, 0, 1]}"
        bodies += f"    b{number}: {{at: [{number} m, 0 m, 0 m], {joint}, mass: 5 t}}\n"
        end = f"{{type: end, body: world, at: [{number} m, 0 m, 40 m], drum: winch, wound: {wound}}}"
        routes += f"    r{number}: {{rope: {kind}, length: as_routed, "
        routes += f"route: [{{type: end, body: b{number}}}, {end}]}}\n"
    recording = gantline.simulate(
        parse_scenario(f"""\
format: 1
lift: {{title: Ropes on one shaft}}
duration: 1 s
start: rest
ropes:
  thick: {{axial_stiffness: 36 MN, damping_time: 20 ms, diameter: 30 mm}}
  thin: {{axial_stiffness: 36 MN, damping_time: 20 ms, diameter: 20 mm}}
mechanics:
  bodies:
{bodies}  drums:
    winch: {{diameter: 0.8 m, rotating_mass: 1 t, layers: 2, wraps_per_layer: {LAYER},
      wraps_at_start: {TURNS}, first_sheave: {AWAY} m, drive: {{speed: 60 m/min, acceleration: 0.5 m/s^2}}}}
  ropes:
{routes}plan: [{{step: hold, hold: until_end}}]
""")
    )
    return checks_of(recording, "drum_fleet_angle")


def aside(diameter: float) -> float:
    """(WI7) at the start [rad]: one turn in the second layer, 1.5 turns from its middle."""
    return math.atan(abs(TURNS - LAYER - LAYER / 2) * diameter / AWAY)


def test_ropes_wound_against_alone_have_their_angle() -> None:
    [check] = angles(("thin", "against"))
    assert check.element == "winch/against"
    assert check.value == pytest.approx(aside(0.02), rel=1e-9)


@pytest.mark.parametrize("kinds", [("thick", "thin"), ("thin", "thick")])
def test_of_two_ropes_side_by_side_the_thicker_counts(kinds: tuple[str, str]) -> None:
    [check] = angles(*((kind, "with") for kind in kinds))
    assert check.value == pytest.approx(aside(0.03), rel=1e-9)
