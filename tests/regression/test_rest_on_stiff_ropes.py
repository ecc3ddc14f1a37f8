"""`start: rest` of a hoist with a motor of limited pull, sheaves that lose, and very stiff ropes.

Statics holds a drum by a compliance ε of its own, and moves its force until the drum is where it is held:
each search leaves the share εk/(1 + εk) of what it lacks, k what the ropes pull back with. A drum that counts
the way of its hook feeds as many metres as there are parts, so k has their square: 256 EA/5 m for the lead
line of 16 parts. From 3000 MN on 40 searches did not do, and the lift was refused: "lengths that cannot
change contradict one another". With 200 MN it always started.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from mechanics import G

LOAD, HOOK_BLOCK = 60e3, 3e3

_LIFT = """\
format: 1
lift: {{title: Stiff ropes}}
duration: 5 s
ropes:
  hoist: {{axial_stiffness: {stiffness} MN, damping_time: 10 ms, diameter: 28 mm}}
  sling: {{axial_stiffness: 200 MN, damping_time: 10 ms}}
load:
  name: load
  shape: {{box: [2 m, 2 m, 2 m]}}
  position: [0 m, 0 m, 5 m]
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{A: {{at: [0 m, 0 m, 2 m]}}}}
cranes:
  crane:
    type: fixed_hook
    at: [0 m, 0 m, 13 m]
    block: {{mass: 3 t, height: 1 m}}
    reeving: {{ropes: 1, parts_each: {parts}, rope: hoist, sheave_diameter: 0.4 m, sheave_efficiency: 0.98,
      upper_sheaves_at: 40 m}}
    drum: {{diameter: 0.4 m, layers: 1, rotating_mass: 500 kg}}
    hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2, capacity: 200 kN, brake: 300 kN}}
slings:
  S: {{from: crane, to: load.A, length: 6 m, rope: sling}}
"""


@pytest.mark.parametrize("parts", [4, 8, 16])
@pytest.mark.parametrize("stiffness", [200, 3000, 10_000, 100_000])
def test_a_load_hangs_in_its_parts_however_stiff(parts: int, stiffness: int) -> None:
    lift = parse_scenario(_LIFT.format(parts=parts, stiffness=stiffness))
    rest = Statics(lift).equilibrium(0.0, losses="held").recording
    falls = [place for place, name in enumerate(rest.coordinates["segment"]) if name.startswith("hoist")]
    pulls = rest["segment_tension"].values[-1, falls[:parts]]
    # Friction holds parts of unequal pull. Their sum is right to 2e-10.
    assert pulls.sum() == pytest.approx((LOAD + HOOK_BLOCK) * G, rel=1e-9)
    # And the load stays where it is, to 3e-14 m.
    assert np.ptp(gantline.simulate(lift).column("body_position", "load")[:, 2]) < 1e-12
