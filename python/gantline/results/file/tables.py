"""Tables of a NetCDF4 file, written by h5py alone: dimensions are scales of HDF5, and tables refer to them.

What has to stand beside each table, and why, is said by "NetCDF-4 File Format" in the NetCDF documentation
of Unidata. h5netcdf writes the same; it looks every dimension up anew for every table, which takes five
times as long.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

import h5py
import numpy as np

from gantline.scales import BESIDE_DIMENSION, NO_VARIABLE

__all__ = ["Tables"]

#: Samples in a chunk of a table that has none yet along a dimension without end.
_WITHOUT_END: Final = 1024


class Tables:
    """The dimensions and tables of a file that is being written.

    A dimension of length 0 is one without end, which is how NetCDF keeps it.
    """

    def __init__(self, file: h5py.File, sizes: Mapping[str, int]) -> None:
        """Begin a file that keeps the order of what is put in (`track_order`).

        Args:
            file: an empty file.
            sizes: all dimensions with their lengths.
        """
        self._file = file
        self._sizes = sizes
        self._numbers = {dim: number for number, dim in enumerate(sizes)}
        self._scales: dict[str, h5py.Dataset] = {}
        written_by = f"version=2,hdf5={h5py.version.hdf5_version},h5py={h5py.__version__}"
        file.attrs["_NCProperties"] = np.bytes_(written_by)

    def add(self, name: str, dims: tuple[str, ...], dtype: Any, **options: Any) -> h5py.Dataset:
        """A table of that name over dimensions, to be filled; along its own name it becomes their scale.

        What runs along a dimension alone has to be added before anything else that runs along it.

        Args:
            name: of the table.
            dims: its dimensions.
            dtype: type of its values.
            options: of `h5py.Group.create_dataset`: chunks and filters.
        """
        shape = tuple(self._sizes[dim] for dim in dims)
        if 0 in shape:
            options.setdefault("chunks", tuple(size or _WITHOUT_END for size in shape))
            options["maxshape"] = tuple(size or None for size in shape)
        is_scale = dims == (name,)
        key = f"{BESIDE_DIMENSION}{name}" if name in self._sizes and not is_scale else name
        table = self._file.create_dataset(key, shape, dtype=dtype, track_order=True, **options)
        if is_scale:
            self._make_scale(table, name, name)
        else:
            for axis, dim in enumerate(dims):
                h5py.h5ds.attach_scale(table.id, self._scale(dim).id, axis)
        numbers = np.array([self._numbers[dim] for dim in dims], dtype=np.int32)
        if dims:
            table.attrs["_Netcdf4Coordinates"] = numbers
        if dims and not is_scale:
            table.attrs["_Netcdf4Dimid"] = numbers[0]
        return table

    def finish(self) -> None:
        """Add the dimensions that nothing runs along."""
        for dim in self._sizes:
            self._scale(dim)

    def _scale(self, dim: str) -> h5py.Dataset:
        """The scale of a dimension, of one without a variable along it alone an empty one."""
        if dim not in self._scales:
            size = self._sizes[dim]
            options = {} if size else {"maxshape": (None,)}
            empty = self._file.create_dataset(dim, (size,), dtype=">f4", track_order=True, **options)
            self._make_scale(empty, dim, f"{NO_VARIABLE}.{size:10}")
        return self._scales[dim]

    def _make_scale(self, table: h5py.Dataset, dim: str, name: str) -> None:
        table.attrs["_Netcdf4Dimid"] = np.int32(self._numbers[dim])
        h5py.h5ds.set_scale(table.id, name.encode())
        self._scales[dim] = table
