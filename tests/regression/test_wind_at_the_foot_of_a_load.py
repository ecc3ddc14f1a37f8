"""A column in wind that did not lean on its supports, since its wind area said nothing of where it is.

Of a load whose `wind_areas` have an `area` and no `at` wind pushes at the datum, the middle of its underside.
A column of 20 m that stands on four stools had 74 kN on each in a wind of 20 m/s, where 37 kN and 111 kN are
on those to windward and to lee. Nothing was said; of vessels it was.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.assembly import assemble

PLACE = ", at: [0 m, 0 m, 10 m]"
TEXT = """\
format: 1
lift: {title: A column stands in wind}
duration: 5 s
wind: {speed: 20 m/s, direction: 0 deg}
ropes: {sling: {axial_stiffness: 90 MN, damping_time: 10 ms, mass: none}}
load:
  name: column
  shape: {box: [3 m, 3 m, 20 m]}
  position: [0 m, 0 m, 0.5 m]
  weight: {calculated: 30 t}
  centre_of_gravity: {at: [0 m, 0 m, 10 m]}
  lugs: {A: {at: [1 m, 0 m, 20 m]}, B: {at: [-1 m, 0 m, 20 m]}}
  wind_areas: {side: {area: 60 m^2, coefficient: 1.2, along: xPLACE}}
supports:
  stools: {under: column, grid: {x: [-1.2 m, 1.2 m], y: [-1.2 m, 1.2 m]}, height: to_load,
    stiffness: 200 MN/m, friction: 0.4, top: [0.3 m, 0.3 m]}
cranes: {hook: {type: fixed_hook, at: [0 m, 0 m, 30 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}}
slings:
  A: {from: hook, to: column.A, length: 9.7 m, rope: sling}
  B: {from: hook, to: column.B, length: 9.7 m, rope: sling}
plan: [{step: hold, hold: until_end}]
"""


def told(text: str) -> list[str]:
    """Warnings of the lift file that name an area."""
    return [one for one in assemble(gantline.parse_scenario(text)).warnings if " area " in one]


def test_an_area_that_is_nowhere_is_told() -> None:
    """From the datum to the middle of a face are half of 20 m."""
    assert told(TEXT.replace("PLACE", "")) == [
        "the wind area side of column has no 'at', and pushes at the datum, 10.00 m from the middle of what "
        "the load shows: say where its middle is"
    ]


@pytest.mark.parametrize("place", [PLACE, ", at: [0 m, 0 m, 0 m]"])
def test_one_that_has_a_place_is_not(place: str) -> None:
    assert told(TEXT.replace("PLACE", place)) == []


def test_one_whose_datum_is_in_the_middle_is_not() -> None:
    """Nor one that says its size by the shape of the load, and so its middle."""
    assert told(TEXT.replace("area: 60 m^2, ", "").replace("PLACE", "")) == []


def test_a_column_leans_to_lee() -> None:
    """W/4 ∓ k a φ/2 on each of two stools to either side, a = 2.4 m apart, F = ½ ρ C A v² at h = 10 m.

    They give way by a φ/2 under F h + W h φ = k a² φ, with what the weight leans over.
    """
    recording = gantline.simulate(gantline.parse_scenario(TEXT.replace("PLACE", PLACE)))
    push, weight, height, apart, stiffness = 0.5 * 1.225 * 1.2 * 60.0 * 20.0**2, 30e3 * 9.81, 10.0, 2.4, 200e6
    lean = push * height / (stiffness * apart**2 - weight * height)
    for column, sign in ((1, -1.0), (2, 1.0)):
        force = float(recording.column("contact_force", f"support.stools.{column}.1")[-1])
        assert force == pytest.approx(weight / 4 + sign * stiffness * apart * lean / 2, rel=1e-4)
