"""A module of 40 t on the ground, four slings and a hook: more than hook and lugs may carry."""

from __future__ import annotations

CONTINGENCY, DYNAMIC = 1.15, 1.1
LIFT = f"""\
format: 1
lift: {{title: four slings lift a module}}
duration: 70 s
ground: {{friction: 0.5}}
ropes:
  sling: {{construction: 6x36 IWRC, grade: 1960, diameter: 44 mm, damping_time: 10 ms}}
load:
  name: module
  shape: {{box: [6 m, 4 m, 3 m]}}
  weight: {{calculated: 40 t, contingency: {CONTINGENCY}}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs:
    A: {{at: [-2.5 m,  1.5 m, 3 m], capacity: 13.2 t}}
    B: {{at: [ 2.5 m,  1.5 m, 3 m], capacity: 13.2 t}}
    C: {{at: [-2.5 m, -1.5 m, 3 m], capacity: 13.2 t}}
    D: {{at: [ 2.5 m, -1.5 m, 3 m], capacity: 13.2 t}}
cranes:
  crane:
    {{type: fixed_hook, at: [0 m, 0 m, 11 m], rated_capacity: 46 t,
     hoist: {{speed: 3 m/min, acceleration: 0.05 m/s^2}}}}
slings:
  A: {{from: crane, to: module.A, length: 8.6 m, rope: sling}}
  B: {{from: crane, to: module.B, length: 8.6 m, rope: sling}}
  C: {{from: crane, to: module.C, length: 8.6 m, rope: sling}}
  D: {{from: crane, to: module.D, length: 8.6 m, rope: sling}}
plan:
  - {{step: lift off, hoist: crane, speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: hoist, hoist: crane, speed: 3 m/min, by: 0.2 m}}
  - {{step: hold point, hold: 20 s}}
rules: {{dynamic_amplification_factor: {DYNAMIC}}}
"""
#: The same load, handed over to a second hook with slings of its own, and left there.
HANDED_OVER = LIFT.replace(
    "slings:\n",
    """\
  second: {type: fixed_hook, at: [0 m, 0 m, 11.01 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
slings:
  A2: {from: second, to: module.A, length: 8.7 m, rope: sling}
  B2: {from: second, to: module.B, length: 8.7 m, rope: sling}
  C2: {from: second, to: module.C, length: 8.7 m, rope: sling}
  D2: {from: second, to: module.D, length: 8.7 m, rope: sling}
""",
).replace(
    "rules:",
    """\
  - {step: take over, hoist: second, speed: 3 m/min, by: 0.5 m}
  - {step: let go, lower: crane, speed: 1 m/min, by: 0.1 m}
  - {step: let it hang, hold: until_end}
rules:""",
)
