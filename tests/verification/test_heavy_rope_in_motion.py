"""A load on a rope with nodes that swings, falls into the slack rope and whips it, against a chain of masses.

The rope of N segments h has its mass in nodes, 7/16 of a segment's at the ends, 13/12 and 47/48 at the
next two, whole ones between; a segment pulls with T = max(0, EA/h (e + τ ė)). The places of the nodes at
the start, those of the catenary, are the recording's. scipy's LSODA solves the motion.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from mechanics import Floats, G

STIFFNESS, WEIGHT, LENGTH, NODES, TAU, LOAD = 2e6, 6.0, 20.0, 11, 0.02, 300.0
DURATION = 1.5


def lift(place: tuple[float, ...], velocity: tuple[float, ...]) -> str:
    """A lift file: a load at a place [m] with a velocity [m/s] on a heavy rope from the origin."""
    starts = ", ".join(f"{part} m/s" for part in velocity)
    at = ", ".join(f"{part} m" for part in place)
    return f"""\
format: 1
lift: {{title: A load on a heavy rope}}
duration: {DURATION} s
start: as_given
simulation: {{sample_interval: 0.05 s, tension_tolerance: 0.2 N, position_tolerance: 0.001 mm}}
ropes:
  kind: {{axial_stiffness: {STIFFNESS} N, mass: {WEIGHT} kg/m, damping_time: {TAU} s}}
mechanics:
  bodies:
    load: {{at: [{at}], joint: {{type: point, velocity: [{starts}]}}, mass: {LOAD} kg}}
  ropes:
    rope:
      rope: kind
      length: {LENGTH} m
      rope_weight: distributed
      rope_nodes: {NODES}
      route: [{{type: end, body: world, at: [0 m, 0 m, 0 m]}}, {{type: end, body: load}}]
"""


@pytest.mark.parametrize(
    ("place", "velocity", "goes_slack"),
    [((3.0, 0.0, -19.8), (0.0, 1.0, 0.0), False), ((4.0, 0.0, -17.0), (0.0, 1.0, 2.0), True)],
    ids=["swings", "falls"],
)
def test_a_load_on_a_rope_with_nodes(
    place: tuple[float, ...], velocity: tuple[float, ...], goes_slack: bool
) -> None:
    """Where all nodes and the load are, taut all along and slack."""
    recording = Simulation(parse_scenario(lift(place, velocity))).run()
    times, points = recording["time"].values, recording["rope_point"].values
    count = NODES + 1
    assert points.shape[1:] == (count + 1, 3)
    segment = LENGTH / count
    shares = np.ones(count + 1)
    shares[[0, -1]], shares[[1, -2]], shares[[2, -3]] = 7 / 16, 13 / 12, 47 / 48
    masses = shares * WEIGHT * segment
    masses[-1] += LOAD

    def rates(_: float, state: Floats) -> Floats:
        """Of places and velocities of all but the upper end."""
        moved = state.reshape(2, count, 3)
        places, speeds = np.concatenate([np.zeros((2, 1, 3)), moved], axis=1)
        ways = np.diff(places, axis=0)
        spans = np.linalg.norm(ways, axis=1)
        along = ways / spans[:, None]
        rate = (along * np.diff(speeds, axis=0)).sum(axis=1)
        tension = np.maximum(0.0, STIFFNESS / segment * (spans - segment + TAU * rate))
        force = np.zeros_like(places)
        force[:-1] += tension[:, None] * along
        force[1:] -= tension[:, None] * along
        acceleration = force / masses[:, None] - [0, 0, G]
        return np.concatenate([speeds[1:].ravel(), acceleration[1:].ravel()])

    start = np.zeros((2, count, 3))
    start[0] = points[0, 1:]
    start[1, -1] = velocity
    own = solve_ivp(rates, (0, times[-1]), start.ravel(), "LSODA", times, rtol=1e-8, atol=1e-9)
    expected = own.y[: 3 * count].T.reshape(-1, count, 3)
    spans = np.linalg.norm(np.diff(points, axis=1), axis=2)
    assert (spans.min() < segment) == goes_slack
    # Tolerances of 1 µm and 0.2 N in a step, and a slack rope lashes: 5e-7 m and 3e-6 m were found.
    assert np.abs(points[:, 1:] - expected).max() < (2e-5 if goes_slack else 2e-6)
