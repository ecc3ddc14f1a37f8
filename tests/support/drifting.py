"""A barge under drift forces as a linear system, and how far it goes in a run."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import waves
from afloat import DRAFT, KG, LENGTH
from gantline.results.rotation import heading
from mechanics import Run

#: Where the barge heads, and the middle of its length at the start.
HEADING = math.radians(40.0)
MIDDLE = LENGTH / 2 * np.array([math.cos(HEADING), math.sin(HEADING)])
#: Surge, sway and yaw among the six.
LEVEL = [0, 1, 5]


def growing(time: Any, trains: list[tuple[float, float, float]]) -> Any:
    """g of waves by heights, periods and directions at times (n,) [s]."""
    s = np.minimum(time / (3 * max(period for _, period, _ in trains)), 1.0)
    return s**3 * (10 - s * (15 - 6 * s))


def linear(
    time: Any, force: Any, damping: Any = waves.DAMPING, velocity: tuple[float, ...] = (0.0, 0.0, 0.0)
) -> Any:
    """Surge, sway and yaw of the barge about the middle of its waterline (n, 3), vessel axes.

    (M + A) ξ″ + B(t) ξ′ + C ξ = F(t), by the trapezoidal rule.

    Args:
        time: even steps (n,) [s].
        force: F in surge, sway and yaw (n, 3).
        damping: B (6, 6), or that of every time (n, 6, 6).
        velocity: of surge, sway and yaw at the start.
    """
    step = time[1] - time[0]
    pushes = np.zeros((len(time), 6))
    pushes[:, LEVEL] = force
    losses = np.broadcast_to(damping, (len(time), 6, 6))
    nothing = np.zeros((6, 6))
    stiffness = waves.impedance(0.0, nothing, nothing).real
    mass = stiffness - waves.impedance(1.0, waves.ADDED, nothing).real
    place, speed = np.zeros(6), np.zeros(6)
    speed[LEVEL] = velocity
    found = np.zeros((len(time), 6))
    for k in range(len(time) - 1):
        push, loss = (pushes[k] + pushes[k + 1]) / 2, (losses[k] + losses[k + 1]) / 2
        left = mass + step / 2 * loss + step**2 / 4 * stiffness
        change = np.linalg.solve(left, step * (push - loss @ speed - stiffness @ (place + step / 2 * speed)))
        place = place + step * (speed + change / 2)
        speed = speed + change
        found[k + 1] = place
    return found[:, LEVEL]


def gone(run: Run) -> Any:
    """The same of a run (n, 3), along the heading at the start."""
    orientation = run.body("barge", "body_orientation")
    w, x, y, z = orientation.T
    # The axis z of the barge leans by pitch and roll: from its centre to the waterline.
    up = np.stack([2 * (x * z + w * y), 2 * (y * z - w * x)], axis=1)
    shift = run.body("barge")[:, :2] + (DRAFT - KG) * up
    shift -= shift[0]
    along = np.array([[math.cos(HEADING), -math.sin(HEADING)], [math.sin(HEADING), math.cos(HEADING)]])
    turned = np.unwrap(heading(orientation)) - HEADING
    return np.column_stack([shift @ along, turned])


def follows(run: Run, time: Any, expected: Any, close: float) -> None:
    """Samples of a run against a system (n, 3), close by a share of the largest motion; energies balance."""
    found = gone(run)
    for k, motion in enumerate(("surge", "sway", "yaw")):
        wanted = np.interp(run.time, time, expected[:, k])
        worst = np.abs(found[:, k] - wanted).max() / np.abs(wanted).max()
        assert worst < close, motion
    assert run.energy_remainder < 1e-7
