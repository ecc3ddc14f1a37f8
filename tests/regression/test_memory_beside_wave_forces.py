"""Databases with wave forces and periods above 126 s could not be used for `radiation` with memory.

The longest periods are left out of the fit, and the wave forces were then held against fewer frequencies
than they have: "its wave forces are 28 × 9 × 6; 25 frequencies need 25 × 9 × 6". Three of three real files
of DAVE were refused so. In such files each motion names frequencies and directions of its own, of which
only those of yaw were looked at.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest

import databases
import waves
from gantline.hydro import DatabaseError, HydrodynamicDatabase, fit_memory, read_database


def test_wave_forces_do_not_stand_in_the_way() -> None:
    """The memory is the same with and without them, and with what is slower than 0.05 rad/s."""
    omega = np.concatenate([[0.01, 0.02], waves.FREQUENCIES])
    added, damping = waves.radiated(omega)
    terms = waves.radiated(waves.FREQUENCIES)
    forces = np.ones((len(omega), 1, 6), dtype=complex)
    alone = HydrodynamicDatabase("b", "file", waves.FREQUENCIES, *terms, density=1025.0)
    whole = HydrodynamicDatabase("b", "file", omega, added, damping, density=1025.0)
    found = [
        fit_memory(one, 1025.0)
        for one in (alone, whole, replace(whole, directions=np.zeros(1), excitation=forces))
    ]
    for other in found[1:]:
        assert np.array_equal(other.infinite_added_mass, found[0].infinite_added_mass)


@pytest.mark.parametrize(
    ("table", "change", "says"),
    [
        ("omega", 1.5, "the wave forces of Sway have other frequencies than its damping"),
        ("wave_direction", 0.5, "the wave forces of Sway have other directions than Surge"),
    ],
)
def test_each_motion_has_the_same_waves(tmp_path: Path, table: str, change: float, says: str) -> None:
    path = databases.dhyd(tmp_path / "a.dhyd")
    with h5py.File(path, "r+") as file:
        values = file[f"Sway/{table}"]
        values[...] = change * values[...]
    with pytest.raises(DatabaseError, match=says):
        read_database(path)
