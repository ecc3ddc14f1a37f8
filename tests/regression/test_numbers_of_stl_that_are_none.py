"""A binary STL file with a byte gone wrong left a `RuntimeWarning` and a line of code above its error.

A corner that is a signalling NaN (0x7F800001, as one byte makes of 0x3F800001) was told as "invalid value
encountered in cast" first.
"""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest

from gantline.cad import CadError, read


def test_one_sentence_and_no_warning(tmp_path: Path) -> None:
    triangle = np.zeros(12, dtype="<u4")
    triangle[3:] = np.array([0, 0, 0, 1, 0, 0, 0, 1, 0], dtype="<f4").view("<u4")
    triangle[6] = 0x7F800001
    path = tmp_path / "hull.stl"
    path.write_bytes(bytes(80) + (1).to_bytes(4, "little") + triangle.tobytes() + bytes(2))
    with (
        warnings.catch_warnings(),
        pytest.raises(CadError, match=r"hull\.stl: a coordinate of the mesh is not a finite number$"),
    ):
        warnings.simplefilter("error")
        read(path, keep=False)
