"""A lift file of 10 t on one part of rope, whose winch is stopped in an emergency while it pays out."""

from __future__ import annotations

_LIFT = """\
format: 1
lift: {title: A winch with one part of rope}
duration: 12 s
ropes:
  hoist: {axial_stiffness: 36 MN, damping_time: 20 ms}
mechanics:
  bodies:
    load: {at: [0 m, 0 m, 2 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 10 t}
  drums:
    winch:
      diameter: 0.8 m
      rotating_mass: 2 t
      drive: {speed: 30 m/min, acceleration: 0.2 m/s^2, capacity: 150 kN, brake: BRAKE}
  ropes:
    fall:
      {rope: hoist, length: as_routed, route: [{type: end, body: load},
       {type: end, body: world, at: [0 m, 0 m, 12 m], drum: winch}]}
plan:
  - {step: lower, pay_out: winch, speed: 6 m/min, emergency_stop_at: 10 s}
"""


def winch_lift(brake: str) -> str:
    """The lift file with this `brake`, such as `50 kN`."""
    return _LIFT.replace("BRAKE", brake)
