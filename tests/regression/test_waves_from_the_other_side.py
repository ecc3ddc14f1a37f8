"""Waves on a body beside another were mirrored where a file has one side only.

A hull by itself has two sides alike, so half of the directions will do. With a neighbour on its port side it
has not: waves that come over the neighbour were taken for those that come from the open sea, and the other
way round.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import two_hulls
from gantline.hydro import read_database
from gantline.hydro.database import DatabaseError


def test_one_side_tells_nothing_of_the_other(tmp_path: Path) -> None:
    half = np.radians(np.arange(0.0, 181.0, 30.0))
    found = read_database(two_hulls.database(tmp_path / "two.nc", directions=half), "left")
    assert found.excitation_at(np.array([0.7]), np.radians(100.0), 1025.0)[1] == []
    with pytest.raises(DatabaseError) as caught:
        found.excitation_at(np.array([0.7]), np.radians(260.0), 1025.0)
    said = "no waves that run 260 deg from its bow; it has 0, 30, 60, 90, 120, 150, 180 deg, and beside other"
    assert f"two.nc (Capytaine): {said} bodies those of one side are no mirror image" in str(caught.value)
