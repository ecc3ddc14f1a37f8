"""Drift forces: what one wave alone pushes with, and two with slowly, against the sum over all pairs."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import waves
from afloat import DRAFT, LENGTH
from drifting import HEADING, MIDDLE, follows, growing, linear
from gantline.assembly import assemble
from gantline.scenario import load_scenario
from mechanics import Run, adaptive

DURATION = 90.0


def coefficient(frequency: float, direction: float) -> Any:
    """Made-up surge, sway and yaw over the amplitude squared, mirrored as of a hull with two sides alike."""
    size = 5e2 * frequency
    return size * np.array([math.cos(direction), 2 * math.sin(direction), 20 * math.sin(2 * direction)])


def drifting(folder: Path, sea: dict[str, Any]) -> Run:
    """The barge under drift forces, with next to nothing of first order."""
    about = [f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"]
    forces = {"database": "barge.nc", "at": about, "drift_damping": False}
    path = waves.in_waves(folder, sea, {"heading": f"{math.degrees(HEADING)} deg", "wave_forces": forces})
    table = np.array([[coefficient(w, b) for b in waves.DIRECTIONS] for w in waves.FREQUENCIES])
    waves.database(folder, drift=table, push=1e-12)
    document = assemble(load_scenario(path)).document
    return adaptive(document, DURATION, tension_tolerance=0.01, position_tolerance=1e-10, sample_interval=0.5)


def pushed(trains: list[tuple[float, float, float]]) -> tuple[Any, Any]:
    """Times, and surge, sway and yaw of the barge about the middle of its waterline (n, 3), vessel axes.

    Under g² Σ Σ a_i a_j ½(D_i + D_j) cos(θ_i − θ_j), θ = k·x + ε − ωt, x where the barge is at the start.

    Args:
        trains: heights [m], periods [s] and directions [deg], without phases.
    """
    time = np.arange(0.0, DURATION + 0.005, 0.01)
    every = []
    for height, period, direction in trains:
        omega, towards = 2 * math.pi / period, math.radians(direction)
        way = omega**2 / waves.G * (MIDDLE @ [math.cos(towards), math.sin(towards)])
        every.append((height / 2, coefficient(omega, towards - HEADING), way - omega * time))
    force = np.zeros((len(time), 3))
    for one, drift, phase in every:
        for other, drift_too, phase_too in every:
            both = one * other * (drift + drift_too) / 2
            force += both * np.cos(phase - phase_too)[:, np.newaxis]
    force *= growing(time, trains)[:, np.newaxis] ** 2
    return time, linear(time, force)


@pytest.mark.parametrize(
    "trains",
    [
        [(2.0, 8.0, 70.0)],
        [(2.0, 8.0, 70.0), (1.4, 7.0, 70.0)],
        [(2.0, 8.0, 70.0), (1.4, 6.5, 190.0), (1.0, 9.0, -50.0)],
    ],
    ids=["one wave", "two waves", "three directions"],
)
def test_a_barge_drifts_by_the_sum_over_all_pairs(
    tmp_path: Path, trains: list[tuple[float, float, float]]
) -> None:
    """Surge, sway and yaw of a barge that only drift forces push, against a linear system under the double
    sum of Newman's approximation. Energies balance.

    It moves by 2 to 6 cm and turns by up to 0.03°. What that changes in phases and axes, which the linear
    system does not have, grows with the forces: samples agree to 0.05 % of the largest motion, and to 0.5 %
    under ten times as much.
    """
    sea = {
        f"wave{k}": {"height": f"{height} m", "period": f"{period} s", "direction": f"{direction} deg"}
        for k, (height, period, direction) in enumerate(trains)
    }
    run = drifting(tmp_path, sea)
    time, expected = pushed(trains)
    follows(run, time, expected, 1e-3)
