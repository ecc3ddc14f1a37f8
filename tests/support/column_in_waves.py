"""A column that hangs half in the water, on one stiff sling, and what it weighs there in long waves."""

from __future__ import annotations

import math

from in_water import RHO
from mechanics import G

MASS = 100e3
SIDE, HEIGHT = 2.0, 10.0
AXIAL_STIFFNESS, LENGTH = 400e6, 29.9
#: Of the lower end, by which the sling would be without force [m].
DEPTH = 4.9
#: What its sling bears, and how much less it has to stay.
STRENGTH, FACTOR = ", minimum_breaking_force: 5 MN", "  sling_factor_on_breaking_force: 3\n"

ALIKE = "{height: 1 m, period: 40 s, direction: 0 deg}"
SEA = "{significant_height: 1 m, peak_period: 7 s, direction: 0 deg, components: 20}"


def column(waves: str = ALIKE, *, least: str = "500 kN", duration: str = "160 s", more: str = "") -> str:
    """Its lift file.

    Args:
        waves: What is said of 'swell'.
        least: Smallest tension of the sling that is allowed.
        duration: Of the lift.
        more: Further sections.
    """
    return f"""\
format: 1
lift: {{title: A column in waves}}
duration: {duration}
water: {{level: 0 m, density: {RHO} kg/m^3}}
waves:
  swell: {waves}
ropes:
  hawser: {{axial_stiffness: {AXIAL_STIFFNESS} N, damping_time: 20 ms{STRENGTH}}}
load:
  name: column
  shape: {{box: [{SIDE} m, {SIDE} m, {HEIGHT} m]}}
  datum: bottom_centre
  position: [0 m, 0 m, -5 m]
  weight: {{calculated: {MASS} kg}}
  centre_of_gravity: {{at: [0 m, 0 m, 4 m]}}
  in_water: {{displaced_volume: 40 m^3, added_mass: [0 t, 0 t, 0 t], drag_coefficients: [1, 1, 1]}}
  lugs: {{L1: {{at: [0 m, 0 m, 10 m], capacity: 150 t}}}}
cranes:
  A:
    type: fixed_hook
    at: [0 m, 0 m, 35 m]
    rated_capacity: 150 t
    hoist: {{speed: 0.1 m/s, acceleration: 0.1 m/s^2}}
slings:
  S1: {{from: A, to: column.L1, length: {LENGTH} m, rope: hawser}}
plan:
  - {{step: hold, hold: until_end}}
limits:
  smallest_sling_tension_when_clear: {least}
{FACTOR}{more}"""


def least_tension(height: float, period: float) -> float:
    """Smallest tension of the sling in waves so long that nothing swings [N].

    Under a crest of amplitude a the water carries ρ g S (d + a exp(-κ d) - κ a²): the pressure on the lower
    end at a depth d, less what water over still water level, which moves as that at it, falls down with. The
    sling stretches: d = d₀ + T L/EA.
    """
    wave_number, amplitude = (2 * math.pi / period) ** 2 / G, height / 2
    tension = MASS * G
    for _ in range(50):
        depth = DEPTH + tension * LENGTH / AXIAL_STIFFNESS
        carried = depth + amplitude * math.exp(-wave_number * depth) - wave_number * amplitude**2
        tension = MASS * G - RHO * G * SIDE**2 * carried
    return tension
