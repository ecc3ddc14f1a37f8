"""`gantline statics` named bounds with all sheaves slipping, and showed them of slings alone.

"losses of 3 sheaves left out; bounds: all slip along the rope, all against" stood over the table of a hook
on a tackle, whose rope then had one tension, 26.2 kN. The rope over the sheaves, which is what losses load,
had no column: its lead line pulls with 27.8 kN where the hook goes up, and its dead end with 27.0 kN where it
goes down.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from program import called

LOSS, PARTS = 1 / 0.97, 3
LIFT = """\
format: 1
lift: {title: A load on three parts}
duration: 10 s
ropes:
  sling: {axial_stiffness: 50 MN, damping_time: 10 ms, mass: none, minimum_breaking_force: 700 kN}
  hoist: {axial_stiffness: 30 MN, damping_time: 10 ms, mass: none, minimum_breaking_force: 400 kN}
load:
  name: pump
  shape: {box: [2 m, 2 m, 2 m]}
  position: [0 m, 0 m, 10 m]
  weight: {calculated: 3 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs: {L1: {at: [0 m, 0 m, 2 m], capacity: 5 t}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 15 m]
    rated_capacity: 20 t
    block: {mass: 5 t, height: 2.0 m}
    reeving: {ropes: 1, parts_each: 3, rope: hoist, sheave_diameter: 0.5 m, upper_sheaves_at: 30 m,
      sheaves: {efficiency: 0.97, rotating_mass: 20 kg}}
    drum: {diameter: 0.6 m, moment_of_inertia: 100 kg m^2}
    hoist: {speed: 12 m/min, acceleration: 0.1 m/s^2}
slings: {S1: {from: hook, to: pump.L1, length: 3 m, rope: sling}}
plan: [{step: hold, hold: until_end}]
limits: {rule: yard, load_tilt: 1 deg}
"""


def test_the_rope_has_its_bounds(tmp_path: Path) -> None:
    """Raising (WI5) of docs/concepts/winch.md; lowering the dead end has W/(1 + 1/K + 1/K^2)."""
    lift = tmp_path / "lift.yaml"
    lift.write_text(LIFT, encoding="utf-8")
    said = called("statics", lift).stdout
    head = re.search(r"^Rope +tension +slip along +slip against$", said, re.MULTILINE)
    assert head is not None, said
    row = re.search(r"^ +hoist\.hook\.1 +([\d.]+) kN +([\d.]+) kN +([\d.]+) kN$", said, re.MULTILINE)
    assert row is not None, said
    weight = 8e3 * 9.81e-3  # of load and hook block [kN]
    even, along, against = (float(one) for one in row.groups())
    assert even == pytest.approx(weight / PARTS, abs=1e-3)
    # Half of the last digit that the table has, 0.1 kN.
    assert along == pytest.approx(weight * (LOSS - 1) / (1 - LOSS**-PARTS), abs=0.051)
    assert against == pytest.approx(weight / (1 + 1 / LOSS + 1 / LOSS**2), abs=0.051)
