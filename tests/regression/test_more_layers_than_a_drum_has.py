"""Rope beyond the last layer of a drum was recorded as wound on that layer.

A drum that winds more than it has room for is warned of and goes on, each layer one step farther out, as the
core has it. `rope_paid_out` stopped climbing at `layers`: of 45 turns on a drum for 20 it was 5 m short of
136 m. And `gantline statics` warned of nothing.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.statics import Statics

DIAMETER, TURNS, LAYERS, ROPE = 0.8, 10, 2, 20e-3
WAY = 50.0
LIFT = f"""\
format: 1
lift: {{title: More than there is room for}}
duration: 120 s
start: rest
ropes: {{r: {{axial_stiffness: 36 MN, damping_time: 20 ms, diameter: 20 mm, mass: none}}}}
mechanics:
  bodies:
    load: {{at: [0 m, 0 m, -100 m], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 1 t}}
  drums:
    winch: {{diameter: {DIAMETER} m, rotating_mass: 2 t, layers: {LAYERS}, wraps_per_layer: {TURNS},
      wraps_at_start: 18, drive: {{speed: 60 m/min, acceleration: 0.2 m/s^2}}}}
  ropes:
    a: {{rope: r, length: as_routed, route: [
      {{type: end, body: world, drum: winch}}, {{type: end, body: load}}]}}
plan:
  - {{step: haul, haul_in: winch, speed: 60 m/min, by: {WAY} m}}
  - {{step: wait, hold: until_end}}
"""


def test_paid_out_is_what_the_load_rises() -> None:
    """A load of one tension throughout rises by what the drum winds, 18 turns farther than there is room for.

    Less what its speed changes: it hangs still at both ends, to 1e-6 of its way.
    """
    found = gantline.simulate(gantline.parse_scenario(LIFT))
    places = found.column("body_position", "load")[:, 2]
    risen = float(places[-1] - places[0])
    assert found.column("drum_wraps", "winch")[-1] > LAYERS * TURNS + 1
    # The third layer alone adds its step to each turn past the second.
    turns = found.column("drum_wraps", "winch")[-1] - LAYERS * TURNS
    assert risen > WAY + 2 * math.pi * turns * ROPE / 2
    assert -found.column("rope_paid_out", "winch")[-1] == pytest.approx(risen, rel=1e-6)
    assert any("it has room for 20" in warning for warning in found.attributes["warnings"])


def test_an_equilibrium_warns_too() -> None:
    rest = Statics(gantline.parse_scenario(LIFT)).equilibrium(120.0).recording
    (warning,) = rest.attributes["warnings"]
    turns = rest.column("drum_wraps", "winch")[-1]
    assert warning == f"winch would have {turns:.1f} turns at 120.00 s; it has room for 20" and turns > 21
