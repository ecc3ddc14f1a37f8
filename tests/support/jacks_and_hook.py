"""A section in two strand jacks under one end and a hook under the other."""

from __future__ import annotations

#: The load, and one bundle from jack to load [t].
LOAD, BUNDLE = 400.0, 34.0 * 22.4e-3
LIFT = """\
format: 1
lift: {title: A section in two jacks and a hook}
duration: 60 s
start: rest
ropes:
  bundle: {axial_stiffness: 556 MN, minimum_breaking_force: 5301 kN, mass: 22.4 kg/m}
  sling: {axial_stiffness: 200 MN, mass: none}
load:
  name: section
  shape: {box: [40 m, 12 m, 4 m]}
  position: [0 m, 0 m, 2 m]
  weight: {calculated: 400 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs: {L1: {at: [18 m, 0 m, 4 m], main_plate: xz}}
cranes:
  H: {type: fixed_hook, at: [18 m, 0 m, 30 m], hoist: {speed: 1 m/min, acceleration: 5 mm/s^2}}
slings:
  S: {from: H, to: section.L1, length: 23.9 m, rope: sling}
mechanics:
  drums:
    j1: {diameter: 1 m, rotating_mass: 1 t, drive: {speed: 1 m/min, acceleration: 5 mm/s^2}}
    j2: {diameter: 1 m, rotating_mass: 1 t, drive: {speed: 1 m/min, acceleration: 5 mm/s^2}}
  ropes:
    b1: {rope: bundle, length: as_routed, route: [{type: end, body: world, at: [-18 m, -5 m, 40 m], drum: j1},
      {type: end, body: section, at: [-18 m, -5 m, 2 m]}]}
    b2: {rope: bundle, length: as_routed, route: [{type: end, body: world, at: [-18 m, 5 m, 40 m], drum: j2},
      {type: end, body: section, at: [-18 m, 5 m, 2 m]}]}
plan:
  - {step: hold, hold: until_end}
"""
