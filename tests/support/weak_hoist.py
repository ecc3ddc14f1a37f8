"""A load in two parts of line, held by a motor or a brake that may be too weak for it."""

from __future__ import annotations

#: Parts of line; mass of the hook block, and of what turns with the drum as if it were at its rim [kg].
PARTS, HOOK_BLOCK, DRUM = 2, 100.0, 500.0

_LIFT = """\
format: 1
lift: {{title: two parts of line}}
duration: {duration} s
ground: {{level: 0 m}}
ropes:
  hoist: {{axial_stiffness: 36 MN, damping_time: 20 ms}}
  sling: {{axial_stiffness: 36 MN, damping_time: 10 ms}}
load:
  name: load
  shape: {{box: [2 m, 2 m, 2 m]}}
  {place}
  weight: {{calculated: {mass} t, contingency: 1.0}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs: {{A: {{at: [0 m, 0 m, 2 m]}}}}
cranes:
  crane:
    type: fixed_hook
    at: [0 m, 0 m, {hook} m]
    block: {{mass: 100 kg, height: 1 m}}
    reeving: {{ropes: 1, parts_each: 2, rope: hoist, sheave_diameter: 0.4 m, upper_sheaves_at: {upper} m}}
    drum: {{diameter: 0.4 m, layers: 1, rotating_mass: 500 kg}}
    hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2, {motor}}}
slings:
  S: {{from: crane, to: load.A, length: 6 m, rope: sling}}
plan:
{plan}
  - {{step: hold, hold: until_end}}
"""


def standing(plan: str, mass: float, motor: str, duration: float) -> str:
    """A lift file of a load of a mass [t] on the ground, its sling a centimetre too long to pull.

    Args:
        plan: Steps, one a line, not indented; a hold until the end follows.
        mass: Of the load [t].
        motor: More keys of the hoist.
        duration: Of the lift [s].
    """
    return _lift(plan, mass, motor, duration, "stands_on: ground", (7.99, 14.0))


def hanging(plan: str, mass: float, motor: str, duration: float) -> str:
    """The same of a load that hangs 5 m above the ground."""
    return _lift(plan, mass, motor, duration, "position: [0 m, 0 m, 5 m]", (13.0, 20.0))


def _lift(
    plan: str, mass: float, motor: str, duration: float, place: str, heights: tuple[float, float]
) -> str:
    steps = "\n".join(f"  - {line}" for line in plan.splitlines())
    hook, upper = heights
    return _LIFT.format(
        plan=steps, mass=mass, motor=motor, duration=duration, place=place, hook=hook, upper=upper
    )
