"""A module on two slings and two ropes of `mechanics`, all in one hook."""

from __future__ import annotations

BESIDE_MECHANICS = """\
format: 1
lift: {title: A module on two slings and two chain hoists}
duration: 6 s
ground: {friction: 0.5}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, minimum_breaking_force: 1000 kN}
load:
  name: module
  shape: {box: [6 m, 4 m, 2 m]}
  position: [0 m, 0 m, 0.5 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  lugs:
    B: {at: [2 m, 1.5 m, 2 m], capacity: 40 t}
    D: {at: [2 m, -1.5 m, 2 m], capacity: 40 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 10 m]
    rated_capacity: 60 t
    hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}
sling_defaults: {rope: sling}
slings:
  B: {from: hook, to: module.B, length: 7.9 m}
  D: {from: hook, to: module.D, length: 7.9 m}
mechanics:
  ropes:
    A:
      rope: sling
      length: 7.9 m
      route: [{type: end, body: hook}, {type: end, body: module, at: [-2 m, 1.5 m, 1 m]}]
    C:
      rope: sling
      length: 7.9 m
      route: [{type: end, body: hook}, {type: end, body: module, at: [-2 m, -1.5 m, 1 m]}]
plan:
  - {step: hang, hold: until_end}
"""
