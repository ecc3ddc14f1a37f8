"""A Goliath crane with two trolleys, a hook at each, above the ground: a lift file up to its load."""

from __future__ import annotations

TROLLEYS = """\
format: 1
lift: {title: Two trolleys}
duration: 400 s
ground: {level: 0 m, friction: 0.5, stiffness: 500 MN/m, damping: 5 MN s/m}
ropes:
  hoist: {axial_stiffness: 100 MN, mass: none, diameter: 42 mm}
  sling: {axial_stiffness: 200 MN}
hook_types:
  H:
    block: {mass: 6 t, height: 3 m}
    reeving: {parts_each: 8, rope: hoist, sheave_diameter: 1 m, upper_sheaves_at: 60 m}
    drum: {diameter: 1.6 m}
    hoist: {speed: 5 m/min, acceleration: 0.05 m/s^2}
cranes:
  gol:
    type: goliath
    span: 100 m
    girder: {underside: 62 m, mass: 900 t, vertical_stiffness: 60 MN/m}
    legs: {fixed: 300 t, hinged: 200 t}
    position: 0.2 m
    travel: {speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-40 m, 40 m]}
    trolleys:
      one:
        mass: 60 t
        position: -8.3 m
        traverse: {speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-40 m, 40 m]}
        hooks: {A: {type: H, height: 13.6 m}}
      two:
        mass: 60 t
        position: 8.8 m
        traverse: {speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-40 m, 40 m]}
        hooks: {B: {type: H, height: 13.6 m}}
"""
