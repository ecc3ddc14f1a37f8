"""How a point of a vessel moved in a run, as records of motion have it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from gantline.hydro import MotionRecord, write_motion_record
from gantline.results.recording import Recording
from gantline.results.rotation import axes


def motion_of(run: Recording, vessel: str, at: Any) -> Any:
    """Way of a point of a vessel at heading 0 from where it was, and its roll, pitch and yaw, yaw first.

    Shape (n, 6) [m, rad].
    """
    (one,) = (one for one in run.rig.vessels if one.name == vessel)
    body = run.coordinates["body"].index(one.body)
    turn = axes(run.variables["body_orientation"].values[:, body])
    place = run.variables["body_position"].values[:, body]
    place = place + turn @ (np.asarray(at) - np.array(one.centre_of_gravity))
    roll = np.arctan2(turn[:, 2, 1], turn[:, 2, 2])
    yaw = np.arctan2(turn[:, 1, 0], turn[:, 0, 0])
    return np.column_stack([place - place[0], roll, np.arcsin(-turn[:, 2, 0]), yaw])


def written_record(samples: Any, interval: float, path: Path) -> None:
    """A record of these samples (n, 6) [m, rad], as a table."""
    mean = samples.mean(axis=0)
    write_motion_record(MotionRecord(path.name, interval, samples - mean, mean), path)
