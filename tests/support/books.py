"""The books of a recording: sums of its kinds of energy."""

from __future__ import annotations

import numpy as np

from gantline.results.recording import Recording
from gantline.results.variable import FloatArray

STORED = ("kinetic", "gravity", "elastic", "fluid")
WORK = ("drive_work", "fluid_work")
LOSSES = (
    "rope_damping",
    "joint_damping",
    "contact_damping",
    "friction",
    "drag",
    "impact",
    "parting",
    "adjusting",
    "method",
)


def energy(recording: Recording, kinds: tuple[str, ...]) -> FloatArray:
    """Sum of the energies of some kinds [J], shape (time,); those of water or wind are not always there."""
    known = recording.coordinates["energy_kind"]
    total: FloatArray = np.sum([recording.column("energy", kind) for kind in kinds if kind in known], axis=0)
    return total + np.zeros(len(recording.time))
