"""What a drum has paid out of a rope that lies on another diameter of its shaft.

A drum's rope was counted once for each way round, on the diameter of the drum, whatever the `drum_diameter`
of the rope: 4.225 m of one on 0.6 m beside 0.8 m that went down by 3.225 m, in table and recording, and
nothing at all of a rope on a third diameter.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.scenario import parse_scenario

OWN, START, WAY, STEP = 0.8, 6.0, 2.0, 0.02
TURNS = WAY / (math.pi * OWN)
#: Ropes by the drum of the recording: their diameter on it [m], and which way it winds them.
ON = {"winch": (OWN, 1.0), "winch/500 mm": (0.5, 1.0), "winch/against": (0.6, -1.0)}
LIFT = f"""\
format: 1
lift: {{title: Three ropes on one shaft}}
duration: 30 s
start: rest
ropes: {{r: {{axial_stiffness: 36 MN, damping_time: 20 ms, diameter: 20 mm}}}}
mechanics:
  bodies:
    a: {{at: [0 m, 0 m, 20 m], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 6 t}}
    b: {{at: [3 m, 0 m, 20 m], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 4 t}}
    c: {{at: [6 m, 0 m, 20 m], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 5 t}}
  drums:
    winch: {{diameter: {OWN} m, rotating_mass: 1 t, layers: 2, wraps_per_layer: 5, wraps_at_start: {START},
      layer_step: {STEP} m, drive: {{speed: 60 m/min, acceleration: 0.5 m/s^2}}}}
  ropes:
    b: {{rope: r, length: as_routed, route: [{{type: end, body: b}},
      {{type: end, body: world, at: [3 m, 0 m, 60 m], drum: winch, drum_diameter: 0.5 m}}]}}
    a: {{rope: r, length: as_routed, route: [{{type: end, body: a}},
      {{type: end, body: world, at: [0 m, 0 m, 60 m], drum: winch}}]}}
    c: {{rope: r, length: as_routed, route: [{{type: end, body: c}},
      {{type: end, body: world, at: [6 m, 0 m, 60 m], drum: winch, drum_diameter: 0.6 m, wound: against}}]}}
plan:
  - {{step: raise, haul_in: winch, speed: 12 m/min, by: {WAY} m}}
  - {{step: wait, hold: until_end}}
"""
BODIES = {"winch": "a", "winch/500 mm": "b", "winch/against": "c"}


@pytest.mark.parametrize("drum", ON)
def test_each_rope_has_the_turns_of_the_drum_on_its_own_diameter(drum: str) -> None:
    """In the second layer a turn is 2 pi (r + 20 mm); the rope against it climbs down at 5.25 turns."""
    found = gantline.simulate(parse_scenario(LIFT))
    diameter, way = ON[drum]
    # Within the climb the radius falls by STEP in half a turn: by (5.25 - w) STEP/0.5 at w turns.
    climbed = max(5.25 - (START - TURNS), 0.0) if way < 0.0 else 0.0
    rim = 2 * math.pi * ((diameter / 2 + STEP) * TURNS - STEP * climbed**2)
    hauled_in = way * rim
    assert found.column("drum_wraps", drum)[-1] == pytest.approx(START + way * TURNS, abs=1e-9)
    assert found.column("rope_paid_out", drum)[-1] == pytest.approx(-hauled_in, abs=1e-9)
    height = found.column("body_position", BODIES[drum])[:, 2]
    # At rest it has moved as far as rope has gone over the rim; as it starts and stops other strains wind.
    assert height[-1] - height[0] == pytest.approx(hauled_in, abs=1e-5)
