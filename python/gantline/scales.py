"""What the tables of NetCDF4 files run over, by h5py alone: dimensions there are scales of HDF5."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import h5py
import numpy as np

__all__ = ["alone", "said", "tables_of"]

#: How NetCDF4 names a dimension without a variable along it alone, and begins a variable of the same name.
_NO_VARIABLE, _BESIDE_DIMENSION = "This is a netCDF dimension but not a netCDF variable", "_nc4_non_coord_"


def tables_of(group: h5py.Group) -> Iterator[tuple[str, tuple[str, ...], h5py.Dataset]]:
    """Names of the tables of a NetCDF4 file or group, the dimensions of each, and its dataset."""
    file = group.file.id
    for key, stored in group.items():
        if not isinstance(stored, h5py.Dataset):
            continue
        name = key.removeprefix(_BESIDE_DIMENSION)
        if "DIMENSION_LIST" in stored.attrs:
            scales = (references[0] for references in stored.attrs["DIMENSION_LIST"])
            places = (h5py.h5i.get_name(h5py.h5r.dereference(scale, file)) for scale in scales)
            yield name, tuple(place.decode().rpartition("/")[2] for place in places), stored
        elif not (said(stored, "NAME") or "").startswith(_NO_VARIABLE):
            yield name, (name,) * stored.ndim, stored


def said(stored: h5py.Dataset, attribute: str) -> str | None:
    """A text that stands beside a dataset; None where it does not."""
    value = alone(stored.attrs.get(attribute))
    return value.decode() if isinstance(value, bytes) else None if value is None else str(value)


def alone(value: Any) -> Any:
    """The value of an attribute, also of one that another program has written as an array of one."""
    return value.item() if isinstance(value, np.ndarray) and value.size == 1 else value
