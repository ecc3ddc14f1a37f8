"""Databases as files in the form of Capytaine's, for numbers that come from anywhere else."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from gantline.arguments import needed, path_of
from gantline.hydro.database.model import AXES, DRIFTING, DatabaseError, HydrodynamicDatabase
from gantline.replacing import ROOM_OF_TABLES, hold_room, replaced

__all__ = ["write_database"]


def write_database(database: HydrodynamicDatabase, path: str | Path) -> Path:
    """Write a database as NetCDF, so that a lift file can name it: what `read_database` reads is the same.

    Matrices are [force, motion] over surge, sway, heave, roll, pitch and yaw, about `reference`. Time goes as
    exp(−iωt): of a program with exp(+iωt) wave forces are the conjugates.

    Args:
        database: What it says about one body. `source` and `doubts` are not written.
        path: File to write, ending in `.nc`; an existing one is replaced.

    Returns:
        The path written.

    Raises:
        DatabaseError: If the name does not end in `.nc`, or other bodies lie beside it.
        OSError: If it cannot be written there.
    """
    import xarray

    right = "gantline.hydro.read_database reads one"
    needed(database, HydrodynamicDatabase, "a hydrodynamic database", right)
    place = path_of(path, "a file to write")
    if place.suffix.lower() != ".nc":
        raise DatabaseError(f"{place}: has to end in '.nc'")
    if database.others:
        beside = f"{database.name} lies beside {', '.join(database.others)}"
        raise DatabaseError(f"{place}: {beside} in its file; one that lies alone can be written")
    omega, mass, damping = database.frequencies, database.added_mass, database.damping
    waves, drift = database.excitation, database.drift
    if database.infinite_added_mass is not None:
        nothing = np.zeros((1, 6, 6))
        omega = np.append(omega, np.inf)
        mass = np.concatenate([mass, database.infinite_added_mass[np.newaxis]])
        damping = np.concatenate([damping, nothing])
        waves, drift = (
            None if table is None else np.concatenate([table, np.zeros((1, *table.shape[1:]))])
            for table in (waves, drift)
        )
    of_matrix = ("omega", "influenced_dof", "radiating_dof")
    tables: dict[str, Any] = {"added_mass": (of_matrix, mass), "radiation_damping": (of_matrix, damping)}
    motions = [axis.capitalize() for axis in AXES]
    coordinates: dict[str, Any] = {
        "omega": omega,
        "influenced_dof": motions,
        "radiating_dof": motions,
        "body_name": database.name,
    }
    if database.density is not None:
        coordinates["rho"] = database.density
    if waves is not None:
        parts = np.stack([waves.real, waves.imag])
        of_waves = ("complex", "omega", "wave_direction", "influenced_dof")
        # Only their sum counts.
        tables |= {"Froude_Krylov_force": (of_waves, parts), "diffraction_force": (of_waves, 0.0 * parts)}
        coordinates["complex"] = ["re", "im"]
    if drift is not None:
        of_drift = ("omega", "wave_direction")
        tables |= {f"drift_force_{axis}": (of_drift, drift[:, :, k]) for k, axis in enumerate(DRIFTING)}
    if len(database.directions):
        coordinates["wave_direction"] = database.directions
    if database.water_depth is not None:
        coordinates["water_depth"] = database.water_depth
    if database.reference is not None:
        tables["rotation_center"] = (("xyz",), database.reference)
    if database.displacement is not None:
        tables["disp_volume"] = ((), np.asarray(database.displacement))
    dataset = xarray.Dataset(tables, coordinates)
    with replaced(place) as written:
        with written.open("r+b") as empty:
            # Given back as xarray begins the file anew, a moment later.
            hold_room(empty.fileno(), dataset.nbytes + ROOM_OF_TABLES, place)
        dataset.to_netcdf(written, engine="h5netcdf")
    return place
