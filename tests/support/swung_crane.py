"""A crawler crane that swings its hook through the boom of another, and how that goes by hand."""

from __future__ import annotations

from crawler_pair import GEAR, MASSES

#: Hooks hang 16 m from the slewing axes, 24 m apart in line with both: that of c2 comes by 8 m ahead of c1,
#: where the middle of the boom of that is 2.5 m + (8 m - 1.6 m) tan θ high, cos θ = (16 - 1.6)/63.
APART, BOOM_HEIGHT = 24.0, 29.76
#: Of c2, to each side of where it points to c1 [deg], and how it slews [deg/s], [deg/s^2].
HALF_WAY, SPEED, ACCELERATION = 59.4, 1.8, 0.1
#: When c2 points to c1, half of the way gone [s].
MIDDLE = HALF_WAY / SPEED + SPEED / ACCELERATION / 2


def _crane(name: str, place: float, slew: float, height: float) -> str:
    return f"""\
  {name}:
    type: crawler
    position: [{place} m, 0 m]
    heading: 0 deg
    slew: {slew} deg
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m}}
{MASSES}    slewing: {{speed: {SPEED} deg/s, acceleration: {ACCELERATION} deg/s^2}}
    hooks: {{H: {{type: H, height: {height} m}}}}
"""


def swung(duration: float, height: float) -> str:
    """The lift file; `height` is that of the hook of c2, which bears 1 t [m], `duration` in [s]."""
    return f"""\
format: 1
lift: {{title: One crane swings through another}}
duration: {duration} s
{GEAR}cranes:
{_crane("c1", 0.0, 0.0, 50.0)}{_crane("c2", APART, 180.0 - HALF_WAY, height)}mechanics:
  bodies:
    hung: {{parent: c2.H, joint: {{type: fixed}}, mass: 1 t}}
plan:
  - {{step: slew, slew: c2, speed: {SPEED} deg/s, by: {2 * HALF_WAY} deg}}
  - {{step: rest, hold: until_end}}
simulation: {{sample_interval: 0.2 s}}
"""
