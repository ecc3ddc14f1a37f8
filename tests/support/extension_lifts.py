"""Lifts by extension sheaves: four lugs under two slings of an equalizer, or under one sling of a hook."""

from __future__ import annotations

LUGS = ((-3.0, -2.0), (-3.0, 2.0), (3.0, -2.0), (3.0, 2.0))  # m
#: Simulated mass of the load and mass of an extension sheave [kg].
LOAD, SHEAVE = 60e3, 150.0

_HEAD = """\
format: 1
lift: {title: Extension sheaves}
duration: 60 s
start: rest
ground: {level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, mass: none}
load:
  name: block
  shape: {box: [8 m, 6 m, 3 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 60 t, contingency: 1.00}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  stands_on: ground
  lugs:
    L1: {at: [-3 m, -2 m, 3 m], main_plate: yz, capacity: 40 t}
    L2: {at: [-3 m,  2 m, 3 m], main_plate: yz, capacity: 40 t}
    L3: {at: [ 3 m, -2 m, 3 m], main_plate: yz, capacity: 40 t}
    L4: {at: [ 3 m,  2 m, 3 m], main_plate: yz, capacity: 40 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, HEIGHT]
    rated_capacity: 100 t
    hoist: {speed: 6 m/min, acceleration: 0.02 m/s^2}
sling_defaults: {rope: sling}
plan:
  - {step: hoist, hoist: hook, speed: 3 m/min, by: 1.5 m}
  - {step: hold, hold: until_end}
"""

#: One sling of a hook, a sheave on it, two on the sling over that: four lugs at depth two.
DEEP = (
    _HEAD.replace("HEIGHT", "26.1 m")
    + """\
extension_sheaves:
  X1: {mass: 150 kg, pitch_diameter: 0.6 m}
  X2: {mass: 150 kg}
  X3: {mass: 150 kg}
slings:
  S:  {from: hook, to: X1, length: 5 m}
  S1: {over: X1, to: [X2, X3], length: 20 m}
  S2: {over: X2, to: [block.L1, block.L2], length: 18 m}
  S3: {over: X3, to: [block.L3, block.L4], length: 18 m}
"""
)

#: An equalizer with two moving sheaves, an extension sheave on each of its slings.
PAIRED = (
    _HEAD.replace("HEIGHT", "26.4 m")
    .replace("main_plate: yz", "main_plate: xz")
    .replace("sling: {axial", "thick: {axial_stiffness: 200 MN, damping_time: 20 ms}\n  sling: {axial")
    + """\
equalizers:
  e1:
    hangs_from: hook
    frame: {mass: 5 t, length: 4 m, width: 1 m, height: 2 m, centre_of_gravity_below_hook: 2 m}
    hinge: {damping: 100 kN m s}
    rope: thick
    rope_ends: {along: [-1.2 m, 1.2 m], below_hook: 3 m}
    fixed_sheaves: {along: [0 m], below_hook: 3 m, pitch_diameter: 0.8 m}
    moving_sheaves: {along: [-0.8 m, 0.8 m], below_hook: 5 m, pitch_diameter: 0.8 m, mass: 200 kg}
    travel: {up: 1 m, down: 1 m, locked: true}
extension_sheaves:
  X1: {mass: 150 kg}
  X2: {mass: 150 kg}
slings:
  S1:  {from: e1.1, to: X1, length: 9 m}
  S2:  {from: e1.2, to: X2, length: 9 m}
  S1x: {over: X1, to: [block.L1, block.L2], length: 20 m}
  S2x: {over: X2, to: [block.L3, block.L4], length: 20 m}
"""
).replace("hold: until_end}", "hold: until_end, pull_pins: e1}")
