"""The crane barge in swell against its own equations in the frequency domain: hook load over time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from gantline.hydro.database import read_database
from gantline.hydro.memory import fit_memory
from gantline.hydro.waves import sea
from gantline.results.variable import FloatArray
from gantline.simulation import simulate

FOLDER = Path(__file__).parents[2] / "scenarios" / "crane_barge_in_swell"
G, SEA, LENGTH, BREADTH, DRAFT = 9.81, 1025.0, 90.0, 30.0, 2.99
#: Masses of the barge by itself [kg] and where they are from stern and keel, x and z [m].
OWN = ((3200e3, 44.0, 3.2), (250e3, 12.0, 9.0), (250e3, 30.0, 7.5), (220e3, 62.0, 18.0), (3990e3, 43.0, 1.5))
RADII = (10.0, 26.0, 27.0)
ANGLE = math.radians(65.0)
HEAD = (84.0 + 55.0 * math.cos(ANGLE), 7.5 + 55.0 * math.sin(ANGLE))
BOOM = (84.0 + 0.48 * 55.0 * math.cos(ANGLE), 7.5 + 0.48 * 55.0 * math.sin(ANGLE))
#: In the hook: module, slings of 180 kg, shackles of 27 kg; on the falls: hook block and falls (1.45 t) too.
HOOK = 120e3 + 4 * (179.6 + 2 * 27.0)
FALLS = HOOK + 9e3 + 1452.0


def at_point(mass: float, place: Sequence[float], shares: Sequence[float] = (1.0, 1.0, 1.0)) -> FloatArray:
    """Inertia (6, 6) of a mass about the origin; what hangs takes part only along z."""
    x, y, z = place
    lever = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    jacobian = np.hstack([np.eye(3), -lever])
    found: FloatArray = mass * jacobian.T @ np.diag(shares) @ jacobian
    return found


def test_hook_load_in_swell() -> None:
    """The barge as six equations, the module a mass that its boom head moves up and down: its hook load over
    the first hold, wave by wave with the same phases. What is left is what the six equations do not know:
    the stretch of the falls, the swing of the module, the moorings: 3 % of what goes up and down.
    """
    run = simulate(FOLDER, duration=150.0)
    database = read_database(FOLDER / "crane_barge.nc")
    towards = math.radians(150.0)
    # How far that is from the file's is a matter of test_radiation.py.
    water = fit_memory(database, SEA)
    waves = sea(0.8, 7.0, towards, enhancement=3.3, count=100, seed="1/swell")
    forces, _ = database.excitation_at(waves.frequency, towards, SEA)

    # About the middle of the waterline, x forward.
    def about(x: float, z: float) -> tuple[float, float, float]:
        return x - LENGTH / 2, 0.0, z - DRAFT

    lumps = [(mass, about(x, z)) for mass, x, z in OWN]
    own = sum(mass for mass, _ in lumps)
    centre = (np.array([mass * np.array(place) for mass, place in lumps]).sum(axis=0) / own).tolist()
    inertia = at_point(own, centre)
    inertia[3:, 3:] += own * np.diag(RADII) ** 2
    inertia += at_point(190e3, about(*BOOM))
    inertia[3:, 3:] += 48000e3 * np.diag([math.sin(ANGLE) ** 2, 1.0, math.cos(ANGLE) ** 2])
    inertia += at_point(25e3 + 3e3, about(*HEAD)) + at_point(FALLS, about(*HEAD), (0.0, 0.0, 1.0))
    weights = [*lumps, (190e3, about(*BOOM)), (28e3 + FALLS, about(*HEAD))]
    total = sum(mass for mass, _ in weights)
    assert total / (SEA * LENGTH * BREADTH) == pytest.approx(DRAFT, abs=0.01)
    high = sum(mass * place[2] for mass, place in weights)
    turning = [SEA * LENGTH * BREADTH * size**2 / 12 - total * DRAFT / 2 - high for size in (BREADTH, LENGTH)]
    stiffness = G * np.diag([0.0, 0.0, SEA * LENGTH * BREADTH, *turning, 0.0])
    start = (LENGTH / 2) * math.cos(towards)
    vertical = np.zeros(len(run.time))
    x, _, _ = about(*HEAD)
    for omega, force, amplitude, phase in zip(
        waves.frequency, forces, waves.amplitude, waves.phase, strict=True
    ):
        added, damping = water.added_mass(np.array([omega]))[0], water.damping(np.array([omega]))[0]
        whole = -(omega**2) * (inertia + added) - 1j * omega * damping + stiffness
        wave = amplitude * np.exp(1j * (phase + omega**2 / G * start))
        motion = np.linalg.solve(whole, force * wave)
        rise = motion[2] - x * motion[4]
        vertical += np.real(-(omega**2) * rise * np.exp(-1j * omega * run.time))
    grown = run.time > 40.0
    expected = HOOK * (G + vertical[grown])
    found = run.column("hook_load", "sheerleg.H1")[grown]
    assert found.mean() == pytest.approx(HOOK * G, rel=2e-3)
    assert np.std(found) == pytest.approx(np.std(expected), rel=0.01)
    assert np.std(found - expected) < 0.05 * np.std(expected)
