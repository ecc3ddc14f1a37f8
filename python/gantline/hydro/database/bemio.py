"""BEMIO's HDF5 files, which WEC-Sim and HydroChrono read.

Where `scaled` is 0, as it is as a rule, they hold A/ρ, B/(ρω) and F/(ρg). Time goes as exp(iωt), as in WAMIT.
Matrices are about the centre of gravity that the file names.
"""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import numpy.typing as npt

from gantline.hydro.database.model import Coupling, DatabaseError, HydrodynamicDatabase
from gantline.hydro.database.opening import checked_hdf5, numbers, text_of

__all__ = ["read_bemio"]

Array = npt.NDArray[np.float64]


def read_bemio(path: Path) -> list[HydrodynamicDatabase]:
    """All bodies of a file.

    Raises:
        DatabaseError: If it is no such file, or something that it needs is not in it.
    """
    checked_hdf5(path)
    with h5py.File(path, "r") as file:
        bodies = [key for key in file if key.startswith("body") and f"{key}/hydro_coeffs" in file]
        if not bodies or "simulation_parameters" not in file:
            raise DatabaseError(f"{path}: has no 'body1/hydro_coeffs' as BEMIO's files have")
        bodies.sort(key=lambda key: (len(key), key))
        return [_body(path, file, key, bodies) for key in bodies]


def _single(file: h5py.File, name: str) -> float:
    values = numbers(file, name).reshape(-1)
    if values.size != 1:
        raise ValueError(f"'{name}' has {values.size} values; one is needed")
    return float(values[0])


def _body(path: Path, file: h5py.File, key: str, bodies: list[str]) -> HydrodynamicDatabase:
    parameters, place = "simulation_parameters", f"{key}/hydro_coeffs"
    density, gravity = _single(file, f"{parameters}/rho"), _single(file, f"{parameters}/g")
    is_scaled = f"{parameters}/scaled" in file and bool(_single(file, f"{parameters}/scaled"))
    omega = numbers(file, f"{parameters}/w").reshape(-1)
    factor = 1.0 if is_scaled else density
    first = _first(file, key)
    scales = (np.full(len(omega), factor), np.full(len(omega), factor) if is_scaled else factor * omega)
    tables = [
        (numbers(file, f"{place}/{name}/all"), scale[:, None, None])
        for name, scale in zip(("added_mass", "radiation_damping"), scales, strict=True)
    ]
    mass, damping = (_own(path, table, first, len(omega)) * scale for table, scale in tables)
    infinite = None
    if f"{place}/added_mass/inf_freq" in file:
        table = numbers(file, f"{place}/added_mass/inf_freq")
        infinite = _own(path, table[:, :, None], first, 1)[0] * factor
    order = np.argsort(omega)
    weight = 1.0 if is_scaled else density * gravity
    directions, excitation = _waves(file, place, weight, len(omega))
    drift = _drift(file, place, weight, (len(directions), len(omega)))
    depth = f"{parameters}/water_depth"
    volume = f"{key}/properties/disp_vol"
    return HydrodynamicDatabase(
        name=_name(file, key),
        source=f"{path.name} (BEMIO)",
        frequencies=omega[order],
        added_mass=mass[order],
        damping=damping[order],
        density=density,
        infinite_added_mass=infinite,
        reference=numbers(file, f"{key}/properties/cg").reshape(3)
        if f"{key}/properties/cg" in file
        else None,
        displacement=_single(file, volume) if volume in file else None,
        water_depth=_depth(file, depth) if depth in file else None,
        directions=directions,
        excitation=None if excitation is None else excitation[order],
        drift=None if drift is None else drift[order],
        others=_others(path, file, tables, [other for other in bodies if other != key], order),
    )


def _name(file: h5py.File, key: str) -> str:
    name = f"{key}/properties/name"
    return text_of(file[name][()]) if name in file else key


def _first(file: h5py.File, key: str) -> int:
    """First column of a body in the tables of all."""
    start = f"{key}/properties/dof_start"
    return int(_single(file, start)) - 1 if start in file else 0


def _others(
    path: Path,
    file: h5py.File,
    tables: list[tuple[Array, Array]],
    others: list[str],
    order: npt.NDArray[np.intp],
) -> dict[str, Coupling]:
    """What other bodies do to one by their names, where the file has it.

    Files put together of runs of one body each have zeros there, or no columns: each body was alone.
    """
    found = {}
    for other in others:
        first = _first(file, other)
        is_there = f"{other}/properties/dof_start" in file
        if is_there and all(table.shape[1] >= first + 6 for table, _ in tables):
            parts = ((_own(path, table, first, len(order)) * scale)[order] for table, scale in tables)
            coupling = Coupling(*parts)
            if any(table.any() for table in coupling):
                found[_name(file, other)] = coupling
    return found


def _depth(file: h5py.File, name: str) -> float | None:
    """A number, or the word 'infinite'."""
    value = file[name][()]
    if np.asarray(value).dtype.kind in "SOU":
        return np.inf if "inf" in text_of(value).lower() else None
    return _single(file, name)


def _own(path: Path, table: Array, first: int, count: int) -> Array:
    """Of (6, 6 bodies, n) what the body's own motions do, as (n, 6, 6)."""
    if table.ndim != 3 or table.shape[0] != 6 or table.shape[1] < first + 6 or table.shape[2] != count:
        shape = " × ".join(map(str, table.shape))
        raise DatabaseError(f"{path}: a table is {shape}; 6 × {first + 6} × {count} are needed")
    return table[:, first : first + 6].transpose(2, 0, 1)


def _waves(
    file: h5py.File, place: str, factor: float, count: int
) -> tuple[Array, npt.NDArray[np.complex128] | None]:
    tables = [f"{place}/excitation/{part}" for part in ("re", "im")]
    if not all(name in file for name in tables) or "simulation_parameters/wave_dir" not in file:
        return np.zeros(0), None
    directions = np.radians(numbers(file, "simulation_parameters/wave_dir").reshape(-1))
    real, imaginary = (numbers(file, name) for name in tables)
    if real.shape != (6, len(directions), count) or imaginary.shape != real.shape:
        return np.zeros(0), None
    # The other sign of time: the conjugate.
    forces = np.asarray((real - 1j * imaginary) * factor, dtype=np.complex128)
    return directions, forces.transpose(2, 1, 0)


def _drift(file: h5py.File, place: str, factor: float, shape: tuple[int, int]) -> Array | None:
    """Surge, sway and yaw (n, k, 3) by the first of the ways to compute them that the file has."""
    for way in ("momentum_conservation", "control_surface", "pressure_integration"):
        name = f"{place}/mean_drift/{way}/val"
        if name in file:
            table = numbers(file, name)
            if table.shape == (6, *shape) and table.any():
                return table[[0, 1, 5]].transpose(2, 1, 0) * factor
    return None
