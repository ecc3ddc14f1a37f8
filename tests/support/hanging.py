"""Ropes that hang freely: lifts of one rope with nodes, and the elastic catenary in closed form.

The elastic catenary of a rope of unstretched length L, weight w per unstretched length and axial stiffness
EA, with the force (H, V) at its upper end (Irvine 1981; V_low = V - w L is the force at the lower end):

    x = H L/EA + H/w (asinh(V/H) - asinh(V_low/H))
    z = (V^2 - V_low^2)/(2 EA w) + (sqrt(H^2 + V^2) - sqrt(H^2 + V_low^2))/w
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asinh, hypot

import numpy as np

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from mechanics import Floats, G


@dataclass(frozen=True)
class Catenary:
    """A rope and the force at its upper end."""

    horizontal: float  # H, N
    upper: float  # V, N, pulling the end down
    length: float  # unstretched, m
    stiffness: float  # EA, N
    weight: float  # per unstretched length, N/m

    @property
    def lower(self) -> float:
        """Force at the lower end [N], positive where it is pulled up."""
        return self.upper - self.weight * self.length

    @property
    def reach(self) -> tuple[float, float]:
        """From the lower to the upper end, along and up [m]: the equations above."""
        h, v, low, w = self.horizontal, self.upper, self.lower, self.weight
        along = h * self.length / self.stiffness + h / w * (asinh(v / h) - asinh(low / h))
        up = (v**2 - low**2) / (2 * self.stiffness * w) + (hypot(h, v) - hypot(h, low)) / w
        return along, up


@dataclass(frozen=True)
class Hanging:
    """What a run of a rope between two fixed bodies gave.

    Attributes:
        upper: force that the rope puts on its upper end, along and down (time, 2) [N].
        lower: force on its lower end, along and up (time, 2) [N].
        moved: how far any node moved from its start [m].
        recording: the recording.
    """

    upper: Floats
    lower: Floats
    moved: float
    recording: Recording


def lift(
    reach: tuple[float, float],
    length: float,
    stiffness: float,
    weight: float,
    nodes: int,
    duration: float = 5.0,
) -> str:
    """A lift file with one rope of distributed weight between two fixed bodies."""
    return f"""\
format: 1
lift: {{title: A rope that hangs}}
duration: {duration!r} s
ropes:
  kind: {{axial_stiffness: {stiffness!r} N, mass: {weight / G!r} kg/m}}
mechanics:
  bodies:
    low: {{joint: {{type: fixed}}}}
    high: {{at: [{reach[0]!r} m, 0 m, {reach[1]!r} m], joint: {{type: fixed}}}}
  ropes:
    rope:
      rope: kind
      length: {length!r} m
      rope_weight: distributed
      rope_nodes: {nodes}
      route: [{{type: end, body: low}}, {{type: end, body: high}}]
"""


def run(text: str) -> Hanging:
    """Run such a lift and read the forces on its ends off the joints that hold them."""
    simulation = Simulation(parse_scenario(text))
    recording = simulation.run()
    columns, names = simulation._core.columns(), simulation._core.names()
    force = {body: columns["joint_force"][:, names["body"].index(body)] for body in ("low", "high")}
    points = recording["rope_point"].values
    return Hanging(
        upper=np.stack([force["high"][:, 0], force["high"][:, 2]], axis=1),
        lower=np.stack([-force["low"][:, 0], -force["low"][:, 2]], axis=1),
        moved=float(np.abs(points - points[0]).max()),
        recording=recording,
    )
