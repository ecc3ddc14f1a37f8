"""A beam of 20 t that is turned between two hooks, and let down again, without a hold as it slopes."""

from __future__ import annotations

import math

#: Half of the distance between lugs, lugs over the centre of gravity, slings [m], slope [rad].
HALF, ABOVE, SLINGS, SLOPE = 5.0, 3.0, 100.0, math.radians(35.0)
#: Load and what hook, lug and shackle may bear [t], contingency.
MASS, RATED, CONTINGENCY = 20.0, 14.5, 1.1
RAISED = 2.0 * HALF * math.sin(SLOPE)
HOOK = f"rated_capacity: {RATED} t, hoist: {{speed: 10 m/min, acceleration: 0.02 m/s^2}}"
LIFT = f"""\
format: 1
lift: {{title: A beam is turned and let down again}}
duration: 145 s
ground: {{level: 0 m, friction: 0.5}}
ropes:
  sling: {{axial_stiffness: 300 MN, mass: none, minimum_breaking_force: 3 MN, damping_time: 10 ms}}
shackles:
  wb: {{working_load_limit: {RATED} t, mass: 10 kg, bow_diameter: 60 mm, pin_diameter: 42 mm}}
load:
  name: beam
  shape: {{box: [10 m, 2 m, 4 m]}}
  weight: {{calculated: {MASS} t, contingency: {CONTINGENCY}}}
  centre_of_gravity: {{at: [0 m, 0 m, {4.0 - ABOVE} m]}}
  stands_on: ground
  lugs:
    W: {{at: [-{HALF} m, 0 m, 4 m], capacity: {RATED} t}}
    E: {{at: [{HALF} m, 0 m, 4 m], capacity: {RATED} t}}
cranes:
  W: {{type: fixed_hook, at: [-{HALF} m, 0 m, {4.0 + SLINGS} m], {HOOK}}}
  E: {{type: fixed_hook, at: [{HALF} m, 0 m, {4.0 + SLINGS} m], {HOOK}}}
sling_defaults: {{rope: sling, shackles: {{top: wb, bottom: wb}}}}
slings:
  W: {{from: W, to: beam.W, length: {SLINGS + 0.01} m}}
  E: {{from: E, to: beam.E, length: {SLINGS + 0.01} m}}
plan:
  - {{step: up,    hoist: [W, E], speed: 1 m/min, until: {{supports: clear}}}}
  - {{step: clear, hoist: [W, E], speed: 3 m/min, by: 0.5 m}}
  - {{step: level, hold: 10 s}}
  - {{step: turn,  hoist: E, speed: 10 m/min, by: {RAISED} m}}
  - {{step: back,  lower: E, speed: 10 m/min, by: {RAISED} m}}
  - {{step: end,   hold: until_end}}
limits: {{rule: yard, sling_factor_on_breaking_force: 5, load_tilt: 40 deg}}
"""
#: The same by two crawler cranes of which a chart rates the hook load, one at either end.
CRANE = """\
    type: crawler
    rating_includes_hook_block: false
    tracks: {length: 9 m, width: 1.5 m, gauge: 8.4 m, stiffness: 2000 MN/m}
    base_mass: 190 t
    central_ballast: 95 t
    counterweight: {mass: 250 t, behind: 6.5 m}
    boom: {heel_pins: {ahead: 1.6 m, height: 2.5 m}, length: 63 m, radius: 14 m, mass: 60 t}
    rating: {radius: [12 m, 16 m], rated: [14.5 t, 14.5 t], off_lead: 5 deg, side_lead: 5 deg}
    hooks: {H: {type: H, height: 24 m}}
"""
HOOK_TYPES = """\
hook_types:
  H:
    rated_capacity: 400 t
    block: {mass: 1 t, height: 2 m}
    reeving: {parts_each: 4, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m, sheave_block_mass: 1 kg}
    drum: {diameter: 0.8 m}
    hoist: {speed: 10 m/min, acceleration: 0.02 m/s^2}
"""
#: By moments about the lug W, of the design weight.
USED = MASS * CONTINGENCY * (0.5 + ABOVE * math.tan(SLOPE) / (2.0 * HALF)) / RATED


def by_crawlers() -> str:
    """The lift file of two crawler cranes that turn it."""
    head, _, rest = LIFT.partition("cranes:\n")
    tail = rest[rest.index("sling_defaults:") :]
    for name in "WE":
        tail = tail.replace(f"from: {name}", f"from: {name}.H").replace(
            f"hoist: {name},", f"hoist: {name}.H,"
        )
    tail = tail.replace("hoist: E,", "hoist: E.H,").replace("lower: E,", "lower: E.H,")
    tail = tail.replace("[W, E]", "[W.H, E.H]")
    tail = tail.replace(f"{SLINGS + 0.01}", "20.01").replace("0.5 m}", "0.5 m, acceleration: 0.01 m/s^2}")
    west = f"  W:\n    position: [-{HALF + 14.0} m, 0 m]\n{CRANE}"
    east = f"  E:\n    position: [{HALF + 14.0} m, 0 m]\n    heading: 180 deg\n{CRANE}"
    rope = "  hoist: {axial_stiffness: 36 MN, damping_time: 20 ms, mass: none, diameter: 28 mm}\n"
    head = head.replace("ropes:\n", f"ropes:\n{rope}")
    return f"{head}cranes:\n{west}{east}{HOOK_TYPES}{tail}"
