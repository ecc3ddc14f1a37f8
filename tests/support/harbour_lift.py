"""A lift from a quay: a floating crane in a basin lifts a deckhouse beside a crawler crane."""

from __future__ import annotations

#: The lift file: every kind of row that the first page has of lifts afloat and of cranes with a boom.
HARBOUR_LIFT = """\
format: 1
lift: {number: FC-1, revision: A, title: Floating crane lifts a deckhouse from the quay}
duration: 260 s
water: {density: 1025 kg/m^3, level: 0 m}
ground: {level: 3.5 m, friction: 0.5, stiffness: 2000 MN/m, damping: 20 MN s/m}
structures:
  basin: {type: dock, x: [-70 m, 118 m], y: [-60 m, 60 m], floor: -12 m}
ropes:
  sling: {axial_stiffness: 300 MN, damping_time: 5 ms, mass: none, diameter: 90 mm,
      minimum_breaking_force: 6000 kN}
  hoist: {axial_stiffness: 200 MN, damping_time: 10 ms, mass: none, diameter: 54 mm}
  luff: {axial_stiffness: 238 MN, damping_time: 10 ms, mass: none, diameter: 72 mm,
      minimum_breaking_force: 3617 kN}
  moor_44: {axial_stiffness: 60 MN, damping_time: 10 ms, mass: 8 kg/m, diameter: 44 mm,
      minimum_breaking_force: 1200 kN}
load:
  name: deckhouse
  shape: {box: [20 m, 16 m, 12 m]}
  datum: bottom_centre
  position: [153 m, 0 m, 3.5 m]
  heading: 0 deg
  weight: {calculated: 600 t, contingency: 1.0}
  inertia: homogeneous
  centre_of_gravity: {at: [0 m, 0 m, 5 m]}
  stands_on: ground
  lugs: {A: {at: [8 m, 6 m, 12 m]}, B: {at: [8 m, -6 m, 12 m]}, C: {at: [-8 m, 6 m, 12 m]},
      D: {at: [-8 m, -6 m, 12 m]}}
hook_types:
  H:
    rated_capacity: 900 t
    block: {mass: 50 t, height: 3 m}
    reeving: {ropes: 2, parts_each: 16, rope: hoist, sheave_diameter: 1.2 m, below_head: 1.3 m,
        sheave_block_mass: 8 t}
    drum: {diameter: 1.6 m}
    hoist: {speed: 3 m/min, acceleration: 0.005 m/s^2}
  H2:
    rated_capacity: 400 t
    block: {mass: 7 t, height: 2 m}
    reeving: {parts_each: 14, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m, sheave_block_mass: 1 kg}
    drum: {diameter: 0.8 m}
    hoist: {speed: 6 m/min, acceleration: 0.02 m/s^2}
vessels:
  barge:
    position: [0 m, 0 m]
    draft: 4.18 m
    trim: 1.46 deg
    hull: {box: [105.6 m, 46 m, 7.5 m]}
    masses:
      hull: {mass: 6800 t, at: [50 m, 0 m, 5.0 m]}
      accommodation: {mass: 900 t, at: [22 m, 0 m, 12 m]}
      winches: {mass: 700 t, at: [35 m, 0 m, 9.5 m]}
      a_frame: {mass: 700 t, at: [70 m, 0 m, 32 m]}
    radii_of_gyration: [15 m, 28.5 m, 30 m]
    tanks:
      aft.1: {box: [26.4 m, 22 m, 7.5 m], bottom: [13.2 m, 11 m, 0 m], content: 1650 t}
      aft.2: {box: [26.4 m, 22 m, 7.5 m], bottom: [13.2 m, -11 m, 0 m], content: 1650 t}
      mid.1: {box: [26.4 m, 22 m, 7.5 m], bottom: [39.6 m, 11 m, 0 m], content: 3200 t}
      mid.2: {box: [26.4 m, 22 m, 7.5 m], bottom: [39.6 m, -11 m, 0 m], content: 3200 t}
    added_mass: {at: [52.8 m, 0 m, 0 m], surge: 1100 t, sway: 5000 t, heave: 85000 t, roll: 7.5e6 t m^2,
        pitch: 6.3e7 t m^2, yaw: 5e6 t m^2}
    water_damping: {critical: {surge: 20 %, sway: 20 %, heave: 20 %, roll: 6 %, pitch: 12 %, yaw: 20 %,
        periods: {surge: 60 s, sway: 60 s, yaw: 60 s}}}
mooring_lines:
  bow.ps: {vessel: barge, fairlead: [104 m, 20 m, 7.5 m], to: [125 m, 45 m, 3.5 m], rope: moor_44,
      pretension: 150 kN, type: spring}
  bow.sb: {vessel: barge, fairlead: [104 m, -20 m, 7.5 m], to: [125 m, -45 m, 3.5 m], rope: moor_44,
      pretension: 150 kN, type: spring}
  stern.ps: {vessel: barge, fairlead: [2 m, 20 m, 7.5 m], to: [-50 m, 65 m, 3.5 m], rope: moor_44,
      pretension: 150 kN, type: spring}
  stern.sb: {vessel: barge, fairlead: [2 m, -20 m, 7.5 m], to: [-50 m, -65 m, 3.5 m], rope: moor_44,
      pretension: 150 kN, type: spring}
cranes:
  fc:
    type: floating_crane
    vessel: barge
    rated_capacity: 3600 t
    rating_includes_hook_block: true
    outreach_from: 105.6 m
    boom: {heel_pins: {at: [98 m, 0 m, 9 m], apart: 28 m}, length: 110 m, angle: 60 deg, mass: 1500 t,
        centre_of_gravity: 48 %, inertia: 1.51e6 t m^2, head_gear: 140 t}
    luffing: {speed: 0.5 deg/min, acceleration: 0.005 deg/s^2, range: [40 deg, 80 deg],
        tackles: {count: 4, parts: 16, rope: luff, from: [70 m, 8 m, 62 m]}}
    rating: {outreach: [20 m, 45 m, 60 m], rated: [3600 t, 1500 t, 900 t], heel: 1.5 deg, trim: 3 deg,
        off_lead: 2 deg, side_lead: 1 deg}
    hooks:
      H1: {type: H, height: 38 m}
  c1:
    type: crawler
    position: [140 m, -40 m]
    heading: 0 deg
    slew: 60 deg
    rating_includes_hook_block: true
    tracks: {length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m, allowed_pressure: 150 kPa,
        stiffness: 200 MN/m}
    base_mass: 190 t
    central_ballast: 95 t
    counterweight: {mass: 250 t, behind: 6.5 m}
    boom: {heel_pins: {ahead: 1.6 m, height: 2.5 m}, length: 63 m, radius: 16 m, mass: 60 t,
        centre_of_gravity: 45 %}
    luffing: {speed: 3 deg/min, acceleration: 0.02 deg/s^2, range: [30 deg, 82 deg]}
    slewing: {speed: 0.3 rev/min, acceleration: 0.1 deg/s^2}
    rating: {radius: [12 m, 14 m, 16 m, 18 m, 20 m, 24 m, 28 m], rated: [360 t, 283 t, 231 t, 195 t,
        168 t, 130 t, 104 t], off_lead: 1 deg, side_lead: 1 deg}
    hooks:
      H: {type: H2, height: 40 m}
slings:
  A: {from: fc.H1, to: deckhouse.A, length: 25.70 m, rope: sling}
  B: {from: fc.H1, to: deckhouse.B, length: 25.70 m, rope: sling}
  C: {from: fc.H1, to: deckhouse.C, length: 25.70 m, rope: sling}
  D: {from: fc.H1, to: deckhouse.D, length: 25.70 m, rope: sling}
plan:
  - {step: take up slack, hoist: [fc.H1], speed: 1 m/min, until: {load_transferred: 50 %}}
  - {step: hold point, hold: 20 s}
  - {step: lift off, hoist: [fc.H1], speed: 1 m/min, until: {load_transferred: 99.9 %}}
  - {step: clear, hoist: [fc.H1], speed: 3 m/min, by: 2 m}
  - {step: ballast, pump: {from: barge.mid.1, to: barge.aft.1}, rate: 3600 t/h, by: 20 t}
  - {step: hold, hold: until_end}
limits: {heel: 2 deg, trim: 3 deg, freeboard: 1 m}
"""
