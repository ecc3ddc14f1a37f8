"""Arrays of numbers as one compressed run of bytes, with an index that says where each one is.

Two ways of writing, both little-endian:

- `plain`: float64, float32 or uint32 as they are;
- `steps`: whole numbers of a step (a micrometre, say), each row less the one before it, as int32 with all
  first bytes, then all second bytes and so on. What moves slowly becomes mostly zeros, which compress well.
  A value differs from the original by half a step at most.
"""

from __future__ import annotations

import math
import zlib
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

_PLAIN = {"f8": "<f8", "f4": "<f4", "u4": "<u4"}
_LARGEST = 2**31 - 1


@dataclass
class Arrays:
    """Arrays that are collected one by one.

    Attributes:
        index: What each array is: its type, shape, step, and where its bytes begin.
    """

    index: dict[str, dict[str, Any]] = field(default_factory=dict)
    _parts: list[bytes] = field(default_factory=list)
    _size: int = 0

    def plain(self, name: str, values: npt.ArrayLike, kind: str) -> None:
        """Add an array as it is.

        Args:
            name: Its name in the index.
            values: Numbers, any shape.
            kind: `f8`, `f4` or `u4`.
        """
        array = np.ascontiguousarray(np.asarray(values), dtype=_PLAIN[kind])
        self._add(name, {"type": kind, "shape": list(array.shape)}, array.tobytes())

    def steps(self, name: str, values: npt.NDArray[np.float64], step: float) -> None:
        """Add an array over time in whole steps.

        Args:
            name: Its name in the index.
            values: Shape (time, ...).
            step: Size of a step; it grows where the values are too large for it.

        Raises:
            ValueError: If a value is not finite.
        """
        if values.size and not np.isfinite(values).all():
            raise ValueError(f"{name} holds a value that is no number")
        largest = float(np.abs(values).max(initial=0.0))
        step = max(step, largest / (_LARGEST // 2))
        rows = np.rint(values.reshape(len(values), math.prod(values.shape[1:])) / step).astype(np.int64)
        change = np.diff(rows, axis=0, prepend=np.zeros((1, rows.shape[1]), dtype=np.int64))
        planes = np.ascontiguousarray(change.astype("<i4")).view(np.uint8).reshape(-1, 4).T
        about = {"type": "steps", "shape": list(values.shape), "step": step}
        self._add(name, about, np.ascontiguousarray(planes).tobytes())

    def packed(self) -> bytes:
        """All arrays, compressed by zlib."""
        return zlib.compress(b"".join(self._parts), 6)

    def _add(self, name: str, about: dict[str, Any], data: bytes) -> None:
        pad = -len(data) % 8  # every array begins where a float64 may begin
        self.index[name] = {**about, "at": self._size}
        self._parts += [data, bytes(pad)]
        self._size += len(data) + pad
