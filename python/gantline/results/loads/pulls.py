"""What ropes that are no slings do to a load where they end at it."""

from __future__ import annotations

import numpy as np

from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import FloatArray


def pull_at_end(recording: Recording, rope: str, end: str) -> FloatArray:
    """The pull of a rope at what one of its ends is made fast to, shape (time, 3) [N], world axes.

    Nothing of a rope of which nothing is drawn.

    Args:
        recording: The recording.
        rope: Name of the rope.
        end: Which of its ends: `first` or `last`.
    """
    tension = recording.column("rope_tension", rope)
    places = recording.points_of_ropes.get(rope)
    if places is None:
        return np.zeros((len(tension), 3))
    at, next_to = places[[0, 1]] if end == "first" else places[[-1, -2]]
    points = recording["rope_point"].values
    along = points[:, next_to] - points[:, at]
    length = np.linalg.norm(along, axis=1, keepdims=True)
    unit = np.divide(along, length, out=np.zeros_like(along), where=length > 0.0)
    pull: FloatArray = tension[:, None] * unit
    return pull


def upright_pull(recording: Recording, load: Load, rope: str) -> FloatArray:
    """Vertical part of the pull of a rope at the load that it ends at [N], shape (time,).

    Upwards is positive. Nothing of a rope that does not end at it, or of which nothing is drawn.
    """
    end = load.ends_of_ropes.get(rope)
    if end is None:
        return np.zeros_like(recording.column("rope_tension", rope))
    upright: FloatArray = pull_at_end(recording, rope, end)[:, 2]
    return upright
