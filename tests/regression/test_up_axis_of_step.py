"""STEP and IGES from a program that has y up: `up: y` was read past, and the load lay on its side.

Only STL, OBJ and glTF were turned; of STEP and IGES neither pictures nor centre of gravity and inertia were.
Of an OCX file, which has the axes of the ship, it was read past without a word.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gantline.cad import Assumptions, CadError, read
from occt_files import written
from ocx_files import Writer, sample


@pytest.mark.usefixtures("occt_loaded")
@pytest.mark.parametrize("name", ["a.step", "a.igs"])
def test_y_up_is_turned(tmp_path: Path, name: str) -> None:
    """A box of 2 × 3 × 5 m with y up is 3 m high: x stays, −z becomes y, y becomes z."""
    path = written(tmp_path / name, "box((2000, 3000, 5000), (0, 10000, 0))")
    found = read(path, Assumptions(up="y"), keep=False)
    assert found.properties.centre == pytest.approx([1, -2.5, 11.5])
    assert found.box == pytest.approx(np.array([[0, -5, 10], [2, 0, 13]]), abs=1e-6)
    mass = 7850 * 30
    assert found.properties.inertia == pytest.approx(np.diag([34, 13, 29]) * mass / 12, abs=1e-6 * mass)


def test_ocx_has_the_axes_of_the_ship(tmp_path: Path) -> None:
    path = tmp_path / "a.3docx"
    path.write_bytes(sample(Writer()))
    assert read(path, Assumptions(up="z"), keep=False).parts
    with pytest.raises(CadError, match="its axes are those of the ship, as the format has it, so z is up"):
        read(path, Assumptions(up="y"), keep=False)
