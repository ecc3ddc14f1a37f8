"""A load that stands on the ground, in a hook of whole reeving, and a tugger of constant pull."""

#: Pull of the tugger [N].
PULL = 3e3

LIFT = """
format: 1
lift: {title: A load on a hook and a tugger}
duration: 300 s
ground: {level: 0 m, friction: 0.3}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 10 ms, mass: none}
  hoist: {axial_stiffness: 60 MN, damping_time: 10 ms, mass: none, diameter: 42 mm}
  tag: {axial_stiffness: 1 MN, damping_time: 50 ms, mass: none}
load:
  name: load
  shape: {box: [10 m, 4 m, 4 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 40 t, contingency: 1.0}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  stands_on: ground
  lugs:
    A: {at: [3 m, 1.5 m, 4 m]}
    B: {at: [3 m, -1.5 m, 4 m]}
    C: {at: [-3 m, 1.5 m, 4 m]}
    D: {at: [-3 m, -1.5 m, 4 m]}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 11.9 m]
    block: {mass: 2 t, height: 2 m}
    reeving: {ropes: 1, parts_each: 4, rope: hoist, sheave_diameter: 0.8 m, upper_sheaves_at: 40 m}
    drum: {diameter: 1 m}
    hoist: {speed: 10 m/min, acceleration: 0.05 m/s^2}
sling_defaults: {rope: sling, length: 8.8 m}
slings:
  A: {from: hook, to: load.A}
  B: {from: hook, to: load.B}
  C: {from: hook, to: load.C}
  D: {from: hook, to: load.D}
tag_lines:
  line: {at: [5 m, 0 m, 2 m], to: [60 m, 0 m, 6 m], rope: tag, pull: 3 kN}
plan:
  - {step: hoist, hoist: hook, speed: 5 m/min, by: 5 m}
  - {step: hold, hold: until_end}
"""
