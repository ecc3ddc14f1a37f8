"""How far sheaves turn and how long ropes are by themselves, from the recorded path alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.variable import FloatArray

_ON_SHEAVE = 1e-3  # of the radius: how near to its circle a rope must run to lie on it
_CONSTANT = 2e-4  # of the length: a rope whose own length is found to vary by more runs onto a drum


def sheave_angles(
    recording: Recording,
    frames: Sequence[int],
    sheaves: Sequence[Mapping[str, Any]],
    poses: Mapping[str, Any],
) -> FloatArray:
    """Angles by which sheaves have turned about their axes since the start [rad].

    A sheave turns by the rope that passes it over its radius; what has passed is what the path from the
    rope's first end to the middle of the arc has lost in length. A rope that a drum at its first end pays out
    therefore turns its sheaves by what lies between, without what the drum lets go.

    Args:
        recording: Any recording with drawn paths.
        frames: Samples that are wanted.
        sheaves: Entries of the scene.
        poses: Centre of gravity in the body frame of each body [m].

    Returns:
        Shape (frames, sheaves); 0 for a sheave on which no rope lies at the first frame.
    """
    angles = np.zeros((len(frames), len(sheaves)))
    if "rope_point" not in recording or not len(frames):
        return angles
    points = recording["rope_point"].values[list(frames)]
    ropes = {name: points[:, places] for name, places in recording.points_of_ropes.items()}
    lengths = {name: _along(path) for name, path in ropes.items()}
    for column, sheave in enumerate(sheaves):
        body = sheave["body"]
        turn = axes(recording.column("body_orientation", body)[frames[0]])
        middle = recording.column("body_position", body)[frames[0]] + turn @ (
            np.asarray(sheave["centre"], dtype=np.float64) - poses[body]
        )
        axis, radius = turn @ np.asarray(sheave["axis"], dtype=np.float64), float(sheave["radius"])
        found = _arc(ropes, middle, axis, radius)
        if found is None:
            continue
        rope, at, sign = found
        passed = lengths[rope][0, at] - lengths[rope][:, at]
        angles[:, column] = sign * passed / radius
    return angles


def natural_lengths(recording: Recording, frames: Sequence[int]) -> list[float | None]:
    """Length of each rope without tension [m]; None where that is not known or varies.

    Slings and ropes made fast say it; of others it follows from length, tension and stiffness while they
    are taut.

    Args:
        recording: Any recording with drawn paths.
        frames: Samples that are looked at.
    """
    at = np.array(frames, dtype=np.intp)
    hoists = {one.name for one in recording.rig.chain_hoists}
    slings = {sling.rope: sling.length for sling in recording.rig.slings if sling.name not in hoists}
    found: list[float | None] = []
    for name in recording.coordinates.get("rope", ()):
        if slings.get(name):
            found.append(slings[name])
            continue
        known = recording.rig.rope(name)
        if known is not None and known.length:
            found.append(known.length)
            continue
        if known is None or not (known.axial_stiffness or known.curve) or known.nodes:
            found.append(None)
            continue
        tension = recording.column("rope_tension", name)[at]
        # The path's length: segments alone leave the arcs out.
        places = recording.points_of_ropes.get(name)
        if places is None:
            found.append(None)
            continue
        length = _along(recording["rope_point"].values[np.ix_(at, places)])[:, -1]
        taut = tension > 0.0
        strains = [known.strain(float(force)) for force in tension[taut]]
        own = length[taut] / np.array([1.0 + strain[0] for strain in strains if strain is not None])
        constant = own.size and np.ptp(own) <= _CONSTANT * float(own.max())
        found.append(float(np.median(own)) if constant else None)
    return found


def _along(path: FloatArray) -> FloatArray:
    """Length of a path up to each of its points [m], shape (frames, points)."""
    pieces = np.linalg.norm(np.diff(path, axis=1), axis=2)
    return np.concatenate([np.zeros((len(path), 1)), np.cumsum(pieces, axis=1)], axis=1)


def _arc(
    ropes: Mapping[str, FloatArray], middle: FloatArray, axis: FloatArray, radius: float
) -> tuple[str, int, float] | None:
    """The rope on a sheave at the first frame, the middle of its arc, and which way it turns the sheave."""
    for name, path in ropes.items():
        out = path[0] - middle
        aside = out @ axis
        off = np.abs(np.linalg.norm(out - np.outer(aside, axis), axis=1) - radius) + np.abs(aside)
        on = np.flatnonzero(off < _ON_SHEAVE * radius)
        if len(on) < 3:
            continue
        at = int(on[len(on) // 2])
        forward = path[0, min(at + 1, len(path[0]) - 1)] - path[0, at - 1]
        return name, at, float(np.sign(np.cross(out[at], forward) @ axis))
    return None
