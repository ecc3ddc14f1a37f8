"""Lift files of a module of 20 t on one sling of 5 m that is lowered, with a barge about or without."""

from __future__ import annotations

#: A barge of 984 t whose stern is at x = 0: deck 2 m above the water, underside 2 m below.
BARGE = """\
vessels:
  barge:
    draft: 2 m
    hull: {box: [40 m, 12 m, 4 m]}
    masses:
      hull: {mass: 984 t, at: [20 m, 0 m, 2 m]}
    radii_of_gyration: [4 m, 11 m, 11 m]
"""

_LIFT = """\
format: 1
lift: {{title: A module is lowered}}
duration: {duration} s
{ground}ropes:
  sling: {{axial_stiffness: 100 MN, damping_time: 10 ms}}
load:
  name: module
  shape: {{box: [4 m, 4 m, 3 m]}}
  position: [{x} m, 0 m, {z} m]
  weight: {{calculated: 20 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs:
    A: {{at: [0 m, 0 m, 3 m]}}
{around}cranes:
  hook:
    type: fixed_hook
    at: [{x} m, 0 m, {hook} m]
    hoist: {{speed: {speed} m/min, acceleration: 0.1 m/s^2}}
slings:
  A: {{from: hook, to: module.A, length: 5 m, rope: sling}}
plan:
  - {{step: lower, lower: hook, speed: {speed} m/min, by: {lowered} m}}
  - {{step: hold, hold: until_end}}
"""


def module_lift(
    lowered: float,
    *,
    place: tuple[float, float],
    speed: float,
    duration: float,
    ground: str = "",
    around: str = BARGE,
) -> str:
    """A lift file.

    Args:
        lowered: How far down [m].
        place: x and z of its underside at the start [m]; the hook is 8 m above that, its sling just taut.
        speed: Of the hook [m/min].
        duration: Of the lift [s].
        ground: Section of the ground, if there is any.
        around: Further sections: the barge, or what takes its place.
    """
    x, z = place
    return _LIFT.format(
        lowered=lowered, x=x, z=z, hook=z + 8.0, speed=speed, duration=duration, ground=ground, around=around
    )
