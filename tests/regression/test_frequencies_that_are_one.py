"""A database with two frequencies that differ by rounding was taken, and everything by it was wrong.

A file computed for periods of 3 s to 9 s by 0.5 s and more of them by 0.1 s had 3.5 s and
3.5000000000000004 s. Cubics over frequency went through both, by slopes of noise: yaw of `off_a_barge` was
3.78 deg for 4.06 deg.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gantline.hydro import DatabaseError, HydrodynamicDatabase, read_database

BARGE = Path(__file__).resolve().parents[2] / "scenarios" / "crane_barge_in_swell" / "crane_barge.nc"


def twice(place: int, apart: float) -> HydrodynamicDatabase:
    """The barge with one of its frequencies once more, that share of it higher."""
    known = read_database(BARGE)
    frequencies = np.insert(known.frequencies, place + 1, known.frequencies[place] * (1 + apart))
    added, damping = (np.insert(one, place, one[place], axis=0) for one in (known.added_mass, known.damping))
    return HydrodynamicDatabase("barge", "twice.nc", frequencies, added, damping, known.density)


@pytest.mark.parametrize("place", [0, 7, -1])
def test_it_is_refused_by_name(place: int) -> None:
    place %= len(read_database(BARGE).frequencies)
    which = f"{read_database(BARGE).frequencies[place]:.6g} rad/s"
    with pytest.raises(DatabaseError) as caught:
        twice(place, 2e-16 * 4)
    assert str(caught.value) == (
        f"twice.nc: it has two frequencies of {which} that differ by rounding; leave one of them out"
    )


def test_close_frequencies_are_two() -> None:
    assert len(twice(7, 1e-5).frequencies) == len(read_database(BARGE).frequencies) + 1
