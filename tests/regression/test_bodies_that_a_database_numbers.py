"""A database of two bodies was refused for want of labels that nobody needs.

Its matrices name the bodies in their motions; its centres of rotation run over 'body', for which the file has
no labels, so that nothing tells which row is whose. It was read without them by xarray, and refused, with
'something is missing in it: body', since tables are read by h5py.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray

from gantline.hydro import read_database
from gantline.hydro.database import AXES


@pytest.mark.parametrize("labels", [True, False])
def test_it_is_read(tmp_path: Path, labels: bool) -> None:
    dofs = [f"{body}__{axis}" for body in ("barge", "ship") for axis in AXES]
    matrices = np.tile(np.diag(np.arange(1.0, 13.0)), (2, 1, 1))
    dims = ("omega", "influenced_dof", "radiating_dof")
    names = {"body": ["barge", "ship"]} if labels else {}
    path = tmp_path / "two.nc"
    xarray.Dataset(
        {
            "added_mass": (dims, matrices),
            "radiation_damping": (dims, matrices),
            "rotation_center": (("body", "xyz"), np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 2.0]])),
        },
        coords={"omega": [0.5, 1.0], "influenced_dof": dofs, "radiating_dof": dofs, **names},
    ).to_netcdf(path, engine="h5netcdf")
    found = read_database(path, "ship")
    # Motions 7 to 12 are the ship's.
    assert np.array_equal(np.diag(found.added_mass[0]), np.arange(7.0, 13.0))
    centre = None if found.reference is None else list(found.reference)
    assert centre == ([0.0, 0.0, 2.0] if labels else None)
