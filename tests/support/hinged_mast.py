"""A mast that lies with its foot in a hinge, and is raised by a hook on its head."""

from __future__ import annotations

import math

from mechanics import G

MAST, FOOT, HEAD = 100e3, 18.0, 39.0
"""Mass [kg]; from the foot pins to the centre of gravity and to the lug, along the mast [m]."""
WEIGHT = MAST * G
#: Of a thin mast about its centre of gravity, and about its own axis [kg m^2].
ACROSS, ALONG = MAST * 40.0**2 / 12.0, MAST * 2.0
#: Place of its foot pins [m].
PINS = (-20.0, 0.0, 11.0)
#: A plan that raises it.
RAISE = """\
  - {step: raise, hoist: main, speed: 6 m/min, until: {load_tilt: {above: 89 deg}}}
  - {step: end, hold: until_end}
"""


def mast(
    plan: str, *, hook: tuple[float, float, float] = (-20.0, 0.0, 100.0), hinge: str = "", more: str = ""
) -> str:
    """A mast that lies 11 m high along x, its foot pins at (-20, 0, 11) m, its lug in a sling to a hook."""
    sling = math.dist(hook, (19.0, 0.0, 11.0))
    return f"""
format: 1
lift: {{title: A mast}}
duration: 900 s
start: rest
ropes: {{steel: {{axial_stiffness: 5 GN, damping_time: 10 ms, mass: none}}}}
load:
  name: mast
  shape: {{box: [40 m, 2 m, 2 m]}}
  position: [0 m, 0 m, 10 m]
  weight: {{calculated: {MAST} kg}}
  inertia: {{xx: {ALONG} kg m^2, yy: {ACROSS} kg m^2, zz: {ACROSS} kg m^2}}
  centre_of_gravity: {{at: [-2 m, 0 m, 1 m]}}
  lugs: {{A: {{at: [19 m, 0 m, 1 m], main_plate: xz}}}}
cranes:
  main: {{type: fixed_hook, at: [{hook[0]} m, {hook[1]} m, {hook[2]} m],
         hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
slings: {{A: {{from: main, to: mast.A, length: {sling!r} m, rope: steel}}}}
hinges: {{foot: {{at: [-20 m, 0 m, 1 m], axis: [0, 1, 0]{hinge}}}}}
plan:
{plan}
{more}
"""
