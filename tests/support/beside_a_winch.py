"""A load that a third hook takes over, beside a winch of constant tension under `mechanics`."""

from __future__ import annotations

LIFT = """\
format: 1
lift: {title: A third hook takes over beside a winch}
duration: 150 s
simulation: {sample_interval: 50 ms}
ground: {level: 0 m}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, mass: none}
  tag: {axial_stiffness: 1 MN, damping_time: 50 ms, mass: none}
load:
  name: module
  shape: {box: [10 m, 3 m, 3 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 40 t, contingency: 1.1}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  stands_on: ground
  lugs:
    L1: {at: [-4 m, 0 m, 3 m], main_plate: xz, capacity: 80 t}
    L2: {at: [4 m, 0 m, 3 m], main_plate: xz, capacity: 23 t}
    L3: {at: [0 m, 0 m, 3 m], main_plate: xz, capacity: 80 t}
cranes:
  H1: {type: fixed_hook, at: [-4 m, 0 m, 12.99 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
  H2: {type: fixed_hook, at: [4 m, 0 m, 12.99 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
  H3: {type: fixed_hook, at: [0 m, 0 m, 12.99 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
slings:
  S1: {from: H1, to: module.L1, length: 10 m, rope: sling}
  S2: {from: H2, to: module.L2, length: 10 m, rope: sling}
  S3: {from: H3, to: module.L3, length: 10.1 m, rope: sling}
mechanics:
  drums:
    winch:
      diameter: 0.8 m
      rotating_mass: 100 kg
      drive: {speed: 0.5 m/s, acceleration: 0.5 m/s^2, capacity: 1 kN}
  ropes:
    tag:
      rope: tag
      length: as_routed
      route:
        - {type: end, body: module, at: [0 m, 1.5 m, 0 m]}
        - {type: end, body: world, at: [0 m, 40 m, 1 m], drum: winch}
plan:
  - {step: pull, haul_in: winch, speed: 0.5 m/s, by: 72.5 m}
  - {step: up, hoist: [H1, H2], speed: 3 m/min, by: 2 m, starts: with_previous}
  - {step: take over, hoist: H3, speed: 3 m/min, by: 2.12 m, start_at: 60 s, starts: with_previous}
  - {step: end, hold: 3 s}
rules: {dynamic_amplification_factor: 1.1}
"""
