"""A spreader ten times as heavy as meant passed `gantline check` without a word.

A ring of 14 t, rated for 90 t, was written with 140 t: more than it may carry. Nor was an inertia
told that its box does not allow, as one of a load is.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: A shell below a ring}
duration: 5 s
ropes:
  sling: {axial_stiffness: 100 MN, mass: none}
load:
  name: shell
  shape: {box: [22 m, 22 m, 2.4 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 62 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.2 m]}
  lugs: {W: {at: [-11 m, 0 m, 2.4 m]}, E: {at: [11 m, 0 m, 2.4 m]}}
spreaders:
  ring:
    mass: 14 t
    size: [22 m, 22 m, 0.4 m]
    inertia: {xx: 850 t m^2, yy: 850 t m^2, zz: 1690 t m^2}
    rated_capacity: 90 t
    lugs:
      T1: {at: [-11 m, 0 m, 0.2 m]}
      T2: {at: [11 m, 0 m, 0.2 m]}
      B1: {at: [-11 m, 0 m, -0.2 m]}
      B2: {at: [11 m, 0 m, -0.2 m]}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 16.5 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
slings:
  U1: {from: hook, to: ring.T1, length: 15.6 m, rope: sling}
  U2: {from: hook, to: ring.T2, length: 15.6 m, rope: sling}
  D1: {from: ring.B1, to: shell.W, length: 3 m, rope: sling}
  D2: {from: ring.B2, to: shell.E, length: 3 m, rope: sling}
plan:
  - {step: hold, hold: until_end}
"""


def _told(text: str) -> list[str]:
    return [
        f"{one.path}: {one.sentence}"
        for one in assemble(parse_scenario(text)).doubts
        if "ring" in one.sentence
    ]


def test_the_ring_as_meant_is_in_order() -> None:
    """850 t m^2 of 14 t: a radius of 7.8 m; a hoop of 11 m has 11/sqrt(2) m = 7.8 m."""
    assert _told(LIFT) == []


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (
            "mass: 14 t",
            "mass: 140 t",
            "weighs 140 t and may carry 90 t; a unit or digit has slipped",
        ),
        # sqrt(62.5/14) = 2.11 m, and of a solid box of 22 m by 0.4 m 22/sqrt(12) = 6.35 m
        ("xx: 850 t m^2, yy: 850 t m^2", "xx: 1.7 t m^2, yy: 1690 t m^2", "xx 0.348 m (a solid box 6.35 m)"),
    ],
)
def test_a_slip_is_told(old: str, new: str, says: str) -> None:
    assert old in LIFT
    assert any(says in one for one in _told(LIFT.replace(old, new)))
