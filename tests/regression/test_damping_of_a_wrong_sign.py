"""A database whose damping has the wrong sign ended in a traceback; in one motion alone nothing was said.

A motion with less than a millionth of the largest damping makes no waves and has no memory. So had one with
damping below zero: heave of the barge with its sign slipped was simulated without any damping by waves, and
where all motions were so no matrix was left to unpack. A body that damps nothing ended there too.
"""

from __future__ import annotations

import numpy as np
import pytest

import waves
from gantline.hydro import DatabaseError, HydrodynamicDatabase, fit_memory


def barge(signs: list[float]) -> HydrodynamicDatabase:
    """A barge whose damping is changed by a factor for each motion, with what couples it to others."""
    added, damping = waves.radiated(waves.FREQUENCIES)
    roots = np.sqrt(np.abs(signs))
    damping = damping * np.outer(roots, roots)
    for motion, sign in enumerate(signs):
        damping[:, motion, motion] *= np.sign(sign)
    return HydrodynamicDatabase("barge", "made up", waves.FREQUENCIES, added, damping, 1025.0)


@pytest.mark.parametrize(
    ("signs", "says"),
    [
        ([1, 1, -1, 1, 1, 1], r"damping of heave \(-[\d.e+]+\) is below zero in the mean of all frequencies"),
        ([1, 1, 1, 1, -1, 1], r"damping of pitch \(-"),
        ([-1, -1, -1, -1, -1, -1], r"damping of surge \(-.*, yaw \(-.* a sign has slipped"),
        ([0, 0, 0, 0, 0, 0], "it damps nothing, so water remembers nothing"),
    ],
)
def test_it_is_refused(signs: list[float], says: str) -> None:
    with pytest.raises(DatabaseError, match=says):
        fit_memory(barge(signs), 1025.0)


def test_noise_below_zero_is_none() -> None:
    """A motion that hardly makes waves, with damping below zero by a thousandth of the largest."""
    noisy, none = (fit_memory(barge([1, 1, 1, 1, 1, yaw]), 1025.0) for yaw in (-1e-3, 0.0))
    # Yaw is remembered no more than where it makes no waves at all, and nothing else is touched.
    np.testing.assert_array_equal(noisy.strengths, none.strengths)
    assert not noisy.strengths[:, 5].any() and noisy.strengths.any()
