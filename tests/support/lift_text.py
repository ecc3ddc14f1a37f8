"""Small lift files that tests spoil in one place at a time."""

from __future__ import annotations

import re

BASE = """\
format: 1
lift:
  title: A test lift
duration: 20 s
start: rest
ground: {level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 2 ms, mass: none}
  thick: {axial_stiffness: 100 MN, damping_time: 2 ms}
shackles:
  wb40: {working_load_limit: 40 t, mass: 0 kg}
load:
  name: block
  shape: {box: [8 m, 6 m, 3 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 60 t, contingency: 1.05}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  stands_on: ground
  lugs:
    L1: {at: [-3 m, 0 m, 3 m], capacity: 40 t}
    L2: {at: [ 3 m, 0 m, 3 m], capacity: 40 t}
    L3: {at: [ 0 m, 0 m, 3 m], capacity: 40 t}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 20 m]
    rated_capacity: 100 t
    hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}
equalizers:
  e1:
    hangs_from: hook
    frame: {mass: 5 t, length: 4 m, width: 1 m, height: 2 m, centre_of_gravity_below_hook: 2 m}
    hinge: {damping: 1 kN m s}
    rope: thick
    rope_ends: {along: [-1.2 m, 1.2 m], below_hook: 3 m}
    fixed_sheaves: {along: [0 m], below_hook: 3 m, pitch_diameter: 0.8 m}
    moving_sheaves: {along: [-0.8 m, 0.8 m], below_hook: 5 m, pitch_diameter: 0.8 m, mass: 200 kg}
    travel: {up: 1 m, down: 1 m}
slings:
  S1: {from: e1.1, to: block.L1, length: 13 m, rope: sling, shackles: {top: wb40, bottom: wb40}}
  S2: {from: e1.2, to: block.L2, length: 13 m, rope: sling, tolerance: 0.25 %}
plan:
  - {step: hoist, hoist: hook, speed: 3 m/min, start_at: 0 s, brake_from: 10 s}
  - {step: hold, hold: until_end}
limits: {rule: example, load_tilt: 2 deg}
simulation: {integrator: del, step: 1 ms, sample_interval: 20 ms}
"""

#: A section for `BASE`, with every kind of case that it can have.
CASES = """\
cases:
  heavy: {set: {load.weight.simulate: design, load.weight.contingency: 1.1}}
  hook_level: {vary: {cranes.hook.at.z: [-0.2 m, 0.2 m], cranes.hook.at.x: [10 mm]}}
  lengths: {vary: slings.tolerance, pattern: worst, remark: as bought}
  sling_cut: {cut: [S1], at_step: hold, after: 1 s}
  both_cut: {cut: [S1, S2], at: 15 s}
"""

MECHANICS = """\
format: 1
lift: {title: A weight on a rope}
duration: 2 s
ropes:
  ideal: {inextensible: true}
mechanics:
  bodies:
    beam: {at: [0 m, 0 m, 5 m], joint: {type: fixed}}
    left: {parent: beam, at: [-0.2 m, 0 m, -3 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 10 kg}
    right: {parent: beam, at: [0.2 m, 0 m, -3 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 11 kg}
  ropes:
    rope:
      rope: ideal
      length: as_routed
      route:
        - {type: end, body: left}
        - {type: half_turn, body: beam, enter: [-0.2 m, 0 m, 0 m], leave: [0.2 m, 0 m, 0 m], bulge: [0, 0, 1]}
        - {type: end, body: right}
  contacts:
    foot: {body: right, at: [0 m, 0 m, -1 m], plane: {normal: [0, 0, 1]}, stiffness: 1 MN/m}
"""


AFLOAT = """\
format: 1
lift: {title: A barge}
duration: 10 s
water: {density: 1025 kg/m^3, level: 0 m}
vessels:
  barge:
    position: [10 m, 0 m]
    heading: 30 deg
    draft: 4 m
    heel: 1 deg
    hull: {box: [100 m, 30 m, 8 m]}
    masses:
      hull: {mass: 12000 t, at: [50 m, 0 m, 5 m]}
    radii_of_gyration: [11 m, 27 m, 27 m]
    tanks:
      port: {box: [20 m, 10 m, 7 m], bottom: [40 m, 9 m, 0 m], content: 300 t}
    added_mass: {heave: 15000 t, at: [50 m, 0 m, 0 m]}
    water_damping: {critical: {heave: 20 %, surge: 5 %, periods: {surge: 60 s}}}
    openings: {hatch: [70 m, 0 m, 9 m]}
limits: {heel: 3 deg, trim: 2 deg, freeboard: 1 m}
plan:
  - {step: look, hold: 5 s, require: {heel: below 2 deg}}
"""


def spoiled(old: str, new: str, base: str = BASE) -> str:
    """The base with one piece replaced; the piece stands there exactly once."""
    assert base.count(old) == 1, f"{old!r} stands {base.count(old)} times in the lift"
    return base.replace(old, new)


def changed(text: str, *changes: tuple[str, str]) -> str:
    """A lift with several pieces replaced, one after the other, wherever they stand; none is missing."""
    for old, new in changes:
        assert old in text, f"{old!r} does not stand in the lift"
        text = text.replace(old, new)
    return text


def without(text: str, *sections: str) -> str:
    """A lift file without some of its sections."""
    for name in sections:
        found = re.search(rf"^{name}:.*\n(?: .*\n|\n)*", text, re.M)
        assert found is not None, name
        text = text[: found.start()] + text[found.end() :]
    return text


#: A lift that cannot go on: it is refused by its equations at the start.
DEAD_CENTRE = """
format: 1
lift: {title: A plumb rope cannot hold what slides level}
duration: 2 s
ropes:
  thin: {inextensible: true}
mechanics:
  bodies:
    ceiling: {joint: {type: fixed}}
    trolley: {at: [0 m, 0 m, -5 m], joint: {type: slider, axis: [1, 0, 0]}, mass: 40 kg}
  ropes:
    plumb: {rope: thin, length: 5 m, route: [{type: end, body: ceiling}, {type: end, body: trolley}]}
"""
# The part between dead end and sheave shrinks to nothing and turns round: the force jumps.
PAST_THE_END = """
format: 1
lift: {title: A moving sheave falls past the dead end of its rope}
duration: 2 s
simulation: {sample_interval: 50 ms, tension_tolerance: 1 N}
ropes:
  stiff: {axial_stiffness: 1e5 MN, damping_time: 10 ms}
mechanics:
  bodies:
    post: {joint: {type: fixed}}
    sheave: {at: [0 m, 0 m, 2 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 300 kg}
  ropes:
    fall:
      rope: stiff
      length: 11.2 m
      route:
        - {type: end, body: post, at: [-0.4 m, 0 m, 0 m]}
        - {type: half_turn, body: sheave, enter: [-0.4 m, 0 m, 0 m], leave: [0.4 m, 0 m, 0 m],
           bulge: [0, 0, -1]}
        - {type: end, body: post, at: [0.4 m, 0 m, 10 m]}
"""

#: A mass on two mooring lines, one of them on the sea bed and on a winch.
MOORED = """\
format: 1
lift:
  title: A moored barge
duration: 20 s
ropes:
  moor_44: {construction: 6x36 IWRC, grade: 1960, diameter: 44 mm}
  bare: {axial_stiffness: 90 MN}
mechanics:
  bodies:
    barge: {at: [0 m, 0 m, 10 m], mass: 1000 t, joint: {type: slider, axis: [1, 0, 0]}}
mooring_lines:
  bow:
    vessel: barge
    fairlead: [0 m, 0 m, 0 m]
    to: [100 m, 0 m, -15 m]
    rope: moor_44
    length: 104 m
    sea_bed: -15 m
    winch: {speed: 5 m/min, acceleration: 0.01 m/s^2}
  stern: {vessel: barge, fairlead: [0 m, 0 m, 0 m], to: [-100 m, 0 m, 5 m], rope: moor_44, pretension: 150 kN}
fenders:
  f1: {vessel: barge, at: [0 m, 0 m, -5 m], wall: [-1 m, 0 m], facing: 0 deg, stiffness: 5 MN/m}
plan:
  - {step: haul, haul: bow, speed: 3 m/min, by: 0.2 m}
"""


def weight_on_a_rope(mass: str) -> str:
    """The text of a lift of a second: a weight of this mass on 5 m of rope of 1 MN."""
    return f"""\
format: 1
lift: {{title: A weight on a rope}}
duration: 1 s
ropes: {{thin: {{axial_stiffness: 1 MN, damping_time: 10 ms}}}}
mechanics:
  bodies:
    weight: {{joint: {{type: slider, axis: [0, 0, 1]}}, mass: {mass}}}
  ropes:
    rope:
      rope: thin
      length: 5 m
      route: [{{type: end, body: world, at: [0 m, 0 m, 5 m]}}, {{type: end, body: weight}}]
"""
