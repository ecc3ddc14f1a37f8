"""In wind a box below one hook was told to tilt "as if hung at 0.00 m", by 89.91 degrees per 100 mm.

A load below one hook turns about plumb with nothing to hold it. In wind it hangs a little aside, so a centre
of gravity that is off turns it, and without end; the answer of statics to that is no more than a direction.
How the load tilts was taken from it all the same: a stiffness of 64 N m/rad and one of -135 N m/rad, of
5.2 and 4.2 MN m/rad in calm air.
"""

from __future__ import annotations

import pytest

from gantline.cli.tilting import tilting_lines
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study.tilting import Tilting, tilting_of, untold

#: Of the hook and of the centre of gravity [m], and its weight [N].
HOOK, CENTRE, WEIGHT = 20.0, 6.5, 40e3 * 9.81

_LIFT = """\
format: 1
lift: {title: A box below one hook}
duration: 60 s
ground: {level: 0 m}
WIND
ropes:
  sling: {axial_stiffness: 60 GN, damping_time: 20 ms, mass: none}
load:
  name: box
  shape: {box: [12 m, 4 m, 3 m]}
  position: [0 m, 0 m, 5 m]
  heading: 85 deg
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  lugs: {A: {at: [-5 m, 1 m, 3 m]}, B: {at: [-5 m, -1 m, 3 m]}, C: {at: [5 m, 1 m, 3 m]},
    D: {at: [5 m, -1 m, 3 m]}}
  wind_areas: {ends: {along: x, coefficient: 1.3}, sides: {along: y, coefficient: 1.2}}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 20 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
sling_defaults: {rope: sling, length: 13.05 m}
slings:
  A: {from: hook, to: box.A}
  B: {from: hook, to: box.B}
  C: {from: hook, to: box.C}
  D: {from: hook, to: box.D}
plan:
  - {step: hold, hold: 20 s}
"""


def asked(wind: str) -> tuple[list[Tilting], list[str]]:
    """What is known of how it tilts, and the loads of which nothing is."""
    question = Statics(parse_scenario(_LIFT.replace("WIND", wind)))
    rest = question.equilibrium()
    found = tilting_of(question, rest, question.modes())
    return found, untold(rest, found)


def test_in_wind_it_is_not_told() -> None:
    found, names = asked("wind: {speed: 15 m/s, direction: 40 deg}")
    assert (found, names) == ([], ["box"])
    (line,) = tilting_lines(found, [], names)
    assert line.startswith("How box tilts is not told: ")


def test_in_calm_air_it_is() -> None:
    """Load and slings tilt as one body about the hook: K = W h, h from the hook to the centre of gravity."""
    (found,), names = asked("wind: none")
    # Slings stretch by 2e-6 of 13 m, and were 0.05 m slack: h is what hangs so, at most 0.1 m more.
    assert names == []
    for axis in (found.soft, found.stiff):
        assert axis.height == pytest.approx(HOOK - CENTRE, abs=0.1)
        assert axis.stiffness == pytest.approx(axis.height * WEIGHT, rel=1e-9)
