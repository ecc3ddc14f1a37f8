"""Ropes with nodes whose end moves, as a boom head or a fairlead in waves: cases, and gantline's tensions.

The end moves along one axis, from rest, its velocity rising and falling between ±`speed` as 3 s² − 2 s³.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from benchmarks.contract import FloatArray
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation

GRAVITY, DENSITY = 9.81, 1025.0
SAMPLE_INTERVAL = 0.02
"""Between samples [s]."""
BOX = (8.0, 6.0, 4.0)
"""Of a load in water [m]."""
TOP = -100.0
"""Height of the end that moves, deep enough that no load comes near the surface [m]."""


@dataclass(frozen=True)
class InWater:
    """What water does to a load along the vertical: volume [m³], added mass [kg], drag coefficient."""

    volume: float
    added_mass: float
    drag: float

    @property
    def drag_area(self) -> float:
        """Coefficient times area [m²]."""
        return self.drag * BOX[0] * BOX[1]


@dataclass(frozen=True)
class HeavedLine:
    """A rope from an end that moves to a load below it, or to a fixed end at the same height.

    Attributes:
        name: what it is called in tables and files.
        length: unstretched [m].
        stiffness: EA [N].
        mass: per unstretched length [kg/m].
        damping_time: τ of the law of tension [s].
        load: mass of what hangs below [kg]; None of a rope between two ends.
        span: between two ends, level [m].
        speed: largest [m/s].
        period: of the motion [s].
        segments: of the rope.
        duration: [s].
        water: what water does to the load, if it is in any.
    """

    name: str
    length: float
    stiffness: float
    mass: float
    damping_time: float
    load: float | None
    span: float
    speed: float
    period: float
    segments: int = 40
    duration: float = 30.0
    water: InWater | None = None

    @property
    def axis(self) -> tuple[int, int, int]:
        """Of the motion: up where a load hangs, else along the span."""
        return (0, 0, 1) if self.load else (1, 0, 0)

    @property
    def drop(self) -> float:
        """From the end that moves to the load, with the rope's stretch at rest [m]."""
        assert self.load is not None
        buoyancy = DENSITY * self.water.volume if self.water else 0.0
        pull = self.load - buoyancy + self.mass * self.length / 2
        return self.length * (1.0 + pull * GRAVITY / self.stiffness)

    def ramps(self) -> Iterator[tuple[float, float, float]]:
        """Begin and duration [s] of each change of velocity, and what it comes to [m/s]."""
        yield 0.0, self.period / 4, self.speed
        for number in range(int(2 * self.duration / self.period)):
            yield (0.25 + 0.5 * number) * self.period, self.period / 2, self.speed * (-1.0) ** (number + 1)

    def velocity(self, time: FloatArray) -> FloatArray:
        """Of the end that moves, along `axis` (n,) [m/s]."""
        velocity = np.zeros_like(time)
        before = 0.0
        for begin, duration, after in self.ramps():
            s = np.clip((time - begin) / duration, 0.0, 1.0)
            velocity += (after - before) * s**2 * (3 - 2 * s)
            before = after
        return velocity


LINES = (
    # Their own period is 2.2 s.
    HeavedLine("load on a rope", 400.0, 200e6, 17.0, 0.01, 60e3, 0.0, speed=0.8, period=5.0),
    HeavedLine("load that snatches", 400.0, 200e6, 17.0, 0.001, 60e3, 0.0, speed=3.2, period=5.0),
    HeavedLine(
        "load in water",
        400.0, 200e6, 17.0, 0.01, 60e3, 0.0, speed=1.5, period=8.0, water=InWater(7.6, 80e3, 1.8),
    ),
    HeavedLine("rope that sags", 63.0, 50e6, 20.0, 0.002, None, 60.0, speed=1.2, period=4.0),
)  # fmt: skip


def lift(line: HeavedLine, tolerance: float | None = None) -> str:
    """A lift file of it; with a tension tolerance [N] other than the default, places as fine."""
    ramps = ", ".join(
        f"{{at: {begin!r} s, duration: {duration!r} s, velocity: {after!r} m/s}}"
        for begin, duration, after in line.ramps()
    )
    settings = [f"sample_interval: {SAMPLE_INTERVAL} s"]
    if tolerance is not None:
        settings += [f"tension_tolerance: {tolerance!r} N", f"position_tolerance: {tolerance * 1e-6!r} m"]
    hung, end, load, water = "end", "[0 m, 0 m, 0 m]", "", ""
    if line.load is None:
        bodies = f"    end: {{at: [{-line.span!r} m, 0 m, {TOP} m], joint: {{type: fixed}}}}\n"
    elif line.water is None:
        place = f"[0 m, 0 m, {TOP - line.drop!r} m]"
        bodies = f"    end: {{at: {place}, joint: {{type: point}}, mass: {line.load!r} kg}}\n"
    else:
        # Its lug is in the middle of its top; `mechanics` counts from its centre of gravity.
        hung, end, bodies = "load", f"[0 m, 0 m, {BOX[2] / 2} m]", ""
        water = f"water: {{density: {DENSITY} kg/m^3, level: 0 m, depth: 1000 m}}\n"
        added, drag = line.water.added_mass, line.water.drag
        load = f"""\
load:
  name: load
  shape: {{box: [{BOX[0]} m, {BOX[1]} m, {BOX[2]} m]}}
  datum: bottom_centre
  position: [0 m, 0 m, {TOP - line.drop - BOX[2]!r} m]
  weight: {{calculated: {line.load!r} kg, simulate: calculated}}
  centre_of_gravity: {{at: [0 m, 0 m, {BOX[2] / 2} m]}}
  in_water:
    displaced_volume: {line.water.volume!r} m^3
    added_mass: [{added!r} kg, {added!r} kg, {added!r} kg]
    drag_coefficients: [{drag}, {drag}, {drag}]
"""
    kind = f"axial_stiffness: {line.stiffness!r} N, mass: {line.mass!r} kg/m"
    return f"""\
format: 1
lift: {{title: A {line.name}}}
duration: {line.duration} s
start: as_given
simulation: {{{", ".join(settings)}}}
{water}ropes:
  kind: {{{kind}, damping_time: {line.damping_time} s}}
{load}mechanics:
  bodies:
    top:
      at: [0 m, 0 m, {TOP} m]
      mass: 1 t
      joint: {{type: slider, axis: {list(line.axis)}, motion: [{ramps}]}}
{bodies}  ropes:
    rope:
      rope: kind
      length: {line.length!r} m
      rope_weight: distributed
      rope_nodes: {line.segments - 1}
      route: [{{type: end, body: top}}, {{type: end, body: {hung}, at: {end}}}]
"""


def tensions(line: HeavedLine, tolerance: float | None = None) -> FloatArray:
    """Of the first and the last segment, by gantline (samples, 2) [N]."""
    recording = Simulation(parse_scenario(lift(line, tolerance))).run()
    both: FloatArray = recording["segment_tension"].values[:, [0, -1]]
    return both
