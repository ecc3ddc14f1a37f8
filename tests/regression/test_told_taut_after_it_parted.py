"""A sling with nodes that was cut, of which the events said later on that it was taut.

Its pieces hang from the lug and whip. The piece that was cut is no longer taut or slack in the core, so
the others came and went: the rope was told taut each time none of them was slack, and the last of these
counts where it is asked from when a sling has been taut to the end.
"""

from __future__ import annotations

import gantline
from gantline.scenario import parse_scenario

CUT = 1.0
LIFT = f"""
format: 1
lift: {{title: One of two slings is cut and hangs from the load}}
duration: 4 s
start: as_given
ropes:
  steel: {{axial_stiffness: 5 MN, damping_time: 20 ms, mass: 8 kg/m}}
load:
  name: module
  shape: {{box: [6 m, 3 m, 2 m]}}
  position: [0 m, 0 m, 2 m]
  weight: {{calculated: 5 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{A: {{at: [-2 m, 0 m, 2 m]}}, B: {{at: [2 m, 0 m, 2 m]}}}}
cranes:
  ca: {{type: fixed_hook, at: [-2 m, 0 m, 14 m], hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
  cb: {{type: fixed_hook, at: [3 m, 0 m, 14 m], hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
slings:
  S1: {{from: ca, to: module.A, length: 10 m, rope: steel, rope_weight: none}}
  S2: {{from: cb, to: module.B, length: 10.1 m, rope: steel, rope_weight: distributed, rope_nodes: 3,
    cut_at: {CUT} s}}
simulation: {{integrator: del, step: 1 ms}}
"""


def test_a_sling_that_was_cut_is_not_told_taut_or_slack() -> None:
    recording = gantline.simulate(parse_scenario(LIFT))
    told = [(time, kind) for time, kind, name in recording.events() if name == "sling.S2"]
    assert (CUT, "cut") in told
    assert [kind for time, kind in told if time > CUT] == []
    # What is left of it does whip: pieces go slack and taut again.
    left = recording.column("segment_tension", "sling.S2/2")[recording.time > CUT]
    assert (left == 0.0).any() and (left > 0.0).any()
