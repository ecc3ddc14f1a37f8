"""Arrays of packed recordings, read as a page reads them."""

from __future__ import annotations

import zlib

import numpy as np
import numpy.typing as npt

from gantline.viewer import Packed

Array = npt.NDArray[np.float64]


def unpacked(packed: Packed, name: str) -> Array:
    """An array of a packed recording, read as the page does."""
    entry = packed.header["arrays"][name]
    count = int(np.prod(entry["shape"]))
    data = zlib.decompress(packed.data)[entry["at"] :]
    if entry["type"] != "steps":
        kind = {"f8": "<f8", "f4": "<f4", "u4": "<u4"}[entry["type"]]
        return np.frombuffer(data, dtype=kind, count=count).reshape(entry["shape"]).astype(np.float64)
    planes = np.frombuffer(data, dtype=np.uint8, count=4 * count).reshape(4, count)
    change = np.ascontiguousarray(planes.T).view("<i4").reshape(entry["shape"])
    return np.cumsum(change, axis=0, dtype=np.float64) * float(entry["step"])
