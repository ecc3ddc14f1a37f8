"""A box of 10 t, 4 m x 2 m x 2 m, on the ground below a hook at 6 m, in two slings of 4.2 m."""

from __future__ import annotations


def box_on_a_hook(plan: str, *, duration: float, speed: float = 6.0, more: str = "") -> str:
    """A lift file.

    Args:
        plan: Steps between lift-off and the end, a line each, indented.
        duration: Of the lift [s].
        speed: Of the hoist [m/min].
        more: Further sections.
    """
    return f"""\
format: 1
lift: {{title: A box on a hook}}
duration: {duration} s
ground: {{level: 0 m, friction: 0.5}}
ropes: {{sling: {{axial_stiffness: 50 MN, damping_time: 10 ms, minimum_breaking_force: 900 kN}}}}
load:
  name: box
  shape: {{box: [4 m, 2 m, 2 m]}}
  weight: {{calculated: 10 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs:
    L1: {{at: [1 m, 0 m, 2 m], capacity: 20 t, main_plate: xz}}
    L2: {{at: [-1 m, 0 m, 2 m], capacity: 20 t, main_plate: xz}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 6 m], rated_capacity: 20 t,
    hoist: {{speed: {speed} m/min, acceleration: 0.1 m/s^2}}}}
sling_defaults: {{rope: sling}}
slings:
  S1: {{from: hook, to: box.L1, length: 4.2 m}}
  S2: {{from: hook, to: box.L2, length: 4.2 m}}
plan:
  - {{step: lift off, hoist: hook, speed: 3 m/min, until: {{supports: clear}}}}
{plan}
  - {{step: rest, hold: until_end}}
limits: {{rule: yard, load_tilt: 5 deg}}
{more}"""
