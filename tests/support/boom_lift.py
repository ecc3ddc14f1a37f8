"""Lift files of a floating crane with masses that hang in its hooks, and the geometry of its boom."""

from __future__ import annotations

import math

from gantline import Simulation
from gantline.results import Recording
from gantline.scenario import parse_scenario
from mechanics import G

#: Heel pins ahead of and above the base, length of the boom [m]: lift C's sheerleg.
HEEL, LENGTH = (98.0, 9.0), 110.0
#: Top of the A-frame, ahead of and above the base [m].
A_FRAME = (70.0, 62.0)
#: Masses of boom and head gear [kg], place of the boom's centre of gravity along it.
BOOM, HEAD_GEAR, CENTRE = 1500e3, 140e3, 0.48
#: Moment of inertia of boom and head gear about the heel pins [kg m^2].
BOOM_INERTIA = 1.51e9 + BOOM * (CENTRE * LENGTH) ** 2 + HEAD_GEAR * LENGTH**2
#: Mass of a hook block and of a sheave block at the head [kg], depth of the upper sheaves below the head [m].
HOOK_BLOCK, SHEAVE_BLOCK, BELOW = 50e3, 8e3, 1.3
#: Where outreach counts from [m]: the bow.
BOW = 105.6

_LIFT = """\
format: 1
lift: {{title: A boom}}
duration: {duration} s
start: {start}
ropes:
  hoist: {{axial_stiffness: {stiffness} MN, damping_time: 10 ms, mass: none, diameter: 54 mm}}
  luff: {{axial_stiffness: {luff_stiffness} MN, damping_time: {damping}, mass: none, diameter: 72 mm,
    minimum_breaking_force: 3617 kN}}
hook_types:
  H:
    rated_capacity: 900 t
    block: {{mass: 50 t, height: 3 m}}
    reeving: {{ropes: 2, parts_each: 16, rope: hoist, sheave_diameter: 1.2 m, below_head: 1.3 m,
      sheave_block_mass: 8 t}}
    drum: {{diameter: 1.6 m}}
    hoist: {{speed: 3 m/min, acceleration: 0.005 m/s^2}}
cranes:
  fc:
    type: floating_crane
    rated_capacity: 3600 t
    rating_includes_hook_block: true
    outreach_from: 105.6 m
{base}    boom: {{heel_pins: {{at: [98 m, 0 m, 9 m], apart: 28 m}}, length: 110 m, angle: {angle:g} deg,
      mass: 1500 t, centre_of_gravity: 48 %, inertia: 1.51e6 t m^2, head_gear: 140 t}}
{luffing}    hooks:
{hooks}
{more}mechanics:
  bodies:
{bodies}
{ropes}plan:
{plan}
simulation: {{tension_tolerance: {tolerance} N, position_tolerance: 0.001 mm, sample_interval: 0.1 s}}
"""

PRESCRIBED = "speed: 30 deg/min, acceleration: 0.05 deg/s^2, range: [40 deg, 80 deg]"
TACKLES = f"{PRESCRIBED}, tackles: {{count: 4, parts: 16, rope: luff, from: [70 m, 8 m, 62 m]}}"
STANDS = "    position: [0 m, 0 m, 0 m]\n"
ONE_HOOK = "H1: {type: H, height: 40 m}"
HUNG = "hung: {parent: fc.H1, joint: {type: fixed}, mass: 300 t}"
HOLD = "{step: hold, hold: until_end}"


def boom_lift(
    plan: str = HOLD,
    *,
    duration: float = 10.0,
    start: str = "as_given",
    angle: float = 60.0,
    base: str = STANDS,
    luffing: str = PRESCRIBED,
    hooks: str = ONE_HOOK,
    bodies: str = HUNG,
    ropes: str = "",
    stiffness: float = 1e4,
    luff_stiffness: float = 238.0,
    damping: str = "10 ms",
    more: str = "",
    tolerance: float = 1.0,
) -> str:
    """A lift file; `plan`, `hooks` and `bodies` have one item per line, not indented.

    Args:
        plan: Steps.
        duration: Of the lift [s].
        start: How it starts.
        angle: Of the boom at the start [deg].
        base: Further keys of the crane, a line each, indented.
        luffing: Keys of the luffing; it has none where this is empty.
        hooks: Hooks at the boom head.
        bodies: What hangs, bodies of `mechanics`.
        ropes: Further parts of `mechanics`.
        stiffness: EA of the hoist ropes [MN].
        luff_stiffness: EA of the luffing ropes [MN].
        damping: Damping time of the luffing ropes.
        more: Further sections.
        tolerance: Of tensions [N].
    """
    return _LIFT.format(
        duration=duration,
        start=start,
        angle=angle,
        base=base,
        luffing=f"    luffing: {{{luffing}}}\n" if luffing else "",
        hooks="\n".join(f"      {line}" for line in hooks.splitlines()),
        bodies="\n".join(f"    {line}" for line in bodies.splitlines()),
        ropes=ropes,
        plan="\n".join(f"  - {line}" for line in plan.splitlines()),
        stiffness=stiffness,
        luff_stiffness=luff_stiffness,
        damping=damping,
        more=more,
        tolerance=tolerance,
    )


def boom_afloat(draft: float, trim: float, **rest: str) -> str:
    """The crane on its vessel, with the middle of its waterline at x = 0."""
    turn = math.radians(trim)
    stern = -(105.6 / 2 * math.cos(turn) - draft * math.sin(turn))
    vessel = f"""\
vessels:
  barge:
    position: [{stern!r} m, 0 m]
    draft: {draft} m
    trim: {trim} deg
    hull: {{box: [105.6 m, 46 m, 7.5 m]}}
    masses: {{all: {{mass: 18852 t, at: [39 m, 0 m, 5 m]}}}}
    radii_of_gyration: [15 m, 28.5 m, 30 m]
"""
    return boom_lift(duration=0.1, base="    vessel: barge\n", more=vessel, **rest)  # type: ignore[arg-type]


def simulated(text: str) -> Recording:
    """Run a lift."""
    return Simulation(parse_scenario(text)).run()


def head(angle: float) -> tuple[float, float]:
    """Place of the boom's head ahead of the base's origin and above it [m]."""
    return HEEL[0] + LENGTH * math.cos(angle), HEEL[1] + LENGTH * math.sin(angle)


def tackle(angle: float) -> tuple[float, float, float]:
    """Of a tackle at an angle its length d, the lever of its pull, -dd/dangle [m], and d2d/dangle2 [m]."""
    back, up = A_FRAME[0] - HEEL[0], A_FRAME[1] - HEEL[1]
    ahead, high = LENGTH * math.cos(angle), LENGTH * math.sin(angle)
    length = math.hypot(ahead - back, high - up)
    lever = (ahead * up - high * back) / length
    # d2 = a2 + L2 - 2 a.h, so d d' = -a.h' and d d'' = a.h - d'^2
    return length, lever, (ahead * back + high * up - lever**2) / length


def weight_moment(angle: float, on_head: float) -> float:
    """Moment of boom, head gear and a further mass [kg] at the head about the heel pins [N m]."""
    return G * math.cos(angle) * LENGTH * (CENTRE * BOOM + HEAD_GEAR + on_head)
