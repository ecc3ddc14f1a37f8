"""What all readers of hydrodynamic databases do first: open the file, and refuse what is hostile."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import numpy.typing as npt

from gantline.hydro.database.model import DatabaseError

__all__ = ["checked_hdf5", "numbers", "opened", "text_of"]

#: Bytes of a file.
_LARGEST = 500_000_000
#: Numbers of one table of it.
_MOST = 50_000_000
#: Tables and groups of it.
_MOST_MEMBERS = 100_000

Array = npt.NDArray[np.float64]


@contextmanager
def opened(path: Path) -> Iterator[None]:
    """Whatever a broken file makes of its reader becomes one sentence.

    Raises:
        DatabaseError: if the file is missing, too large, or its reader fails.
    """
    try:
        size = path.stat().st_size
        if size > _LARGEST:
            raise DatabaseError(f"{path}: larger than {_LARGEST // 1_000_000} MB, so it is not read")
        if size == 0:
            raise DatabaseError(f"{path}: the file is empty")
        yield
    except DatabaseError:
        raise
    except FileNotFoundError as problem:
        raise DatabaseError(
            f"{path}: cannot be read ({(problem.strerror or str(problem)).lower()})"
        ) from None
    except KeyError as problem:
        missing = str(problem).strip("\"'").splitlines()[0]
        raise DatabaseError(f"{path}: something is missing in it: {missing}") from None
    except MemoryError:
        raise DatabaseError(f"{path}: it needs too much memory") from None
    except Exception as problem:  # whatever a broken file makes of its reader
        reason = str(problem).strip().splitlines()
        raise DatabaseError(
            f"{path}: it is no hydrodynamic database, or a broken one: {reason[0] if reason else problem!r}"
        ) from None


def checked_hdf5(path: Path) -> list[str]:
    """Names of all that an HDF5 file holds, once nothing in it leads to other files or is too large.

    Raises:
        DatabaseError: if something is.
    """
    names: list[str] = []
    if not h5py.is_hdf5(path):
        said = "it is no hydrodynamic database, or a broken one: it does not begin as HDF5 does"
        raise DatabaseError(f"{path}: {said}")
    with h5py.File(path, "r") as file:
        _walk(path, file, "", names)
    return names


def _walk(path: Path, group: h5py.Group, above: str, names: list[str]) -> None:
    for key in group:
        name = f"{above}{key}"
        if not isinstance(group.get(key, getlink=True), h5py.HardLink):
            raise DatabaseError(f"{path}: '{name}' is a link; a database that holds everything can be read")
        names.append(name)
        if len(names) > _MOST_MEMBERS or name.count("/") > 20:
            raise DatabaseError(f"{path}: it has more tables than a database can have")
        member = group[key]
        if isinstance(member, h5py.Group):
            _walk(path, member, f"{name}/", names)
        elif isinstance(member, h5py.Dataset):
            if member.external or member.is_virtual:
                raise DatabaseError(f"{path}: the numbers of '{name}' are in another file")
            if member.size is not None and member.size > _MOST:
                raise DatabaseError(f"{path}: '{name}' has {member.size} numbers, so it is not read")


def numbers(file: h5py.File, name: str) -> Array:
    """A table of an HDF5 file; KeyError with its name if there is none."""
    if name not in file or not isinstance(file[name], h5py.Dataset):
        raise KeyError(name)
    return np.asarray(file[name], dtype=float)


def text_of(value: Any) -> str:
    """A text of an HDF5 or NetCDF file, bytes or not, alone or in an array."""
    one = np.asarray(value).reshape(-1)[0] if np.asarray(value).size else ""
    return one.decode("utf-8", errors="replace") if isinstance(one, bytes) else str(one)
