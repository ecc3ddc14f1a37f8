"""Lift files of a column that is upended between two trolleys of a Goliath crane, or by crawler cranes."""

from __future__ import annotations

from crawler_pair import GEAR, MASSES
from lift_text import changed

#: Distance of the column's two lugs, height of the upper sheaves [m].
LINE, TOP = 19.0, 80.0
#: Acceleration of the hoist and of the trolley that may follow [m/s^2].
HOIST, TRAVERSE = 0.05, 0.05
#: Before anything moves [s].
WAIT = 10.0

#: The column of every lift here and in `luffing_along`, and where it lies at the start.
COLUMN = """\
load:
  name: column
  shape: {{box: [20 m, 3 m, 3 m]}}
  position: [0 m, 0 m, 28.5 m]
  weight: {{calculated: 100 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  lugs: {{a: {{at: [-9.5 m, 0 m, 1.5 m]}}, b: {{at: [9.5 m, 0 m, 1.5 m]}}}}
"""
_TROLLEYS = (
    """\
format: 1
lift: {{title: A column between two trolleys}}
duration: {duration} s
start: {start}
ropes:
  hoist: {{axial_stiffness: {rope} MN, damping_time: 10 ms, mass: none, diameter: 42 mm}}
  sling: {{axial_stiffness: {rope} MN, damping_time: 10 ms, mass: none}}
hook_types:
  H:
    highest: 75 m
    block: {{mass: 5 t, height: 2 m}}
    reeving: {{parts_each: 4, rope: hoist, sheave_diameter: 1 m, upper_sheaves_at: {top} m}}
    drum: {{diameter: 1.6 m}}
    hoist: {{speed: 10 m/min, acceleration: {hoist} m/s^2, emergency_acceleration: 0.2 m/s^2}}
cranes:
  gol:
    type: goliath
    span: 148 m
    girder: {{underside: 78 m, mass: 2600 t}}
    legs: {{fixed: 700 t, hinged: 450 t, bogies: 700 t, base: 32 m}}
    trolleys:
      one:
        mass: 100 t
        position: {west} m
        traverse: {{speed: 10 m/min, acceleration: {traverse} m/s^2, range: [-60 m, 60 m]}}
        hooks: {{A: {{type: H, height: {high_a} m}}}}
      two:
        mass: 100 t
        position: 9.5 m
        traverse: {{speed: 10 m/min, acceleration: {traverse} m/s^2, range: [{least} m, 60 m]}}
        hooks: {{B: {{type: H, height: {high_b} m}}}}
"""
    + COLUMN
    + """\
sling_defaults: {{rope: sling}}
slings:
  S1: {{from: gol.A, to: column.a, length: {sling_a} m}}
  S2: {{from: gol.B, to: column.b, length: {sling_b} m}}
plan:
{plan}
simulation: {{sample_interval: 0.2 s{settings}}}
"""
)


def between_trolleys(
    plan: str,
    *,
    duration: float = 300.0,
    slings: tuple[float, float] = (8.0, 8.0),
    west: float = -9.5,
    least: float = -60.0,
    start: str = "rest",
    rope: float = 200.0,
    settings: str = "",
) -> str:
    """A column that hangs level and plumb from hook A of trolley `one`, in the west, and hook B of `two`.

    Args:
        plan: One step per line, not indented.
        duration: Of the lift [s].
        slings: Lengths of the slings [m].
        west: Where trolley `one` is [m]; plumb at -9.5.
        least: Least position of trolley `two` [m].
        start: How the lift starts.
        rope: EA of all ropes [MN].
        settings: More keys of `simulation`, after a comma.
    """
    return _TROLLEYS.format(
        plan="\n".join(f"  - {line}" for line in plan.splitlines()),
        duration=duration,
        top=TOP,
        hoist=HOIST,
        traverse=TRAVERSE,
        west=west,
        least=least,
        start=start,
        rope=rope,
        sling_a=slings[0],
        sling_b=slings[1],
        high_a=30.0 + slings[0],
        high_b=30.0 + slings[1],
        settings=settings,
    )


def upended(by: float = 17.0, *, hoist: float = 4.0, follow: float | None = 10.0) -> str:
    """A plan in which hook A hoists [m, m/min], and trolley `two` follows with so much at most [m/min]."""
    lines = [
        f"{{step: wait, hold: {WAIT} s}}",
        f"{{step: upend, hoist: gol.A, speed: {hoist} m/min, by: {by} m}}",
    ]
    if follow is not None:
        beside = f"starts: with_previous, speed: {follow} m/min"
        lines.append(f"{{step: follow, traverse: two, {beside}, keep_plumb: gol.B}}")
    return "\n".join([*lines, "{step: rest, hold: 20 s}"])


def below_a_bar(lift: str) -> str:
    """The same lift with a bar across the column between hook B and two lugs, as far down as before."""
    lugs = "b: {at: [9.5 m, 1.2 m, 1.5 m]}, c: {at: [9.5 m, -1.2 m, 1.5 m]}"
    return changed(
        lift,
        ("b: {at: [9.5 m, 0 m, 1.5 m]}", lugs),
        ("slings:\n", f"{_BAR}slings:\n"),
        ("  S2: {from: gol.B, to: column.b, length: 8.0 m}\n", _BELOW),
    )


_BAR = """\
spreaders:
  bar:
    mass: 3 t
    size: [2.8 m, 0.4 m, 0.4 m]
    lugs: {T1: {at: [1.2 m, 0 m, 0.2 m]}, T2: {at: [-1.2 m, 0 m, 0.2 m]},
      B1: {at: [1.2 m, 0 m, -0.2 m]}, B2: {at: [-1.2 m, 0 m, -0.2 m]}}
"""
#: 4 m over 1.2 m aside are 3.816 m down; with the bar and 3.784 m below it 8 m.
_BELOW = """\
  T1: {from: gol.B, to: bar.T1, length: 4 m}
  T2: {from: gol.B, to: bar.T2, length: 4 m}
  S2: {from: bar.B1, to: column.b, length: 3.784 m}
  S3: {from: bar.B2, to: column.c, length: 3.784 m}
"""

_CRANE = """\
  {name}:
    type: crawler
    position: [{x} m, 16 m]
    heading: {heading} deg
    slew: {slew} deg
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m}}
{masses}    luffing: {{speed: 3 deg/min, acceleration: 0.02 deg/s^2, range: [30 deg, 82 deg]}}
{travel}    hooks: {{H: {{type: H, height: 14 m}}}}
"""

_CRAWLERS = """\
format: 1
lift: {{title: A column and two crawler cranes}}
duration: {duration} s
{gear}load:
  name: column
  shape: {{box: [40 m, 4 m, 4 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 200 t}}
  inertia: homogeneous
  centre_of_gravity: {{at: [-2 m, 0 m, 2 m]}}
  stands_on: ground
  lugs: {{A: {{at: [-19 m, 2 m, 2 m]}}, B: {{at: [-19 m, -2 m, 2 m]}},
    C: {{at: [19 m, 2 m, 2 m]}}, D: {{at: [19 m, -2 m, 2 m]}}}}
cranes:
{cranes}sling_defaults: {{rope: sling, length: 12.4 m}}
slings:
  S1: {{from: main.H, to: column.A}}
  S2: {{from: main.H, to: column.B}}
  T1: {{from: tail.H, to: column.C}}
  T2: {{from: tail.H, to: column.D}}
plan:
{plan}
simulation: {{sample_interval: 0.2 s}}
"""

_TRAVEL = "    travel: {speed: 1 km/h, acceleration: 0.05 m/s^2, range: [-10 m, 50 m]}\n"


def by_crawlers(plan: str, *, duration: float = 900.0) -> str:
    """A column on the ground under two crawler cranes, of which `tail` may travel towards `main`.

    Args:
        plan: One step per line, not indented.
        duration: Of the lift [s].
    """
    both = (("main", -19, 0, ""), ("tail", 19, 180, _TRAVEL))
    cranes = "".join(
        _CRANE.format(name=name, x=x, heading=to, slew=-90 - to, masses=MASSES, travel=travel)
        for name, x, to, travel in both
    )
    shown = "\n".join(f"  - {line}" for line in plan.splitlines())
    return _CRAWLERS.format(duration=duration, gear=GEAR, cranes=cranes, plan=shown)
