"""Slings of two cranes to a beam were too short, and each was told to stand over the middle of the load.

A beam hangs in two hooks, 7 m apart, its load below it. "one stands 3.50 m beside the middle of its lugs" was
said of both, as if each of them alone bore the lugs below the beam: only their height was wrong.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from gantline.scenario.errors import StartError

LIFT = """\
format: 1
lift: {title: A beam in two hooks}
duration: 1 s
ropes:
  sling: {axial_stiffness: 500 MN, mass: none}
load:
  name: machine
  shape: {box: [3 m, 7 m, 2 m]}
  position: [0 m, 0 m, 3 m]
  weight: {calculated: 60 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {A: {at: [0 m, 2 m, 2 m]}, B: {at: [0 m, -2 m, 2 m]}}
spreaders:
  beam:
    mass: 3 t
    size: [0.4 m, 8 m, 0.4 m]
    lugs:
      T1: {at: [0 m, 3.5 m, 0.25 m]}
      T2: {at: [0 m, -3.5 m, 0.25 m]}
      B1: {at: [0 m, 2 m, -0.25 m]}
      B2: {at: [0 m, -2 m, -0.25 m]}
cranes:
  one: {type: fixed_hook, at: [0 m, 3.5 m, 10 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
  two: {type: fixed_hook, at: [0 m, -3.5 m, 10 m], hoist: {speed: 1 m/min, acceleration: 0.1 m/s^2}}
slings:
  T1: {from: one, to: beam.T1, length: 2 m, rope: sling}
  T2: {from: two, to: beam.T2, length: 2 m, rope: sling}
  B1: {from: beam.B1, to: machine.A, length: 2 m, rope: sling}
  B2: {from: beam.B2, to: machine.B, length: 2 m, rope: sling}
"""


def test_only_the_height_is_wrong() -> None:
    """Between lugs at 5 m and hooks at 10 m are 5 m; beam and slings have 0.5 m and 4 m."""
    with pytest.raises(StartError) as error:
        assemble(parse_scenario(LIFT))
    told = str(error.value)
    assert "from 'one' to 'beam.T1' it is 2.250 m at the start" in told
    assert "beside the middle of its lugs" not in told
