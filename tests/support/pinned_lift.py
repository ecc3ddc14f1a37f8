"""A load of 120 t that hangs on three plumb slings under an equalizer, the middle one 200 mm too long.

Under locking pins the outer two carry it, W/2 each; once the pins are pulled each carries W/3.
"""

from __future__ import annotations

from mechanics import G

#: Weight of the load [N].
WEIGHT = 120e3 * G

LIFT = """\
format: 1
lift: {title: Three slings under pins}
duration: 80 s
ropes:
  sling:      {axial_stiffness: 200 MN, damping_time: 20 ms, mass: none, minimum_breaking_force: 3000 kN}
  equalizing: {axial_stiffness: 100 MN, damping_time: 20 ms, mass: none, minimum_breaking_force: 1500 kN}
load:
  name: block
  shape: {box: [10 m, 4 m, 4 m]}
  position: [0 m, 0 m, 2 m]
  weight: {calculated: 120 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs:
    L1: {at: [-1.6 m, 0 m, 4 m]}
    L2: {at: [ 0 m,   0 m, 4 m]}
    L3: {at: [ 1.6 m, 0 m, 4 m]}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 25 m], hoist: {speed: 0.2 m/s, acceleration: 0.1 m/s^2}}
equalizers:
  e1:
    hangs_from: hook
    heading: 0 deg
    frame: {mass: 10 t, length: 5 m, width: 1.6 m, height: 3 m, centre_of_gravity_below_hook: 4 m, inertia_about_vertical: 20000 kg m^2}
    hinge: {axis: vertical, friction: 5 kN m, damping: 0 kN m s}
    rope: equalizing
    rope_ends:      {along: [-2 m, 2 m], below_hook: 5 m}
    fixed_sheaves:  {along: [-0.8 m, 0.8 m], below_hook: 5 m, pitch_diameter: 0.8 m}
    moving_sheaves: {along: [-1.6 m, 0 m, 1.6 m], below_hook: 7 m, pitch_diameter: 0.8 m, mass: 300 kg, guided: vertical}
    travel: {up: 0.5 m, down: 0.5 m, locked: true}
sling_defaults: {rope: sling}
slings:
  S1: {from: e1.1, to: block.L1, length: 12 m}
  S2: {from: e1.2, to: block.L2, length: 12.2 m}
  S3: {from: e1.3, to: block.L3, length: 12 m}
plan:
  - {step: look, hold: 20 s}
  - {step: pull, hold: 40 s, pull_pins: e1}
  - {step: end, hold: until_end}
"""  # noqa: E501
