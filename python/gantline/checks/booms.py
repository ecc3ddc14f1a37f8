"""Booms: their angle within its range, off-lead and side-lead of the falls at their heads."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.checks.measure import Finding, extreme, to_either_side
from gantline.results.recording import Recording
from gantline.results.variable import BoolArray

#: Rounding of an angle at the end of its range [rad].
_ROUNDING = 1e-9


def off_lead(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of the falls of a hook from plumb in the plane of its boom, to either side."""
    yield from to_either_side(recording, "off_lead", _hooks(recording), during)


def side_lead(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """Angle of the falls of a hook from plumb across its boom, to either side."""
    yield from to_either_side(recording, "side_lead", _hooks(recording), during)


def _hooks(recording: Recording) -> list[str]:
    return [hook.name for boom in recording.rig.booms for hook in boom.hooks]


def angle_margin(recording: Recording, during: BoolArray) -> Iterator[Finding]:
    """How far the angle of a boom stays from the nearer end of its range; less than 0 beyond it."""
    for boom in recording.rig.booms:
        if boom.range is None:
            continue
        angle = recording.column("boom_angle", boom.name)
        left = np.minimum(angle - boom.range[0], boom.range[1] - angle)
        left = np.where(np.abs(left) < _ROUNDING, 0.0, left)
        yield from extreme(recording, left, during, boom.name, smallest=True)
