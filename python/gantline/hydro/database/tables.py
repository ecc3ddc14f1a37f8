"""Tables of NetCDF files by the names of what they run over, read as they are asked for.

xarray would read them, but takes a third of a second to load, and a tenth for each file.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import numpy.typing as npt

from gantline.hydro.database.opening import checked_hdf5
from gantline.scales import alone, tables_of

__all__ = ["Table", "Tables", "tables_in"]

Values = npt.NDArray[Any]


@dataclass(frozen=True, eq=False)
class Table:
    """Values, and the names of what they run over.

    Attributes:
        name: Its name.
        dims: What each axis runs over.
        values: Numbers, or texts.
    """

    name: str
    dims: tuple[str, ...]
    values: Values

    def over(self, *wanted: str) -> Values:
        """The values over these alone, in this order.

        Raises:
            ValueError: If the table does not run over one of them, or over something else as well.
        """
        if not self.runs_over(*wanted):
            raise ValueError(f"'{self.name}' runs over {', '.join(self.dims)}, not {', '.join(wanted)}")
        kept = [dim for dim in self.dims if dim in wanted]
        singles = tuple(axis for axis, dim in enumerate(self.dims) if dim not in wanted)
        return self.values.squeeze(singles).transpose([kept.index(dim) for dim in wanted])

    def runs_over(self, *wanted: str) -> bool:
        """Whether it runs over all of these, and over one thing alone of each other kind."""
        sizes = zip(self.dims, self.values.shape, strict=True)
        return set(wanted) <= set(self.dims) and all(size == 1 for dim, size in sizes if dim not in wanted)

    def at(self, dim: str, place: int) -> Table:
        """The part at a place along one of `dims`."""
        axis = self.dims.index(dim)
        return Table(self.name, self.dims[:axis] + self.dims[axis + 1 :], self.values.take(place, axis=axis))


class Tables(Mapping[str, Table]):
    """The tables of a file, or of one of its groups, by name; each is read when it is asked for."""

    def __init__(self, readers: Mapping[str, Callable[[], Table]]) -> None:
        self._readers = readers

    def __getitem__(self, name: str) -> Table:
        return self._readers[name]()

    def __iter__(self) -> Iterator[str]:
        return iter(self._readers)

    def __len__(self) -> int:
        return len(self._readers)

    def __contains__(self, name: object) -> bool:
        return name in self._readers  # that of a mapping would read it


@contextmanager
def tables_in(path: Path, group: str | None = None) -> Iterator[Tables]:
    """A NetCDF file, or one of its groups, of the fourth version or of an older one.

    Raises:
        DatabaseError: If something in it leads to other files or is too large.
    """
    with path.open("rb") as file:
        start = file.read(4)
    if start[:3] == b"CDF":
        from scipy.io import netcdf_file  # takes a while to load, and such files are rare

        with netcdf_file(path, mmap=False) as older:
            yield Tables({name: _older(name, stored) for name, stored in older.variables.items()})
        return
    checked_hdf5(path)
    with h5py.File(path, "r") as newer:
        stored = tables_of(newer if group is None else newer[group])
        yield Tables({name: _newer(name, dims, one) for name, dims, one in stored})


def _older(name: str, stored: Any) -> Callable[[], Table]:
    return lambda: _table(name, tuple(stored.dimensions), np.asarray(stored.data), vars(stored))


def _newer(name: str, dims: tuple[str, ...], stored: h5py.Dataset) -> Callable[[], Table]:
    return lambda: _table(name, dims, np.asarray(stored[()]), stored.attrs)


def _table(name: str, dims: tuple[str, ...], values: Values, attributes: Mapping[str, Any]) -> Table:
    """As the conventions of NetCDF have it: texts letter by letter, gaps by a number, numbers packed."""
    if values.dtype == "S1" and dims:
        letters = np.ascontiguousarray(values)
        return Table(name, dims[:-1], letters.view(f"S{letters.shape[-1]}")[..., 0])
    if values.dtype.kind not in "iuf":
        return Table(name, dims, values)
    gaps = [attributes[key] for key in ("_FillValue", "missing_value") if key in attributes]
    scale, offset = (
        float(alone(attributes.get(key, unset))) for key, unset in (("scale_factor", 1), ("add_offset", 0))
    )
    if gaps:
        values = np.where(np.isin(values, [alone(gap) for gap in gaps]), np.nan, values)
    return Table(name, dims, values if (scale, offset) == (1.0, 0.0) else values * scale + offset)
