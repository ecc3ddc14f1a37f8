"""Lift files of a crawler crane (600 t class) with a mass that hangs in its hook, and its hand figures."""

from __future__ import annotations

import math

#: Masses [kg] and places [m] of lifts.md 7.1: base machine, central ballast, counterweight, boom; heel of the
#: boom ahead of the slewing axis and above the ground; its centre of gravity along it.
BASE, BALLAST, WEIGHT, BOOM = 190e3, 95e3, 250e3, 60e3
BEHIND, AHEAD, HEEL, LENGTH, CENTRE = 6.5, 1.6, 2.5, 63.0, 0.45
#: Tracks: length on the ground, width, gauge, width of mats [m].
TRACK, WIDTH, GAUGE, MATS = 9.0, 1.5, 8.4, 6.0
#: Mass of the hook block [kg]; ropes have none, nor have the upper sheaves.
HOOK_BLOCK = 7e3
#: Stiffness under each end of a track [N/m].
GROUND = 200e6

_LIFT = """\
format: 1
lift: {{title: A crawler crane}}
duration: {duration} s
start: {start}
ground: {{level: 0 m}}
ropes:
  hoist: {{axial_stiffness: {rope} MN, damping_time: 10 ms, mass: none, diameter: 28 mm}}
hook_types:
  H:
    rated_capacity: 400 t
    block: {{mass: 7 t, height: 2 m}}
    reeving: {{parts_each: 14, rope: hoist, sheave_diameter: 0.7 m, below_head: 1 m,
      sheave_block_mass: 1 kg}}
    drum: {{diameter: 0.8 m}}
    hoist: {{speed: 6 m/min, acceleration: 0.02 m/s^2}}
cranes:
  c1:
    type: crawler
    position: [3 m, -2 m]
    heading: {heading} deg
    slew: {slew} deg
    rating_includes_hook_block: true
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m, allowed_pressure: 150 kPa,
      stiffness: {ground} MN/m{tracks}}}
    base_mass: 190 t
    central_ballast: 95 t
    counterweight: {{mass: 250 t, behind: 6.5 m}}
    boom: {{heel_pins: {{ahead: 1.6 m, height: 2.5 m}}, length: 63 m, {boom}, mass: 60 t,
      centre_of_gravity: 45 %}}
    luffing: {{speed: 3 deg/min, acceleration: 0.02 deg/s^2, range: [30 deg, 82 deg]{luffing}}}
    slewing: {{speed: 0.3 rev/min, acceleration: 0.1 deg/s^2}}
{crane}    rating: {{radius: [12 m, 14 m, 16 m, 18 m, 20 m, 24 m, 28 m],
      rated: [360 t, 283 t, 231 t, 195 t, 168 t, 130 t, 104 t], off_lead: 1 deg, side_lead: 1 deg}}
    hooks:
      H: {{type: H, height: 30 m}}
{more}mechanics:
  bodies:
    hung: {{parent: c1.H, joint: {{type: fixed}}, mass: {hung!r} kg}}
plan:
{plan}
simulation: {{tension_tolerance: 10 N, position_tolerance: 0.01 mm, sample_interval: {sample} s}}
"""

HOLD = "{step: hold, hold: until_end}"


def crawler_lift(
    hoist_load: float,
    plan: str = HOLD,
    *,
    radius: float = 16.0,
    boom: str | None = None,
    slew: float = 90.0,
    heading: float = 0.0,
    duration: float = 1.0,
    start: str = "rest",
    tracks: str = "",
    crane: str = "",
    luffing: str = "",
    more: str = "",
    ground: float = GROUND,
    rope: float = 36.0,
    sample: float = 0.1,
) -> str:
    """A lift file; `plan` is one step per line, not indented.

    Args:
        hoist_load: Mass of hook block and of what hangs in the hook [kg].
        plan: Steps.
        radius: Of the hook at the start [m].
        boom: Where the boom is at the start in place of that.
        slew: Of the boom from the heading [deg].
        heading: Of the tracks [deg].
        duration: Of the lift [s].
        start: How it starts.
        tracks: More keys of the tracks, after a comma.
        crane: More keys of the crane, a line each, indented.
        luffing: More keys of the luffing, after a comma.
        more: Further sections.
        ground: Stiffness under each end of a track [N/m].
        rope: EA of the hoist rope [MN].
        sample: Interval of samples [s].
    """
    return _LIFT.format(
        duration=duration,
        start=start,
        heading=heading,
        slew=slew,
        tracks=tracks,
        ground=ground / 1e6,
        boom=boom or f"radius: {radius!r} m",
        crane=crane,
        luffing=luffing,
        more=more,
        hung=hoist_load - HOOK_BLOCK,
        plan="\n".join(f"  - {line}" for line in plan.splitlines()),
        rope=rope,
        sample=sample,
    )


def own_moment(radius: float) -> float:
    """Mass times distance from the slewing axis towards the boom, of the crane alone [kg m]."""
    return BOOM * (AHEAD + CENTRE * (radius - AHEAD)) - WEIGHT * BEHIND


def own_mass() -> float:
    """Mass of the crane alone [kg]."""
    return BASE + BALLAST + WEIGHT + BOOM


def tipping_mass(radius: float) -> float:
    """Hoist load as a mass at which the crane tips over its side, rigid ground [kg]."""
    return (own_mass() * GAUGE / 2 - own_moment(radius)) / (radius - GAUGE / 2)


def head_height(radius: float) -> float:
    """Height of the boom head above the ground [m]."""
    return HEEL + math.sqrt(LENGTH**2 - (radius - AHEAD) ** 2)
