"""A hydrodynamic database of a barge with forces by formulas, and lifts with the barge in waves."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import databases
from afloat import BREADTH, DRAFT, KG, LENGTH, MASS, barge, lift_of, written
from floating import SEA
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray

#: Frequencies of the file [rad/s] and directions that its waves run in, from x to y and on to -x.
FREQUENCIES = np.linspace(0.2, 3.0, 57)
DIRECTIONS = np.radians([0.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0])
G = 9.81
#: Added mass and damping by frequencies.
Water = Callable[[Any], tuple[Any, Any]]
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


def constant(frequencies: Any) -> tuple[Any, Any]:
    """Added mass and damping that are alike at all frequencies (n, 6, 6)."""
    alike = np.ones((len(frequencies), 1, 1))
    return alike * ADDED, alike * DAMPING


#: Oscillators C iω/(ω_j² − ω² + 2iζ_jω_jω) of a water with memory: ω_j, ζ_j, share of what they damp at most.
OSCILLATORS = ((0.6, 0.35, 1.0), (0.95, 0.45, 0.8), (1.5, 0.5, 0.3))
#: It couples surge with pitch and sway with roll.
_COUPLED = DAMPING.copy()
_COUPLED[0, 4] = _COUPLED[4, 0] = -0.3 * np.sqrt(DAMPING[0, 0] * DAMPING[4, 4])
_COUPLED[1, 3] = _COUPLED[3, 1] = 0.4 * np.sqrt(DAMPING[1, 1] * DAMPING[3, 3])


def radiated(frequencies: Any) -> tuple[Any, Any]:
    """Added mass and damping of that water (n, 6, 6), `ADDED` at infinite frequency."""
    s = 1j * np.asarray(frequencies)
    parts = [share * 2 * z * w * s / (w * w + 2 * z * w * s + s * s) for w, z, share in OSCILLATORS]
    answer = np.sum(parts, axis=0)[:, None, None] * _COUPLED
    return ADDED + answer.imag / np.asarray(frequencies)[:, None, None], answer.real


def database(
    folder: Path,
    water: Water = constant,
    reference: tuple[float, float, float] = (0.0, 0.0, 0.0),
    *,
    drift: Any = None,
    push: float = 1.0,
) -> str:
    """Name of the file, written beside a lift file; its forces are about the reference point [m].

    Args:
        drift: surge, sway and yaw over the amplitude squared, over FREQUENCIES and DIRECTIONS (n, k, 3).
        push: forces of first order are so many times those of Froude and Krylov.
    """
    order = np.argsort(databases.AXES)
    dims = ["omega", "radiating_dof", "influenced_dof"]
    turned = {
        name: (dims, matrix[:, order][:, :, order])
        for name, matrix in zip(("added_mass", "radiation_damping"), water(FREQUENCIES), strict=True)
    }
    waves = push * np.array([[force_per_metre(w, b) for b in DIRECTIONS] for w in FREQUENCIES])[:, :, order]
    parts = np.stack([waves.real, waves.imag])
    wave_dims = ["complex", "omega", "wave_direction", "influenced_dof"]
    tables = {
        **turned,
        "Froude_Krylov_force": (wave_dims, parts),
        "diffraction_force": (wave_dims, 0.0 * parts),
        "rotation_center": (["xyz"], list(reference)),
        "disp_volume": ([], LENGTH * BREADTH * DRAFT),
    }
    if drift is not None:
        names = [f"drift_force_{axis}" for axis in ("surge", "sway", "yaw")]
        tables |= {name: (["omega", "wave_direction"], drift[:, :, k]) for k, name in enumerate(names)}
    coordinates = {"omega": FREQUENCIES, "wave_direction": DIRECTIONS, "rho": SEA}
    databases.capytaine(folder / "barge.nc", tables=tables, coordinates=coordinates)
    return "barge.nc"


def in_waves(folder: Path, waves: dict[str, Any], vessel: dict[str, Any] | None = None, **given: Any) -> Path:
    """The lift file of the barge in waves, in a water of constant added mass and damping."""
    about = [f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"]
    name = database(folder)
    by_file = {"database": name, "period": "9 s", "at": about}
    of_water = {"added_mass": by_file, "water_damping": by_file}
    return _in_waves(folder, waves, name, {**of_water, **(vessel or {})}, **given)


def radiating(
    folder: Path, waves: dict[str, Any], vessel: dict[str, Any] | None = None, **given: Any
) -> Path:
    """The same in a water that remembers."""
    name = database(folder, radiated)
    about = [f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"]
    of_water = {"radiation": {"database": name, "at": about}}
    return _in_waves(folder, waves, name, {**of_water, **(vessel or {})}, **given)


def _in_waves(folder: Path, waves: dict[str, Any], name: str, vessel: dict[str, Any], **given: Any) -> Path:
    about = [f"{LENGTH / 2} m", "0 m", f"{DRAFT} m"]
    afloat = {"wave_forces": {"database": name, "at": about}, **vessel} if waves else vessel
    sea = {"waves": waves} if waves else {}
    radii = [f"{radius} m" for radius in RADII]
    lift = {"start": "as_given", **sea, **given}
    return written(folder, lift_of(barge(radii_of_gyration=radii, **afloat), **lift))


def response(frequency: float, force: Any, added: Any = ADDED, damping: Any = DAMPING) -> Any:
    """Motion of the barge about the middle of its waterline under a force there: (−ω²(M + A) − iωB + C)⁻¹ F.

    Args:
        frequency: ω [rad/s].
        force: complex (6,) [N, N m], vessel axes.
        added, damping: A and B (6, 6) about there, SI units.
    """
    return np.linalg.solve(impedance(frequency, added, damping), force)


def impedance(frequency: float, added: Any = ADDED, damping: Any = DAMPING) -> Any:
    """−ω²(M + A) − iωB + C of the barge about the middle of the waterline (6, 6), see `response`."""
    # c of the centre of gravity is (0, 0, KG − T).
    lever = np.array([[0.0, DRAFT - KG, 0.0], [KG - DRAFT, 0.0, 0.0], [0.0, 0.0, 0.0]])  # [c]×
    mass = np.zeros((6, 6))
    mass[:3, :3] = MASS * np.eye(3)
    mass[:3, 3:], mass[3:, :3] = -MASS * lever, MASS * lever
    mass[3:, 3:] = MASS * np.diag(RADII**2) - MASS * lever @ lever
    area, weight = LENGTH * BREADTH, MASS * G
    arms = -DRAFT / 2 - (KG - DRAFT) + np.array([BREADTH, LENGTH]) ** 2 / (12 * DRAFT)  # GM = KB − KG + BM
    stiffness = np.diag([0.0, 0.0, SEA * G * area, *(weight * arms), 0.0])
    return -(frequency**2) * (mass + added) - 1j * frequency * damping + stiffness


def harmonic(time: FloatArray, value: FloatArray, frequency: float) -> complex:
    """X of Re(X exp(−iωt)) in a record of whole periods beside a mean and a drift, by least squares."""
    phase = frequency * time
    terms = np.stack([np.cos(phase), np.sin(phase), np.ones_like(time), time], axis=1)
    found = np.linalg.lstsq(terms, value, rcond=None)[0]
    return complex(found[0], found[1])


def motion(run: Recording, frequency: float, heading: float = 0.0) -> Any:
    """Complex amplitudes of the last ten periods about the middle of the waterline, vessel axes (6,)."""
    place, orientation = (run.variables[f"body_{kind}"].values[:, 0] for kind in ("position", "orientation"))
    return amplitudes(run.time, place, orientation, frequency, heading)


def amplitudes(
    time: FloatArray, place: FloatArray, orientation: FloatArray, frequency: float, heading: float
) -> Any:
    """The same of the way of the barge's centre (n, 3) and of its orientation (n, 4)."""
    late = time > time[-1] - 20 * np.pi / frequency + 1e-9
    time, place, orientation = time[late], place[late], orientation[late]
    cos, sin = math.cos(heading), math.sin(heading)
    # Small rotation vectors in vessel axes are twice the vector part of q₀⁻¹ q, q₀ the heading.
    half = np.array([math.cos(heading / 2), math.sin(heading / 2)])
    w, x, y, z = orientation.T * np.sign(half @ orientation[0, [0, 3]])
    turned = 2 * np.array([half[0] * x + half[1] * y, half[0] * y - half[1] * x, half[0] * z - half[1] * w])
    at_centre = np.array([cos * place[:, 0] + sin * place[:, 1], cos * place[:, 1] - sin * place[:, 0]])
    lever = KG - DRAFT
    shift = np.array([at_centre[0] - lever * turned[1], at_centre[1] + lever * turned[0], place[:, 2]])
    return np.array([harmonic(time, one, frequency) for one in (*shift, *turned)])
