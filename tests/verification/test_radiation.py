"""Vessels in water that remembers: in regular waves and by themselves, against A(ω) and B(ω)."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import simpson

import waves
from afloat import DRAFT, KG, LENGTH
from floating import SEA
from gantline.hydro.database import read_database
from gantline.hydro.memory import Memory, fit_memory
from gantline.simulation import simulate
from gantline.statics import Statics


def fitted(folder: Path) -> Memory:
    return fit_memory(read_database(folder / "barge.nc"), SEA)


def test_a_fit_has_the_water_of_its_file(tmp_path: Path) -> None:
    """A(ω), B(ω) and A(∞) of three coupled oscillators that are not on the grid of the fit: to 0.1 % of
    the largest damping and of the change of added mass. What the fit says of itself is its largest error.
    """
    waves.database(tmp_path, waves.radiated)
    memory = fitted(tmp_path)
    frequency = waves.FREQUENCIES
    added, damping = waves.radiated(frequency)
    largest = np.sqrt(np.diagonal(damping, axis1=1, axis2=2).max(axis=0))
    change = np.sqrt(np.ptp(np.diagonal(added, axis1=1, axis2=2), axis=0))
    damped = np.abs(memory.damping(frequency) - damping) / np.outer(largest, largest)
    moved = np.abs(memory.added_mass(frequency) - added) / np.outer(change, change)
    assert max(damped.max(), moved.max()) < 1e-3
    found = (memory.misfit.damping[1], memory.misfit.added_mass[1])
    assert (damped.max(), moved.max()) == pytest.approx(found, rel=1e-9)
    apart = (memory.infinite_added_mass - waves.ADDED) / np.outer(change, change)
    assert apart == pytest.approx(np.zeros((6, 6)), abs=1e-3)
    assert memory.doubts == ()


def test_the_kernel_is_the_cosine_transform_of_damping(tmp_path: Path) -> None:
    """K(t) = (2/π) ∫ B(ω) cos ωt dω (Ogilvie 1964), by trapezoids up to 400 rad/s, and
    ∫ K dt = B(0) = 0: to 0.5 % of K(0); beyond 400 rad/s lie (2/π) Σ 2 C ζω/400.
    """
    waves.database(tmp_path, waves.radiated)
    memory = fitted(tmp_path)
    fine = np.linspace(0.0, 400.0, 20_001)
    damping = memory.damping(fine)[:, 2, 2]
    time = np.array([0.0, 0.7, 2.0, 5.0, 11.0])
    wanted = [2 / math.pi * np.trapezoid(damping * np.cos(fine * t), fine) for t in time]
    kernel = memory.kernel(time)[:, 2, 2]
    assert kernel == pytest.approx(np.array(wanted), abs=5e-3 * kernel[0])
    long = np.linspace(0.0, 400.0, 40_001)
    assert simpson(memory.kernel(long)[:, 2, 2], long) == pytest.approx(0.0, abs=1e-5 * kernel[0])


def test_no_motion_gains_energy_at_any_frequency(tmp_path: Path) -> None:
    """Re K(iω) has no negative eigenvalue from 1e-3 to 1e3 rad/s, to rounding, and K dies away."""
    waves.database(tmp_path, waves.radiated)
    memory = fitted(tmp_path)
    scale = np.sqrt(np.diag(waves.DAMPING))
    damping = memory.damping(np.geomspace(1e-3, 1e3, 601)) / np.outer(scale, scale)
    assert np.linalg.eigvalsh(damping).min() > -1e-12
    assert (memory.poles.real < 0).all()


@pytest.mark.parametrize("period", [5.0, 9.0, 14.0])
def test_steady_motion_is_that_of_added_mass_and_damping_at_its_frequency(
    tmp_path: Path, period: float
) -> None:
    """Six complex amplitudes against (−ω²(M + A(ω)) − iωB(ω) + C)⁻¹ F: to 1e-5 with A and B of the fit,
    and to twice its largest misfit with those of the file. Nothing holds heading and place: their drift is as
    small as the wave.
    """
    omega = 2 * math.pi / period
    middle = {"position": [f"{-LENGTH / 2} m", "0 m"]}
    swell = {"height": "0.2 mm", "period": f"{period!r} s", "direction": "30 deg"}
    path = waves.radiating(
        tmp_path,
        {"swell": swell},
        middle,
        duration=f"{60 * period!r} s",
        simulation={"sample_interval": f"{period / 16!r} s"},
    )
    run = simulate(path, tension_tolerance=0.1, position_tolerance=1e-9)
    found = waves.motion(run, omega)
    # Forces between the frequencies of the file are linear.
    memory, at = fitted(tmp_path), np.array([omega])
    forces, _ = read_database(tmp_path / "barge.nc").excitation_at(at, math.radians(30.0), SEA)
    for water, within in (
        ((memory.added_mass(at)[0], memory.damping(at)[0]), 1e-5),
        (
            [part[0] for part in waves.radiated(at)],
            2 * max(memory.misfit.damping[1], memory.misfit.added_mass[1]),
        ),
    ):
        expected = waves.response(omega, forces[0] * 1e-4, *water)
        scale = np.repeat([np.abs(expected[:3]).max(), np.abs(expected[3:]).max()], 3)
        assert np.abs(found - expected) / scale == pytest.approx(np.zeros(6), abs=within)


def test_modes_have_the_water_of_their_own_frequency(tmp_path: Path) -> None:
    """(C − ω²(M + A(ω))) x = 0 for heave, roll and pitch, to 1e-6 of each row's scale, A(ω) of the fit;
    ζ = xᵀ B(ω) x/2ω.
    """
    question = Statics(waves.radiating(tmp_path, {}))
    question.equilibrium()
    memory = fitted(tmp_path)
    swinging = [mode for mode in question.modes() if mode.square > 1e-6]
    assert len(swinging) == 3
    for mode in swinging:
        omega, at = math.sqrt(mode.square), np.array([math.sqrt(mode.square)])
        added, damping = memory.added_mass(at)[0], memory.damping(at)[0]
        # From the centre of gravity to the middle of the waterline.
        velocity, turn = mode.body_motion[0].reshape(2, 3)
        shape = np.concatenate([velocity + np.cross(turn, [0.0, 0.0, DRAFT - KG]), turn])
        left = waves.impedance(omega, added, 0.0 * damping)
        inertia = (
            -(waves.impedance(omega, added, 0.0 * damping) - waves.impedance(0.0, added, damping)) / omega**2
        )
        scale = np.sqrt(np.diag(inertia.real))
        assert shape @ inertia.real @ shape == pytest.approx(1.0, rel=1e-6)
        assert (left.real @ shape) / scale == pytest.approx(np.zeros(6), abs=1e-6 * omega**2)
        assert mode.damping_ratio == pytest.approx(shape @ damping @ shape / (2 * omega), rel=1e-6)


def test_energy_of_a_long_decay(tmp_path: Path) -> None:
    """A barge that is let go 1 m too high, heeled and trimmed, in water that remembers: what it has of energy
    never grows beyond that of the start, drag takes all but 1e-5 of it in ten minutes, and the books close to
    1e-6.
    """
    path = waves.radiating(
        tmp_path,
        {},
        {"draft": f"{DRAFT - 1} m", "heel": "3 deg", "trim": "1 deg"},
        duration="600 s",
        simulation={"sample_interval": "0.5 s"},
    )
    run = simulate(path)
    energy = dict(zip(run.dataset["energy_kind"].values, run.variables["energy"].values.T, strict=True))
    held = energy["kinetic"] + energy["gravity"] + energy["fluid"]
    given = -(held[-1] - held[0])
    assert held.max() <= held[0] + 1e-6 * given
    assert energy["drag"].min() >= 0.0
    assert energy["drag"][-1] + energy["method"][-1] == pytest.approx(given, rel=1e-9)
    assert abs(energy["method"][-1]) < 1e-5 * given
    # Heave, roll and pitch are at rest: what is left moves slower than 0.1 % of the energy allows.
    assert energy["kinetic"][-1] < 1e-3 * given
    assert np.abs(energy["remainder"]).max() < 1e-6 * given
