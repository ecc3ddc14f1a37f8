"""A box of 10 t on one sling above a deck that moves as told."""

from __future__ import annotations

from hung_box import hung_box


def onto_a_deck(plan: str, motion: str, *, height: float = 0.3, hook: float = 7.3, end: float = 24.0) -> str:
    """A lift file; its plan begins with 6 s of waiting.

    Args:
        plan: Steps, a line each, indented.
        motion: Of the deck upwards, items of a list.
        height: Of the box over the deck [m].
        hook: Height of the bearing of the hook; the sling is 5 m long and the box 2 m high [m].
        end: Of the run [s].
    """
    return f"""\
format: 1
lift: {{title: A box above a deck}}
duration: {end} s
start: rest
ropes: {{soft: {{axial_stiffness: 20 MN, damping_time: 10 ms}}}}
{hung_box(f"0 m, 0 m, {height} m", f"0 m, 0 m, {hook} m", "speed: 30 m/min, acceleration: 0.2 m/s^2")}\
mechanics:
  bodies:
    deck:
      at: [10 m, 0 m, 0 m]
      joint: {{type: slider, axis: [0, 0, 1], motion: [{motion}]}}
      mass: 1000 t
      shape: {{box: [24 m, 4 m, 1 m], centre: [0 m, 0 m, -0.5 m]}}
  body_contacts:
    on_deck: {{between: [box, deck], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}}
plan:
  - {{step: wait, hold: 6 s}}
{plan}
  - {{step: end, hold: until_end}}
simulation: {{sample_interval: 10 ms}}
"""
