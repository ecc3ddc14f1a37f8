"""A barge on whose deck a hook ashore sets a module down, 1 m aside of her middle."""

from __future__ import annotations

#: A barge of 40 by 12 m; the module comes down 1 m to port of its middle, by a hook ashore.
LIFT = """
format: 1
lift: {title: A module comes on a barge}
duration: 400 s
water: {density: 1.025 t/m^3, level: 0 m}
ropes: {sling: {axial_stiffness: 60 MN, mass: none, minimum_breaking_force: 2 MN, damping_time: 20 ms}}
load:
  name: module
  shape: {box: [8 m, 6 m, 4 m]}
  position: [20 m, 1 m, 2.6 m]
  weight: {calculated: 60 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs:
    A: {at: [-3 m, 2 m, 4 m], capacity: 40 t}
    B: {at: [3 m, 2 m, 4 m], capacity: 40 t}
    C: {at: [-3 m, -2 m, 4 m], capacity: 40 t}
    D: {at: [3 m, -2 m, 4 m], capacity: 40 t}
cranes:
  hook:
    type: fixed_hook
    at: [20 m, 1 m, 14.5 m]
    rated_capacity: 100 t
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}
sling_defaults: {rope: sling, length: 8.7 m}
slings:
  A: {from: hook, to: module.A}
  B: {from: hook, to: module.B}
  C: {from: hook, to: module.C}
  D: {from: hook, to: module.D}
vessels:
  barge:
    position: [0 m, 0 m]
    draft: 1.8 m
    hull: {box: [40 m, 12 m, 4 m]}
    masses: {hull: {mass: 700 t, at: [20 m, 0 m, 2 m]}}
    radii_of_gyration: [4 m, 11 m, 11 m]
    tanks:
      ps: {box: [10 m, 4 m, 3 m], bottom: [20 m, 4 m, 0.2 m], content: 60 t}
      sb: {box: [10 m, 4 m, 3 m], bottom: [20 m, -4 m, 0.2 m], content: 60 t}
      fore: {box: [4 m, 8 m, 3 m], bottom: [36 m, 0 m, 0.2 m], content: 40 t}
      aft: {box: [4 m, 8 m, 3 m], bottom: [4 m, 0 m, 0.2 m], content: 40 t}
    added_mass: {at: [20 m, 0 m, 0 m], heave: 900 t, roll: 8000 t m^2, pitch: 90000 t m^2}
    water_damping: {critical: {heave: 20 %, pitch: 20 %, roll: 20 %}}
mooring_lines:
  fp: {vessel: barge, fairlead: [40 m, 6 m, 4 m], to: [80 m, 40 m, 2 m], rope: sling, PULL}
  fs: {vessel: barge, fairlead: [40 m, -6 m, 4 m], to: [80 m, -40 m, 2 m], rope: sling, PULL}
  ap: {vessel: barge, fairlead: [0 m, 6 m, 4 m], to: [-40 m, 40 m, 2 m], rope: sling, PULL}
  as: {vessel: barge, fairlead: [0 m, -6 m, 4 m], to: [-40 m, -40 m, 2 m], rope: sling, PULL}
mechanics:
  body_contacts:
    on_deck: {between: [module, barge], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
plan:
  - {step: down, lower: hook, speed: 1 m/min, until: {supports: touched}}
  - {step: half, lower: hook, speed: 0.2 m/min, until: {load_transferred: 50 %}}
  - {step: all, lower: hook, speed: 0.5 m/min, until: {slings: slack}}
  - {step: further, lower: hook, speed: 1 m/min, by: 0.5 m}
  - {step: hold, hold: until_end}
"""
