"""A girder of 40 t in two slings of a crawler crane whose chart rates 100 t at every radius."""

from __future__ import annotations

#: Girder and hook block [kg], and what the chart rates [kg]; slings and falls have no mass.
LOAD, HOOK_BLOCK, RATED = 40e3, 2e3, 100e3

_LIFT = """\
format: 1
lift: {{title: {title}}}
duration: {duration} s
ground: {{level: 0 m}}
ropes:
  sling: {{axial_stiffness: 100 MN, damping_time: 100 ms, mass: none, minimum_breaking_force: 3 MN}}
  hoist: {{axial_stiffness: 36 MN, damping_time: 200 ms, mass: none, diameter: 28 mm}}
load:
  name: girder
  shape: {{box: [10 m, 2 m, 2 m]}}
  position: [0 m, 14 m, 5 m]
  weight: {{{weight}}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs:
    W: {{at: [-4 m, 0 m, 2 m], capacity: 80 t}}
    E: {{at: [4 m, 0 m, 2 m], capacity: 80 t}}
cranes:
  crane:
    type: crawler
    position: [0 m, 0 m]
    heading: 0 deg
    slew: 90 deg
    rating_includes_hook_block: true
    tracks: {{length: 8 m, width: 1.2 m, gauge: 6.5 m, allowed_pressure: 300 kPa}}
    base_mass: 150 t
    counterweight: {{mass: 120 t, behind: 6 m}}
    boom: {{heel_pins: {{ahead: 1.3 m, height: 2.2 m}}, length: 42 m, radius: 14 m, mass: 22 t,
      centre_of_gravity: 45 %}}
    luffing: {{speed: 3 deg/min, acceleration: 0.05 deg/s^2, range: [30 deg, 82 deg]}}
    rating: {{radius: [10 m, 20 m], rated: [100 t, 100 t]}}
    hooks:
      H:
        block: {{mass: 2 t, height: 2 m}}
        reeving: {{parts_each: 8, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m,
          sheave_block_mass: 1 kg}}
        drum: {{diameter: 0.8 m}}
        hoist: {{speed: 4 m/min, acceleration: 0.05 m/s^2}}
        height: 11.925 m
slings:
  W: {{from: crane.H, to: girder.W, length: 6.4 m, rope: sling}}
  E: {{from: crane.H, to: girder.E, length: 6.4 m, rope: sling}}
"""


def girder_lift(title: str, duration: int, rest: str, weight: str = "calculated: 40 t") -> str:
    """A lift file.

    Args:
        title: of the lift.
        duration: [s].
        rest: what follows the slings: the plan, rules, `mechanics`.
        weight: keys of the girder's weight.
    """
    return _LIFT.format(title=title, duration=duration, weight=weight) + rest
