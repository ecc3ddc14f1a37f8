"""A hydrodynamic database of a barge with forces by formulas, and lifts with the barge in waves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import databases
from afloat import BREADTH, DRAFT, KG, LENGTH, MASS, barge, lift_of, written
from floating import SEA
from gantline.results.variable import FloatArray

#: Frequencies of the file [rad/s] and directions that its waves run in, from x to y and on to -x.
FREQUENCIES = np.linspace(0.2, 3.0, 57)
DIRECTIONS = np.radians([0.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0])
G = 9.81
#: Added mass and damping about the middle of the waterline, at all frequencies alike: SI, symmetric, coupled.
ADDED = np.diag([8e5, 5e6, 3e7, 1e9, 1.5e10, 4e9])
ADDED[0, 4] = ADDED[4, 0] = -2e6
ADDED[1, 3] = ADDED[3, 1] = 3e6
DAMPING = 0.4 * np.diag([8e5, 3e6, 2.5e7, 4e8, 1.2e10, 3e9])
#: Radii of gyration of the barge [m].
RADII = np.array([11.0, 27.0, 27.0])


def force_per_metre(frequency: float, direction: float) -> Any:
    """Of Froude and Krylov on the box, about the middle of its waterline, time as exp(-iωt) (6,) [N/m, N].

    p = ρ g exp(κz + iκ(x cos β + y sin β)) on bottom and sides.
    """
    k = frequency**2 / G
    x, y = k * np.cos(direction), k * np.sin(direction)
    along, across = np.sinc(x * LENGTH / 2 / np.pi), np.sinc(y * BREADTH / 2 / np.pi)
    # ∫ x exp(i x' x) dx over the length, as a share of it.
    first = [_moment(wave, size) for wave, size in ((x, LENGTH), (y, BREADTH))]
    at_bottom = np.exp(-k * DRAFT)
    area, pressure = LENGTH * BREADTH, SEA * G
    deep = (1 - at_bottom) / k  # ∫ exp(κz) dz
    lever = -(1 - (1 + k * DRAFT) * at_bottom) / k**2  # ∫ z exp(κz) dz
    heave = pressure * area * at_bottom * along * across
    surge = -1j * x * pressure * area * along * across
    sway = -1j * y * pressure * area * along * across
    roll = pressure * area * at_bottom * along * first[1] - sway * lever
    pitch = -pressure * area * at_bottom * first[0] * across + surge * lever
    yaw = (-1j * y * first[0] * across + 1j * x * along * first[1]) * pressure * area * deep
    return np.array([surge * deep, sway * deep, heave, roll, pitch, yaw])


def _moment(wave: float, size: float) -> complex:
    if abs(wave * size) < 1e-9:
        return 0j
    half = wave * size / 2
    return complex(1j * (np.sin(half) - half * np.cos(half)) / (half * wave))


def database(folder: Path) -> str:
    """Name of the file, written beside a lift file."""
    order = np.argsort(databases.AXES)
    dims = ["omega", "radiating_dof", "influenced_dof"]
    count = len(FREQUENCIES)
    turned = {
        name: (dims, np.repeat(matrix[order][:, order][None], count, axis=0))
        for name, matrix in (("added_mass", ADDED), ("radiation_damping", DAMPING))
    }
    waves = np.array([[force_per_metre(w, b) for b in DIRECTIONS] for w in FREQUENCIES])[:, :, order]
    parts = np.stack([waves.real, waves.imag])
    wave_dims = ["complex", "omega", "wave_direction", "influenced_dof"]
    tables = {
        **turned,
        "Froude_Krylov_force": (wave_dims, parts),
        "diffraction_force": (wave_dims, 0.0 * parts),
        "rotation_center": (["xyz"], [0.0, 0.0, 0.0]),
    }
    coordinates = {"omega": FREQUENCIES, "wave_direction": DIRECTIONS, "rho": SEA}
    databases.capytaine(folder / "barge.nc", tables=tables, coordinates=coordinates)
    return "barge.nc"


def in_waves(folder: Path, waves: dict[str, Any], vessel: dict[str, Any] | None = None, **given: Any) -> Path:
    """The lift file of the barge in waves."""
    about = [f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"]
    name = database(folder)
    by_file = {"database": name, "period": "9 s", "at": about}
    of_water = {"added_mass": by_file, "water_damping": by_file}
    afloat = {**of_water, "wave_forces": {"database": name, "at": about}, **(vessel or {})}
    radii = [f"{radius} m" for radius in RADII]
    return written(
        folder, lift_of(barge(radii_of_gyration=radii, **afloat), waves=waves, start="as_given", **given)
    )


def response(frequency: float, force: Any) -> Any:
    """Motion of the barge about the middle of its waterline under a force there: (−ω²(M + A) − iωB + C)⁻¹ F.

    Args:
        frequency: ω [rad/s].
        force: complex (6,) [N, N m], vessel axes.
    """
    # c of the centre of gravity is (0, 0, KG − T).
    lever = np.array([[0.0, DRAFT - KG, 0.0], [KG - DRAFT, 0.0, 0.0], [0.0, 0.0, 0.0]])  # [c]×
    mass = np.zeros((6, 6))
    mass[:3, :3] = MASS * np.eye(3)
    mass[:3, 3:], mass[3:, :3] = -MASS * lever, MASS * lever
    mass[3:, 3:] = MASS * np.diag(RADII**2) - MASS * lever @ lever
    area, weight = LENGTH * BREADTH, MASS * G
    arms = -DRAFT / 2 - (KG - DRAFT) + np.array([BREADTH, LENGTH]) ** 2 / (12 * DRAFT)  # GM = KB − KG + BM
    stiffness = np.diag([0.0, 0.0, SEA * G * area, *(weight * arms), 0.0])
    whole = -(frequency**2) * (mass + ADDED) - 1j * frequency * DAMPING + stiffness
    return np.linalg.solve(whole, force)


def harmonic(time: FloatArray, value: FloatArray, frequency: float) -> complex:
    """X of Re(X exp(−iωt)) in a record of whole periods beside a mean and a drift, by least squares."""
    phase = frequency * time
    terms = np.stack([np.cos(phase), np.sin(phase), np.ones_like(time), time], axis=1)
    found = np.linalg.lstsq(terms, value, rcond=None)[0]
    return complex(found[0], found[1])
