"""Lift files of a column that is upended between a hook that stands and one at a boom that luffs along."""

from __future__ import annotations

import math

import numpy as np
from numpy.polynomial import Chebyshev

from gantline.results.recording import Recording
from gantline.results.variable import BoolArray, FloatArray
from lift_text import changed
from upending import COLUMN

#: Distance of the column's lugs, their height at the start, length of the boom, height of its heel pins [m].
LINE, LOW, BOOM, HEEL = 19.0, 30.0, 70.0, 10.0
#: Where the lug under the boom is at the start [m]; that under the other hook is at -19 m from there.
LUG = 9.5
#: Length of both slings [m].
SLING = 8.0
#: Acceleration of the hoist, and of the boom that follows [m/s^2, rad/s^2].
HOIST, LUFF = 0.05, math.radians(0.1)
#: Speed of the hoist [m/s].
SPEED = 4.0 / 60.0
#: Before anything moves [s].
WAIT = 10.0

_LIFT = (
    """\
format: 1
lift: {{title: A column between a hook and a boom}}
duration: {duration} s
start: rest
ropes:
  hoist: {{axial_stiffness: {rope} MN, damping_time: 10 ms, mass: none, diameter: 42 mm}}
  sling: {{axial_stiffness: {rope} MN, damping_time: 10 ms, mass: none}}
{ropes}cranes:
  far:
    type: fixed_hook
    at: [{far} m, 0 m, {high} m]
    rated_capacity: 100 t
    hoist: {{speed: 10 m/min, acceleration: {hoist} m/s^2}}
  fc:
    type: floating_crane
    position: [{heel} m, 0 m, 0 m]
    heading: {heading} deg
    boom:
      heel_pins: {{at: [0 m, 0 m, {pins} m], apart: 10 m}}
      length: {boom} m
      angle: {angle} deg
      mass: 200 t
    luffing:
      speed: 12 deg/min
      acceleration: {luff} deg/s^2
      range: [{least} deg, {most} deg]
{tackles}    hooks:
      B:
        height: {high} m
        block: {{mass: 5 t, height: 2 m}}
        reeving:
          {{parts_each: 4, rope: hoist, sheave_diameter: 1 m, below_head: 1 m, sheave_block_mass: 1 t}}
        drum: {{diameter: 1.6 m}}
        hoist: {{speed: 10 m/min, acceleration: {hoist} m/s^2}}
"""
    + COLUMN
    + """\
sling_defaults: {{rope: sling, length: {sling} m}}
slings:
  S1: {{from: far, to: column.a}}
  S2: {{from: fc.B, to: column.b}}
plan:
{plan}
simulation: {{sample_interval: 0.2 s{settings}}}
"""
)
#: Top of the tackles from the heel pins, along the boom from above and up [m].
TOP = (-20.0, 35.0)
_TACKLES = f"""\
      tackles: {{count: 2, parts: 12, rope: luff, from: [{TOP[0]} m, 3 m, {HEEL + TOP[1]} m]}}
"""


def heel_of(angle: float, *, inwards: bool) -> float:
    """Where the heel pins are so that the head is over its lug [m].

    The lug comes nearer to the far hook: a boom that points away from that hook luffs in, one that points
    there luffs out.
    """
    reach = BOOM * math.cos(math.radians(angle))
    return LUG - reach if inwards else LUG + reach


def by_a_boom(
    plan: str,
    *,
    inwards: bool,
    angle: float,
    duration: float = 300.0,
    rope: float = 2e5,
    within: tuple[float, float] = (15.0, 85.0),
    tackles: bool = False,
    settings: str = "",
) -> str:
    """A column that hangs level and plumb from the fixed hook `far`, in the west, and `fc.B` at a boom.

    Args:
        plan: One step per line, not indented.
        inwards: Whether the crane stands in the west, so that its boom luffs in, or beyond the lug.
        angle: Of the boom at the start [deg].
        duration: Of the lift [s].
        rope: EA of hoist ropes and slings [MN].
        within: Range of luffing [deg].
        tackles: Whether the boom hangs in ropes.
        settings: More keys of `simulation`, after a comma.
    """
    return _LIFT.format(
        plan="\n".join(f"  - {line}" for line in plan.splitlines()),
        duration=duration,
        rope=rope,
        ropes="  luff: {axial_stiffness: 2000 MN, damping_time: 10 ms, mass: none}\n" if tackles else "",
        far=LUG - LINE,
        high=LOW + SLING,
        heel=heel_of(angle, inwards=inwards),
        heading=0.0 if inwards else 180.0,
        pins=HEEL,
        boom=BOOM,
        angle=angle,
        hoist=HOIST,
        luff=math.degrees(LUFF),
        least=within[0],
        most=within[1],
        tackles=_TACKLES if tackles else "",
        sling=SLING,
        settings=settings,
    )


#: From the aft end of the barge of `afloat` to the heel pins [m].
_ON_BARGE = 70.0
_BARGE = """\
water: {{density: 1025 kg/m^3, level: 0 m}}
vessels:
  barge:
    position: [{aft} m, 0 m]
    heading: 0 deg
    draft: 4 m
    hull: {{box: [80 m, 32 m, 8 m]}}
    masses: {{hull: {{mass: 9000 t, at: [36 m, 0 m, 4 m]}}}}
    radii_of_gyration: [11 m, 24 m, 24 m]
    added_mass: {{heave: 12000 t, at: [40 m, 0 m, 0 m]}}
    water_damping: {{critical: {{heave: 20 %, surge: 5 %, periods: {{surge: 60 s}}}}}}
cranes:
"""


def afloat(lift: str, *, angle: float) -> str:
    """The same crane, luffing in and in tackles, on a barge that only its waterplane holds in pitch."""
    stands = heel_of(angle, inwards=True)
    return changed(
        lift,
        (f"    position: [{stands} m, 0 m, 0 m]\n    heading: 0.0 deg\n", "    vessel: barge\n"),
        ("cranes:\n", _BARGE.format(aft=stands - _ON_BARGE)),
        (f"at: [0 m, 0 m, {HEEL} m], apart", f"at: [{_ON_BARGE} m, 0 m, {HEEL} m], apart"),
        (f"from: [{TOP[0]} m", f"from: [{_ON_BARGE + TOP[0]} m"),
    )


def luffed_along(by: float, *, hoist: float = 4.0, follow: float = 12.0) -> str:
    """A plan in which hook `far` hoists [m, m/min], and the boom follows with so much at most [deg/min]."""
    beside = f"starts: with_previous, speed: {follow} deg/min"
    return "\n".join(
        [
            f"{{step: wait, hold: {WAIT} s}}",
            f"{{step: upend, hoist: far, speed: {hoist} m/min, by: {by} m}}",
            f"{{step: follow, luff: fc, {beside}, keep_plumb: fc.B}}",
            "{step: rest, hold: 20 s}",
        ]
    )


def boom_by_circles(hoisted: FloatArray, angle: float, *, inwards: bool) -> FloatArray:
    """Angle of the boom [rad] with plumb falls, the other lug hoisted by so much [m] from level."""
    across = LUG - LINE - heel_of(angle, inwards=inwards)
    high = hoisted + BOOM * math.sin(math.radians(angle))  # over the heel pins, let down by the falls
    apart = np.hypot(across, high)
    between = np.arccos((BOOM**2 + apart**2 - LINE**2) / (2 * BOOM * apart))
    to_head: FloatArray = np.arctan2(high, across) - between
    return to_head if inwards else math.pi - to_head


def way_by_circles(angle: float, *, inwards: bool, by: float) -> Chebyshev:
    """The same as a polynomial; its derivatives are those of the circles to 1e-8 and better."""
    return Chebyshev.interpolate(lambda up: boom_by_circles(up, angle, inwards=inwards), 40, [-0.5, by + 0.5])


def steady(recording: Recording, by: float) -> BoolArray:
    """While the hook hoists steadily."""
    during: BoolArray = (recording.time > WAIT + 10.0) & (recording.time < WAIT + by / SPEED)
    return during


def hoisted(recording: Recording) -> FloatArray:
    """How far the other hook has been hoisted [m]."""
    height = recording.column("body_position", "far")[:, 2]
    up: FloatArray = height - height[0]
    return up
