"""The heaving sphere of OES Task 10 in water that remembers: against convolution and other programs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from floating import buoyancy
from gantline.assembly.afloat.radiation import memory_terms
from gantline.hydro import float_free, read_hull
from gantline.hydro.database import HydrodynamicDatabase, read_database
from gantline.hydro.memory import Memory, fit_memory
from mechanics import Floats, G, Run, adaptive, body, document, free

DATA = Path(__file__).resolve().parents[2].parent / "shared" / "data" / "hydrodynamics"
FRESH, MASS = 1000.0, 261.8e3


@pytest.fixture(scope="module")
def database() -> HydrodynamicDatabase:
    if not (DATA / "sphere.h5").exists():
        pytest.skip("../shared/data/hydrodynamics/sphere.h5 is not beside this checkout")
    return read_database(DATA / "sphere.h5")


@pytest.fixture(scope="module")
def memory(database: HydrodynamicDatabase) -> Memory:
    return fit_memory(database, FRESH)


def decay(memory: Memory, height: float, **tolerances: Any) -> tuple[Run, Floats, float]:
    """A run from `height` [m], its height over where it floats, and ρgA of its mesh."""
    hull = read_hull(DATA / "oes_task10_sphere.obj")
    rest = float_free(hull, MASS, [0, 0, -2.0], density=FRESH)
    vertices, triangles = hull.mesh
    about = {"body": "sphere", "at": [0, 0, 0]}
    forces = [
        buoyancy("sphere", (vertices.tolist(), triangles.tolist()), density=FRESH),
        {"type": "added_mass", "name": "added", **about, "matrix": memory.infinite_added_mass.tolist()},
        {"type": "memory", "name": "past", **about, "terms": memory_terms(memory)},
    ]
    place = free([0, 0, height + rest.attitude.height])
    sphere = body("sphere", place, MASS, centre_of_gravity=(0, 0, -2), inertia=[MASS * 10] * 3)
    run = adaptive(document([sphere], forces=forces), 40.0, **tolerances)
    stiffness = FRESH * G * rest.hydrostatics.waterplane_area
    return run, run.body("sphere")[:, 2] + 2 - rest.attitude.height, stiffness


def cosine_transform(frequency: Floats, damping: Floats, time: Floats) -> Floats:
    """K(t) = (2/π) ∫ B cos ωt dω of what is linear between frequencies, in closed form, from 0 at ω = 0."""
    omega, values = np.concatenate([[0.0], frequency]), np.concatenate([[0.0], damping])
    slope = np.diff(values) / np.diff(omega)
    later = time[1:, None]
    parts = np.diff(values * np.sin(omega * later) / later, axis=1)
    parts += slope * np.diff(np.cos(omega * later), axis=1) / later**2
    start = np.trapezoid(values, omega)
    kernel: Floats = 2 / np.pi * np.concatenate([[start], parts.sum(axis=1)])
    return kernel


def convolved(kernel: Floats, inertia: float, stiffness: float, step: float) -> Floats:
    """(m + A(∞)) z¨ + ∫ K(t − τ) ż dτ + k z = 0 from z = 1 at rest, all by the trapezoidal rule."""
    z, v, a = (np.zeros(len(kernel)) for _ in range(3))
    z[0], a[0] = 1.0, -stiffness / inertia
    own = step * kernel[0] / 2
    for n in range(len(kernel) - 1):
        known = step * (kernel[1 : n + 1] @ v[n:0:-1] + 0.5 * kernel[n + 1] * v[0])
        faster = v[n] + step / 2 * a[n]
        further = z[n] + step / 2 * (v[n] + faster)
        whole = inertia + own * step / 2 + stiffness * step**2 / 4
        a[n + 1] = (-known - own * faster - stiffness * further) / whole
        v[n + 1] = faster + step / 2 * a[n + 1]
        z[n + 1] = z[n] + step / 2 * (v[n] + v[n + 1])
    return z


def extremes(time: Floats, values: Floats, count: int) -> Floats:
    """Times and values of the first turning points, by parabolas through three samples (count, 2)."""
    turns = np.flatnonzero((values[1:-1] - values[:-2]) * (values[2:] - values[1:-1]) < 0)[:count] + 1
    before, here, after = values[turns - 1], values[turns], values[turns + 1]
    share = 0.5 * (before - after) / (before - 2 * here + after)
    return np.stack(
        [time[turns] + share * (time[1] - time[0]), here - 0.25 * (before - after) * share], axis=1
    )


def test_its_decay_is_that_of_the_convolution_integral(
    database: HydrodynamicDatabase, memory: Memory
) -> None:
    """5 cm, where the section is that of rest, against the file's own B and A(∞) by direct convolution
    with steps of 5 ms: at all times within half of the fit's mean error of damping, 0.6 % of the largest.
    """
    run, height, stiffness = decay(memory, 0.05, position_tolerance=1e-9)
    step = 0.005
    time = np.linspace(0.0, 40.0, 8001)
    kernel = cosine_transform(database.frequencies, database.damping[:, 2, 2], time)
    assert database.infinite_added_mass is not None
    inertia = MASS + float(database.infinite_added_mass[2, 2])
    wanted = convolved(kernel, inertia, stiffness, step)
    apart = height / 0.05 - np.interp(run.time, time, wanted)
    assert memory.misfit.damping[0] < 0.01
    assert np.abs(apart).max() < 0.5 * memory.misfit.damping[0]
    # The step of the convolution is fine enough.
    coarse = convolved(kernel[::2], inertia, stiffness, 2 * step)
    assert np.abs(coarse - wanted[::2]).max() < 1e-4


def test_its_decay_is_that_of_other_programs(memory: Memory) -> None:
    """From 1 m, turning points as published for OES Task 10 (Wendt and others 2019, decay of 1 m, InWave+H):
    −0.8680 m at 2.22 s, 0.6362 m at 4.42 s, −0.4661 m at 6.59 s. Other programs are up to 0.008, 0.014 and
    0.03 m off these; we are within 0.5 % of the 1 m and 1 % of the times.
    """
    run, height, _ = decay(memory, 1.0)
    published = np.array([[2.22, -0.8680], [4.42, 0.6362], [6.59, -0.4661]])
    found = extremes(run.time, height, 3)
    assert found[:, 1] == pytest.approx(published[:, 1], abs=0.005)
    assert found[:, 0] == pytest.approx(published[:, 0], rel=0.01)


def test_the_fit_is_as_good_as_it_says(database: HydrodynamicDatabase, memory: Memory) -> None:
    """Damping and added mass in heave at all 240 frequencies: as near as it states."""
    damping, added = database.damping[:, 2, 2], database.added_mass[:, 2, 2]
    frequency = database.frequencies
    by_fit = memory.damping(frequency)[:, 2, 2], memory.added_mass(frequency)[:, 2, 2]
    assert np.abs(by_fit[0] - damping).max() <= memory.misfit.damping[1] * damping.max() * (1 + 1e-9)
    assert np.abs(by_fit[1] - added).max() <= memory.misfit.added_mass[1] * np.ptp(added) * (1 + 1e-9)
