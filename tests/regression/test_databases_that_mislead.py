"""Hydrodynamic databases whose numbers are for something else than a lift takes them for.

Capytaine drops the dimension of a single forward speed: added mass, damping and wave forces of a vessel at
5 m/s were read as those of one that lies still. Directions of waves in degrees, of a database by hand or of a
file that says 0, 30 … 180, were read as radians, 180 as 233°, and forces came from any side. A reference
point with two coordinates was written and lost when it was read.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import databases
from gantline.hydro import read_database
from gantline.hydro.database import DatabaseError


@pytest.mark.parametrize("speed", [5.0, [5.0], [0.0, 5.0]])
def test_a_vessel_under_way(tmp_path: Path, speed: Any) -> None:
    """One speed as a scalar, or as a dimension of one."""
    given: dict[str, Any] = {"coordinates": {"forward_speed": speed}}
    path = databases.capytaine(tmp_path / "fast.nc", **given)
    with pytest.raises(DatabaseError, match="is for a vessel at 5 m/s; one without speed can be read"):
        read_database(path)


def test_a_vessel_that_lies_still(tmp_path: Path) -> None:
    path = databases.capytaine(tmp_path / "still.nc", coordinates={"forward_speed": 0.0})
    assert len(read_database(path).frequencies) == 4


def test_directions_in_degrees(tmp_path: Path) -> None:
    """90 rad are 14 turns and 117°: no file means that."""
    path = databases.capytaine(tmp_path / "degrees.nc", coordinates={"wave_direction": [0.0, 90.0]})
    with pytest.raises(
        DatabaseError, match="its waves run in directions up to 90 rad; degrees are no radians"
    ):
        read_database(path)
    known = read_database(databases.capytaine(tmp_path / "a.nc"))
    with pytest.raises(DatabaseError, match="degrees are no radians"):
        replace(known, directions=np.array([0.0, 90.0]))
    # All around from behind, and all around from ahead, are both usual.
    for turn in (-2 * np.pi, 2 * np.pi):
        assert len(replace(known, directions=np.array([0.0, turn])).directions) == 2


@pytest.mark.parametrize(
    ("field", "shape", "says"),
    [
        (
            "excitation",
            (2, 4, 6),
            "its wave forces are 2 × 4 × 6; 4 frequencies and 2 directions need 4 × 2 × 6",
        ),
        ("directions", (3,), "its wave forces are 4 × 2 × 6; 4 frequencies and 3 directions need 4 × 3 × 6"),
        ("reference", (2,), "its reference point has 2 coordinates; x, y and z are needed"),
    ],
)
def test_what_has_another_shape(tmp_path: Path, field: str, shape: tuple[int, ...], says: str) -> None:
    """Of a database by hand; xarray said 'conflicting sizes for dimension' as it was written."""
    known = read_database(databases.capytaine(tmp_path / "a.nc"))
    changed: dict[str, Any] = {field: np.zeros(shape)}
    with pytest.raises(DatabaseError, match=says):
        replace(known, **changed)
