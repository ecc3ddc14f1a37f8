"""A lift through the splash zone that never came to the water was GO, with 0 warnings.

`by: 1 m` for 14 m left the manifold 3.9 m above the sea. Nothing swung, nothing slammed, no sling went slack,
and nothing said that what its lift file says under `in_water` did nothing.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from gantline.units import format_quantity

BOTTOM = 2.0
LIFT = f"""
format: 1
lift: {{title: A box over water}}
duration: 12 s
water: {{density: 1025 kg/m^3, level: 0 m}}
ropes:
  sling: {{construction: 6x36 IWRC, grade: 1960, diameter: 40 mm, damping_time: 10 ms}}
load:
  name: box
  shape: {{box: [4 m, 4 m, 2 m]}}
  position: [0 m, 0 m, {BOTTOM} m]
  weight: {{calculated: 20 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  in_water:
    displaced_volume: 4 m^3
    added_mass: [2 t, 2 t, 4 t]
    drag_coefficients: [1, 1, 2]
  lugs:
    A: {{at: [ 1.5 m,  1.5 m, 2 m], main_plate: xz, capacity: 20 t}}
    B: {{at: [ 1.5 m, -1.5 m, 2 m], main_plate: xz, capacity: 20 t}}
    C: {{at: [-1.5 m,  1.5 m, 2 m], main_plate: xz, capacity: 20 t}}
    D: {{at: [-1.5 m, -1.5 m, 2 m], main_plate: xz, capacity: 20 t}}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 9 m]
    rated_capacity: 60 t
    hoist: {{speed: 30 m/min, acceleration: 0.5 m/s^2}}
slings:
  A: {{from: hook, to: box.A, length: 5.44 m, rope: sling}}
  B: {{from: hook, to: box.B, length: 5.44 m, rope: sling}}
  C: {{from: hook, to: box.C, length: 5.44 m, rope: sling}}
  D: {{from: hook, to: box.D, length: 5.44 m, rope: sling}}
start: rest
plan:
  - {{step: lower, lower: hook, speed: 30 m/min, by: BY}}
"""


def warned(by: str, until: float | None = None) -> list[str]:
    simulation = Simulation(parse_scenario(LIFT.replace("BY", by)))
    if until is not None:
        simulation.advance_to(until)
        recording = simulation.recording()
    else:
        recording = simulation.run()
    return [one for one in recording.attributes["warnings"] if "gets wet" in one]


def test_a_step_that_ends_over_the_water() -> None:
    """Its bottom comes down by half a metre and by the stretch of the slings, less than a centimetre."""
    (said,) = warned("0.5 m")
    start, end = "box has 'in_water' and never gets wet: its lowest point stays ", " m above still water; "
    assert said.startswith(start)
    assert said.endswith(f"{end}see how far the plan lowers it")
    # That centimetre, and two decimals.
    left = float(said.removeprefix(start).split(" m ")[0])
    assert left == pytest.approx(BOTTOM - 0.5, abs=0.015), format_quantity(left, "m", 2)


def test_a_load_that_gets_wet() -> None:
    assert warned("3 m") == []


def test_a_run_that_goes_on() -> None:
    """Who looks at a run half-way is told nothing of what has not come yet."""
    assert warned("3 m", until=1.0) == []
