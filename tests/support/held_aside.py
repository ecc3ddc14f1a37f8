"""A box of 60 t, 8 m x 4 m x 6 m, that hangs 6 m up in four slings of 11 m, held aside by a line."""

from __future__ import annotations


def held_aside(plan: str, *, duration: float, pull: float, more: str = "") -> str:
    """A lift file.

    Args:
        plan: Steps before the last one, a line each, indented.
        duration: Of the lift [s].
        pull: Of the line `back` at the start, along -x [kN].
        more: Further sections, the ground among them.
    """
    return f"""\
format: 1
lift: {{title: A box on a hook that is let go of}}
duration: {duration} s
ropes:
  sling: {{axial_stiffness: 188 MN, damping_time: 10 ms, mass: none}}
  tag: {{axial_stiffness: 150 kN, damping_time: 0.2 s, mass: none}}
load:
  name: box
  shape: {{box: [8 m, 4 m, 6 m]}}
  position: [0 m, 0 m, 6 m]
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 3 m]}}
  lugs: {{A: {{at: [-3 m, 1.5 m, 6 m]}}, B: {{at: [-3 m, -1.5 m, 6 m]}}, C: {{at: [3 m, 1.5 m, 6 m]}},
    D: {{at: [3 m, -1.5 m, 6 m]}}}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 22.43 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling, length: 11 m}}
slings: {{A: {{from: hook, to: box.A}}, B: {{from: hook, to: box.B}}, C: {{from: hook, to: box.C}},
  D: {{from: hook, to: box.D}}}}
tag_lines:
  back: {{at: [-4 m, 0 m, 3 m], to: [-30 m, 0 m, 9 m], rope: tag, pretension: {pull} kN}}
plan:
{plan}
  - {{step: end, hold: until_end}}
{more}"""
