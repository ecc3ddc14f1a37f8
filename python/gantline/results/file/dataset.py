"""A recording as an `xarray.Dataset`; the only module that loads xarray."""

from __future__ import annotations

import numpy as np
import xarray

from gantline.results.recording import Recording


def dataset_of(recording: Recording) -> xarray.Dataset:
    """Variables and named dimensions of a recording as xarray has them.

    Args:
        recording: Any recording.

    Returns:
        Data set with `units` and `long_name` on every variable.
    """
    variables = {
        name: (variable.dims, variable.values, {"units": variable.unit, "long_name": variable.description})
        for name, variable in recording.variables.items()
    }
    coordinates = {name: variables.pop(name) for name in recording.sizes if name in variables}
    names = {dim: (dim, np.array(labels, dtype=object)) for dim, labels in recording.coordinates.items()}
    return xarray.Dataset(variables, coords={**coordinates, **names}, attrs=dict(recording.attributes))
