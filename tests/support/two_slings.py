"""A load in two slings to one place, of which one is cut: the other has all at once, and swings to 1.5 W."""

from __future__ import annotations

#: Weight [t], its contingency, and capacity of hook and lugs [t]; breaking force of a sling [kN].
LOAD, CONTINGENCY, RATED, BREAKS = 100.0, 1.1, 150.0, 2500.0
G = 9.81
LIFT = f"""\
format: 1
lift: {{title: Two slings to one place}}
duration: 30 s
start: rest
ropes:
  sling: {{axial_stiffness: 60 MN, damping_time: 1 ms, minimum_breaking_force: {BREAKS} kN, mass: none}}
shackles:
  shackle: {{working_load_limit: {RATED} t, mass: 0 kg}}
load:
  name: box
  shape: {{box: [4 m, 4 m, 4 m]}}
  position: [0 m, 0 m, 5 m]
  weight: {{calculated: {LOAD} t, contingency: {CONTINGENCY}, simulate: calculated}}
  centre_of_gravity: {{at: [0 m, 0 m, 2 m]}}
  lugs:
    A: {{at: [0 m, 0 m, 4 m], capacity: {RATED} t}}
    B: {{at: [0 m, 0 m, 4 m], capacity: {RATED} t}}
cranes:
  crane:
    {{type: fixed_hook, at: [0 m, 0 m, 30 m], rated_capacity: {RATED} t,
      hoist: {{speed: 4 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling, length: 20.95 m, shackles: {{top: shackle, bottom: shackle}}}}
slings:
  A: {{from: crane, to: box.A}}
  B: {{from: crane, to: box.B, cut_at: 10 s}}
plan:
  - {{step: hang, hold: until_end}}
limits: {{sling_factor_on_breaking_force: 1.6}}
simulation: {{sample_interval: 20 ms}}
"""
