"""A load that begins under a compensator was to have a lower hook, which is where the rod is not yet out.

The hook stands where the load hangs, with the rod out by 2.5 m of its weight. Where the file says nothing the
rod begins in, five slings were too short by as much, and each was told "lower the hook or make the sling
longer", neither of which was wrong. `out_at_start` is what was missing.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.assembly import assemble

LIFT = """
format: 1
lift: {title: A load hangs under a compensator}
duration: 20 s
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, minimum_breaking_force: 3 MN}
load:
  name: box
  shape: {box: [4 m, 2 m, 2 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 100 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {A: {at: [0 m, 0 m, 2 m]}}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 16.4 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
compensators:
  PHC:
    length: 5 m
    stroke: 3 m
    cylinder: {mass: 7 t, length: 4.4 m, diameter: 0.7 m}
    rod: {mass: 2 t, diameter: 0.28 m}
    pull: {rod_in: 750 kN, rod_out: 1200 kN}
    gas_exponent: 1.2
slings:
  G: {from: hook, to: PHC, length: 2 m, rope: sling}
  A: {from: PHC, to: box.A, length: 5 m, rope: sling}
plan:
  - {step: hang, hold: until_end}
"""


def test_the_rod_is_named() -> None:
    """It is 14.4 m from hook to lug, and both slings and the compensator with its rod in are 12 m."""
    with pytest.raises(gantline.ScenarioError) as refused:
        assemble(gantline.parse_scenario(LIFT))
    told = str(refused.value)
    assert "make the sling longer, or have the rod out where the lift begins, by 'out_at_start'" in told
    out = LIFT.replace("stroke: 3 m", "stroke: 3 m\n    out_at_start: 2.4 m")
    assemble(gantline.parse_scenario(out))
