"""What ropes that are no slings do to a load where they end at it."""

from __future__ import annotations

import numpy as np

from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import FloatArray


def upright_pull(recording: Recording, load: Load, rope: str) -> FloatArray:
    """Vertical part of the pull of a rope at the load that it ends at [N], shape (time,).

    Upwards is positive. Nothing of a rope that does not end at it, or of which nothing is drawn.
    """
    places = recording.points_of_ropes.get(rope)
    end = load.ends_of_ropes.get(rope)
    tension = recording.column("rope_tension", rope)
    if places is None or end is None:
        return np.zeros_like(tension)
    at, next_to = places[[0, 1]] if end == "first" else places[[-1, -2]]
    points = recording["rope_point"].values
    along = points[:, next_to] - points[:, at]
    length = np.linalg.norm(along, axis=1)
    upright = np.divide(along[:, 2], length, out=np.zeros_like(length), where=length > 0.0)
    pull: FloatArray = tension * upright
    return pull
