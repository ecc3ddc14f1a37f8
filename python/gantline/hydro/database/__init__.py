"""Hydrodynamic databases: added mass, damping and wave forces over frequency, from files of wave programs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from gantline.arguments import path_of
from gantline.hydro.database.around import ForcesAround
from gantline.hydro.database.model import AXES, Coupling, DatabaseError, HydrodynamicDatabase
from gantline.hydro.database.writing import write_database

__all__ = [
    "AXES",
    "DATABASE_FORMATS",
    "Coupling",
    "DatabaseError",
    "ForcesAround",
    "HydrodynamicDatabase",
    "read_database",
    "write_database",
]

#: Endings of names, and what writes such files.
DATABASE_FORMATS = {".nc": "Capytaine", ".h5": "BEMIO", ".hdf5": "BEMIO", ".dhyd": "DAVE", ".hyd": "text"}


def read_database(path: str | Path, body: str | None = None) -> HydrodynamicDatabase:
    """What a wave program says about one body.

    Args:
        path: `.nc` of Capytaine, `.h5` of BEMIO, `.dhyd` of DAVE, or `.hyd` text.
        body: its name, where the file has several.

    Raises:
        DatabaseError: if the file cannot be read, or has no such body, with one plain sentence.
    """
    from gantline.hydro.database.opening import opened

    place = path_of(path, "the file of a database")
    reader = _reader(place)
    with opened(place):
        found = reader(place)
    names = [one.name for one in found]
    if body is None:
        if len(found) > 1:
            raise DatabaseError(
                f"{place}: has several bodies, {', '.join(names)}; name one of them by 'body'"
            )
        return found[0]
    if body not in names:
        raise DatabaseError(f"{place}: has no body '{body}'; it has {', '.join(names)}")
    return found[names.index(body)]


def _reader(place: Path) -> Callable[[Path], list[HydrodynamicDatabase]]:
    from gantline.hydro.database.bemio import read_bemio
    from gantline.hydro.database.netcdf import read_capytaine, read_dhyd
    from gantline.hydro.database.text import read_text

    readers = {
        ".nc": read_capytaine, ".h5": read_bemio, ".hdf5": read_bemio, ".dhyd": read_dhyd, ".hyd": read_text,
    }  # fmt: skip
    suffix = place.suffix.lower()
    if suffix not in readers:
        known = ", ".join(readers)
        raise DatabaseError(f"{place}: is no hydrodynamic database that can be read; these can: {known}")
    return readers[suffix]
