"""Lifts with spreaders: one bar, two bars below one, a frame, a bar between two hooks."""

from __future__ import annotations

#: Simulated mass of the load and mass of a spreader [kg].
LOAD, BAR = 60e3, 3e3

_HEAD = """\
format: 1
lift: {title: Spreaders}
duration: 60 s
ground: {level: 0 m, friction: 0.5, stiffness: 200 MN/m, damping: 2 MN s/m}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 20 ms, mass: none, minimum_breaking_force: 2000 kN}
load:
  name: module
  shape: {box: [10 m, 6 m, 3 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 60 t, contingency: 1.05}
  centre_of_gravity: {at: [CENTRE m, 0 m, 1.5 m]}
  stands_on: ground
  lugs:
    L1: {at: [-4 m, 0 m, 3 m], capacity: 80 t}
    L2: {at: [4 m, 0 m, 3 m], capacity: 80 t}
    P1: {at: [-4 m, -2 m, 3 m], main_plate: yz, capacity: 40 t}
    P2: {at: [-4 m, 2 m, 3 m], main_plate: yz, capacity: 40 t}
    P3: {at: [4 m, -2 m, 3 m], main_plate: yz, capacity: 40 t}
    P4: {at: [4 m, 2 m, 3 m], main_plate: yz, capacity: 40 t}
cranes:
CRANES
sling_defaults: {rope: sling}
plan:
  - {step: hoist, hoist: HOISTED, by: 2 m, speed: 3 m/min}
  - {step: hold, hold: until_end}
limits: {rule: yard, load_tilt: 5 deg}
"""
_HOOK = """\
  NAME: {type: fixed_hook, at: [X m, 0 m, HEIGHT m], rated_capacity: 100 t,
    hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
"""
_BAR = """\
  bar:
    mass: 3 t
    size: [8.4 m, 0.4 m, 0.4 m]
    rated_capacity: 80 t
    lugs:
      A1: {at: [-4 m, 0 m, 0.2 m], capacity: 60 t}
      A2: {at: [4 m, 0 m, 0.2 m], capacity: 60 t}
      B1: {at: [-4 m, 0 m, -0.2 m], capacity: 60 t}
      B2: {at: [4 m, 0 m, -0.2 m], capacity: 60 t}
"""


def _head(height: float, centre: float = 0.3) -> str:
    crane = _HOOK.replace("NAME", "hook").replace("X m", "0 m").replace("HEIGHT", f"{height!r}")
    text = _HEAD.replace("CENTRE", f"{centre!r}").replace("CRANES\n", crane)
    return text.replace("HOISTED", "hook")


def one_bar(centre: float = 0.3) -> str:
    """Two slings to a bar, two plumb ones below it; the centre of gravity of the load is aside [m]."""
    return (
        _head(16.0, centre)
        + "spreaders:\n"
        + _BAR
        + """\
slings:
  up_1: {from: hook, to: bar.A1, length: 8 m}
  up_2: {from: hook, to: bar.A2, length: 8 m}
  down_1: {from: bar.B1, to: module.L1, length: 6 m}
  down_2: {from: bar.B2, to: module.L2, length: 6 m}
"""
    )


def two_below_one() -> str:
    """A bar along the load, two across it below its ends, four slings to four lugs."""
    across = """\
  NAME:
    mass: 1 t
    size: [0.3 m, 4.4 m, 0.3 m]
    heading: 0 deg
    lugs:
      A: {at: [0 m, 0 m, 0.15 m], main_plate: yz}
      B1: {at: [0 m, -2 m, -0.15 m], main_plate: yz}
      B2: {at: [0 m, 2 m, -0.15 m], main_plate: yz}
"""
    slings = """\
slings:
  up_1: {from: hook, to: bar.A1, length: 8 m}
  up_2: {from: hook, to: bar.A2, length: 8 m}
  mid_1: {from: bar.B1, to: left.A, length: 3 m}
  mid_2: {from: bar.B2, to: right.A, length: 3 m}
  down_1: {from: left.B1, to: module.P1, length: 3 m}
  down_2: {from: left.B2, to: module.P2, length: 3 m}
  down_3: {from: right.B1, to: module.P3, length: 3 m}
  down_4: {from: right.B2, to: module.P4, length: 3 m}
"""
    bars = "spreaders:\n" + _BAR + across.replace("NAME", "left") + across.replace("NAME", "right")
    return _head(16.5) + bars + slings


def frame(longer: float = 0.0) -> str:
    """Four slings to a frame, four plumb ones below it, the first of these longer by so much [m]."""
    spreader = """\
spreaders:
  frame:
    mass: 3 t
    size: [8.4 m, 4.4 m, 0.4 m]
    lugs:
      A1: {at: [-4 m, -2 m, 0.2 m]}
      A2: {at: [-4 m, 2 m, 0.2 m]}
      A3: {at: [4 m, -2 m, 0.2 m]}
      A4: {at: [4 m, 2 m, 0.2 m]}
      B1: {at: [-4 m, -2 m, -0.2 m]}
      B2: {at: [-4 m, 2 m, -0.2 m]}
      B3: {at: [4 m, -2 m, -0.2 m]}
      B4: {at: [4 m, 2 m, -0.2 m]}
"""
    lengths = {1: 6.0 + longer, 2: 6.0, 3: 6.0, 4: 6.0}
    slings = "slings:\n" + "".join(
        f"  up_{n}: {{from: hook, to: frame.A{n}, length: 8 m}}\n"
        f"  down_{n}: {{from: frame.B{n}, to: module.P{n}, length: {lengths[n]!r} m}}\n"
        for n in range(1, 5)
    )
    return _head(15.5, 0.0) + spreader + slings


def two_hooks() -> str:
    """A bar between two hooks, which go up together."""
    cranes = "".join(
        _HOOK.replace("NAME", name).replace("X m", f"{x} m").replace("HEIGHT", "12.3")
        for name, x in (("west", -4), ("east", 4))
    )
    text = _HEAD.replace("CENTRE", "0.3").replace("CRANES\n", cranes)
    text = text.replace("HOISTED", "[west, east]") + "spreaders:\n" + _BAR
    return (
        text
        + """\
slings:
  up_1: {from: west, to: bar.A1, length: 3 m}
  up_2: {from: east, to: bar.A2, length: 3 m}
  down_1: {from: bar.B1, to: module.L1, length: 6 m}
  down_2: {from: bar.B2, to: module.L2, length: 6 m}
"""
    )
