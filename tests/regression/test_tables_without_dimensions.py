"""A file of tables that do not say what they run over was refused below a warning of a library.

Plain HDF5 under the name of a NetCDF file, with all tables of a database but no dimensions: 'UserWarning: The
'phony_dims' kwarg now defaults to 'access'' stood on the terminal, and below it that there is no 'omega',
which there is.
"""

from __future__ import annotations

import warnings
from pathlib import Path

import h5py
import numpy as np
import pytest

from gantline.hydro import DatabaseError, read_database
from gantline.hydro.database import AXES


def test_it_is_told_in_a_sentence(tmp_path: Path) -> None:
    path = tmp_path / "barge.nc"
    with h5py.File(path, "w") as file:
        file["omega"] = [0.5, 1.0]
        file["influenced_dof"], file["radiating_dof"] = list(AXES), list(AXES)
        for name in ("added_mass", "radiation_damping"):
            file[name] = np.tile(np.eye(6), (2, 1, 1))
    with warnings.catch_warnings(), pytest.raises(DatabaseError) as refused:
        warnings.simplefilter("error")
        read_database(path)
    assert str(refused.value) == f"{path}: its 'added_mass' does not run over 'omega'"
