"""Gear that lifts with two crawler cranes share: ropes, hooks, masses."""

from __future__ import annotations

GEAR = """\
ground: {level: 0 m, friction: 0.4}
ropes:
  hoist: {axial_stiffness: 36 MN, damping_time: 10 ms, mass: none, diameter: 28 mm}
  sling: {axial_stiffness: 266 MN, damping_time: 10 ms, mass: none, diameter: 76 mm}
hook_types:
  H:
    block: {mass: 7 t, height: 2 m}
    reeving: {parts_each: 14, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m, sheave_block_mass: 1 kg}
    drum: {diameter: 0.8 m}
    hoist: {speed: 6 m/min, acceleration: 0.02 m/s^2}
"""
#: What is alike of the cranes themselves.
MASSES = """\
    base_mass: 190 t
    central_ballast: 95 t
    counterweight: {mass: 250 t, behind: 6.5 m}
    boom: {heel_pins: {ahead: 1.6 m, height: 2.5 m}, length: 63 m, radius: 16 m, mass: 60 t,
      centre_of_gravity: 45 %}
"""
