"""Small hydrodynamic databases in every format that is read, all of the same made-up body."""

from __future__ import annotations

import pickle
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import h5py
import numpy as np
import xarray as xr

AXES = ("Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw")
OMEGA = np.array([0.4, 0.5, 0.8, 1.0])
DENSITY, GRAVITY = 1000.0, 9.81
DIRECTIONS = np.radians([0.0, 90.0])


def _pattern() -> np.ndarray[Any, np.dtype[np.float64]]:
    """Symmetric with a positive diagonal: surge couples with pitch, sway with roll."""
    matrix = np.diag([10.0, 30.0, 90.0, 400.0, 9000.0, 8000.0])
    matrix[0, 4] = matrix[4, 0] = 50.0
    matrix[1, 3] = matrix[3, 1] = -20.0
    return matrix * 1e3


ADDED = np.array([(2 - omega) * _pattern() for omega in OMEGA])
DAMPING = np.array([0.3 * omega * _pattern() for omega in OMEGA])
INFINITE = 0.5 * _pattern()
EXCITATION = (
    np.array(
        [[[(k + 1) * omega + 1j * (d + 1) * 0.1 for k in range(6)] for d in range(2)] for omega in OMEGA]
    )
    * 1e6
)
#: Surge, sway and yaw of drift forces.
DRIFT = (
    np.array([[[(k + 1) * omega * (d - 2.0) for k in range(3)] for d in range(2)] for omega in OMEGA]) * 1e3
)


def capytaine(path: Path, *, prefix: str = "", **changes: Any) -> Path:
    """As Capytaine writes it: motions in alphabetical order, an infinite frequency, two parts of a force."""
    path.write_bytes(_capytaine(pickle.dumps((prefix, changes))))
    return path


@cache
def _capytaine(pickled: bytes) -> bytes:
    """The same file, which tests ask for again and again, as its bytes."""
    prefix, changes = pickle.loads(pickled)
    order = np.argsort(AXES)
    names = [f"{prefix}{AXES[k]}" for k in order]
    dims = ["omega", "radiating_dof", "influenced_dof"]

    def radiation(values: Any, infinite: Any) -> Any:
        # Files have what motion k does to force i at [k, i].
        return np.concatenate([values, [infinite]])[:, order][:, :, order].transpose(0, 2, 1)

    waves = np.concatenate([EXCITATION, np.zeros((1, 2, 6))])[:, :, order]
    parts = np.stack([waves.real, waves.imag])
    wave_dims = ["complex", "omega", "wave_direction", "influenced_dof"]
    tables: dict[str, Any] = {
        "added_mass": (dims, radiation(ADDED, INFINITE)),
        "radiation_damping": (dims, radiation(DAMPING, 0 * INFINITE)),
        "Froude_Krylov_force": (wave_dims, 0.25 * parts),
        "diffraction_force": (wave_dims, 0.75 * parts),
        "rotation_center": (["xyz"], [1.0, 0.0, -2.0]),
        "disp_volume": ([], 77.0),
    }
    coordinates: dict[str, Any] = {
        "omega": [*OMEGA, np.inf],
        "radiating_dof": names,
        "influenced_dof": names,
        "wave_direction": DIRECTIONS,
        "complex": ["re", "im"],
        "rho": DENSITY,
        "g": GRAVITY,
        "water_depth": np.inf,
        "body_name": "box",
    }
    tables |= changes.get("tables", {})
    coordinates |= changes.get("coordinates", {})
    for name in changes.get("without", ()):
        tables.pop(name)
    with TemporaryDirectory() as folder:
        path = Path(folder) / "of_capytaine.nc"
        xr.Dataset(tables, coordinates).to_netcdf(path, engine="h5netcdf")
        return path.read_bytes()


def drifting(path: Path) -> Path:
    """The same with drift forces as Capytaine has them: of pairs of waves; those alike count."""
    tables = {}
    for k, axis in enumerate(("surge", "sway", "yaw")):
        pairs = np.full((len(OMEGA) + 1, 2, 2), 7e9 + 5e9j)
        for both in range(2):
            pairs[:, both, both] = [*DRIFT[:, both, k], 0.0]
        dims = ["complex", "omega", "wave_direction_k", "wave_direction_l"]
        tables[f"drift_force_{axis}"] = (dims, np.stack([pairs.real, pairs.imag]))
    ways = {f"wave_direction_{which}": DIRECTIONS for which in "kl"}
    return capytaine(path, tables=tables, coordinates=ways)


def bemio(path: Path, *, scaled: bool = False, bodies: int = 1) -> Path:
    """As BEMIO writes it: A/ρ, B/(ρω), F/(ρg) with time as exp(iωt), frequencies last."""
    with h5py.File(path, "w") as file:
        parameters = file.create_group("simulation_parameters")
        for name, value in (
            ("rho", DENSITY),
            ("g", GRAVITY),
            ("scaled", float(scaled)),
            ("water_depth", 50.0),
        ):
            parameters[name] = np.array([[value]])
        parameters["w"] = OMEGA[:, None]
        parameters["wave_dir"] = np.degrees(DIRECTIONS)[:, None]
        factor = 1.0 if scaled else DENSITY
        omega = np.ones(len(OMEGA)) if scaled else OMEGA
        for number in range(1, bodies + 1):
            first = 6 * (number - 1)
            wide = np.zeros((6, 6 * bodies, len(OMEGA)))
            wide[:, first : first + 6] = ADDED.transpose(1, 2, 0) / factor
            damped = np.zeros_like(wide)
            damped[:, first : first + 6] = (DAMPING / omega[:, None, None]).transpose(1, 2, 0) / factor
            far = np.zeros((6, 6 * bodies))
            far[:, first : first + 6] = INFINITE / factor
            place = f"body{number}/hydro_coeffs"
            file[f"{place}/added_mass/all"], file[f"{place}/added_mass/inf_freq"] = wide, far
            file[f"{place}/radiation_damping/all"] = damped
            waves = EXCITATION.transpose(2, 1, 0) / (1.0 if scaled else DENSITY * GRAVITY)
            file[f"{place}/excitation/re"], file[f"{place}/excitation/im"] = waves.real, -waves.imag
            drift = np.zeros((6, 2, len(OMEGA)))
            drift[[0, 1, 5]] = DRIFT.transpose(2, 1, 0) / (1.0 if scaled else DENSITY * GRAVITY)
            file[f"{place}/mean_drift/control_surface/val"] = drift
            properties = f"body{number}/properties"
            file[f"{properties}/name"] = np.bytes_(f"box{number}")
            file[f"{properties}/cg"] = np.array([[1.0], [0.0], [-2.0]])
            file[f"{properties}/disp_vol"] = np.array([[77.0]])
            file[f"{properties}/dof_start"] = np.array([[float(first + 1)]])
    return path


def dhyd(path: Path) -> Path:
    """As DAVE has it: groups of NetCDF tables in tonnes and kilonewtons, motions in alphabetical order."""
    order = np.argsort(AXES)
    names = [AXES[k] for k in order]
    scalars = {"rho": DENSITY, "g": GRAVITY, "water_depth": np.inf, "body_name": "box"}
    dims = ["omega", "radiating_dof", "influenced_dof"]
    coordinates = {"omega": OMEGA, "radiating_dof": names, "influenced_dof": names, **scalars}
    for group, name, values in (
        ("mass", "added_mass", ADDED),
        ("damping", "radiation_damping", DAMPING),
    ):
        table = values[:, order][:, :, order].transpose(0, 2, 1) / 1e3
        xr.Dataset({name: (dims, table)}, coordinates).to_netcdf(
            path, mode="w" if group == "mass" else "a", group=group, engine="h5netcdf"
        )
    for k, axis in enumerate(AXES):
        waves = EXCITATION[:, :, k] / 1e3
        tables = {
            "real": (["omega", "wave_direction"], waves.real),
            "imag": (["omega", "wave_direction"], waves.imag),
        }
        xr.Dataset(tables, {"omega": OMEGA, "wave_direction": np.degrees(DIRECTIONS), **scalars}).to_netcdf(
            path, mode="a", group=axis, engine="h5netcdf"
        )
    return path


def text(path: Path) -> Path:
    """Lines of ten-character columns in tonnes and kilonewtons, which may touch."""

    def line(key: str, *values: float) -> str:
        return f"{key:<10}" + "".join(f"{value:>10.5g}" for value in values)

    lines = [line("IDENT"), line("REFS", 1.0, 0.0, -2.0, 0.0), line("PARA", len(OMEGA), 0, 0)]
    for omega, added, damping in zip(OMEGA, ADDED, DAMPING, strict=True):
        lines.append(line("OMEGA", omega))
        lines += [line("ADMAS", *row / 1e3) for row in added]
        lines += [line("BDAMP", *row / 1e3) for row in damping]
        lines += [line("WDIR", 0.0), line("FAMP", *[1.0] * 6), line("FEPS", *[90.0] * 6)]
    path.write_text("\n".join([*lines, line("END")]), encoding="utf-8")
    return path
