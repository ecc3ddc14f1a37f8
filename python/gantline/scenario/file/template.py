"""The commented lift file that a new lift starts from."""

from __future__ import annotations

__all__ = ["template"]

_TEMPLATE = """\
# yaml-language-server: $schema=lift.schema.json
# A lift file of gantline. `gantline check FILE` says what is wrong with it, `gantline run FILE` simulates it,
# `gantline schema > lift.schema.json` writes the schema by which editors complete and check while typing.
# Every quantity has its unit: t, kg, kN, MN/m, m, mm, m/min, m/s^2, deg, %, kN m ...
format: 1

lift:
  title: My first lift
  number: L-001
  revision: "0"

duration: 60 s                       # time to simulate
start: rest                          # everything hangs and stands in equilibrium before the lift begins

ground: {level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m, acts_at: corners}

ropes:                               # kinds of rope: from the catalogue, or by 'axial_stiffness'
  sling_44: {construction: 6x36 IWRC, grade: 1960, diameter: 44 mm, damping_time: 10 ms}

shackles:
  wb40:
    working_load_limit: 40 t
    minimum_breaking_force: 1962 kN
    mass: 21 kg
    bow_diameter: 97 mm
    pin_diameter: 51 mm

load:
  name: block
  shape: {box: [8 m, 6 m, 3 m]}      # length x, breadth y, height z
  datum: bottom_centre               # positions on the load are measured from here, along its own axes
  position: [0 m, 0 m, 0 m]          # of the datum
  heading: 0 deg
  weight: {calculated: 60 t, contingency: 1.05, simulate: calculated}
  inertia: homogeneous               # or {xx: 225 t m^2, yy: 365 t m^2, zz: 500 t m^2}
  centre_of_gravity:
    at: [0.2 m, 0 m, 1.4 m]
    envelope: [0.2 m, 0.1 m, 0.1 m]  # plus and minus
  stands_on: ground
  lugs:
    L1: {at: [-3 m,  2 m, 3 m], main_plate: xz, capacity: 30 t}
    L2: {at: [ 3 m,  2 m, 3 m], main_plate: xz, capacity: 30 t}
    L3: {at: [ 3 m, -2 m, 3 m], main_plate: xz, capacity: 30 t}
    L4: {at: [-3 m, -2 m, 3 m], main_plate: xz, capacity: 30 t}

cranes:
  hook:
    type: fixed_hook                 # a hook that moves as told, no crane behind it
    at: [0.2 m, 0 m, 14.4 m]         # bearing point of the hook at the start; the slings hang slack
    rated_capacity: 100 t
    rating_includes_hook_block: false
    hoist: {speed: 5 m/min, creep: 0.3 m/min, acceleration: 0.05 m/s^2}

sling_defaults: {rope: sling_44, shackles: {top: wb40, bottom: wb40}, tolerance: 0.25 %}
slings:                              # length: effective, bearing to bearing, shackles included, unloaded
  S1: {from: hook, to: block.L1, length: 12.06 m}
  S2: {from: hook, to: block.L2, length: 11.96 m}
  S3: {from: hook, to: block.L3, length: 11.96 m}
  S4: {from: hook, to: block.L4, length: 12.06 m}

plan:
  - {step: take up slack, hoist: hook, speed: 1 m/min,   until: {load_transferred: 2 %}}
  - {step: look round,    hold: 5 s, report: [sling_tension]}
  - {step: lift off,      hoist: hook, speed: 0.3 m/min, until: {supports: clear}}
  - {step: clear,         hoist: hook, speed: 0.3 m/min, by: 0.1 m}
  - {step: hold point,    hold: until_end, report: [hook_load], require: {load_tilt: below 2 deg}}

# cases:                             # what may be otherwise; `gantline cases FILE` finds the worst
#   heavy:         {set: {load.weight.simulate: design}}
#   cog_corners:   {vary: load.centre_of_gravity.envelope, corners: all}
#   sling_lengths: {vary: slings.tolerance, pattern: worst_pair}

rules:                               # factors on loads and strengths; each of your own goes before the preset
  preset: nd_0027_onshore
  termination_factor: 1.12           # steel ferrules; aluminium 2.0

limits:                              # example figures; name the rule and edition that you work to
  rule: example
  load_tilt: 2 deg
  sling_angle_from_vertical: 30 deg
  sling_factor_on_breaking_force: 4.0
  smallest_sling_tension_when_clear: 10 kN
"""


def template() -> str:
    """Text of a commented lift file that is valid as it stands."""
    return _TEMPLATE
