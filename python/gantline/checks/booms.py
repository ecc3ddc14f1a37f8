"""Booms: their angle within its range, off-lead and side-lead of the falls at their heads."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import numpy as np

from gantline.checks.measure import Finding, extreme, to_either_side
from gantline.checks.vessels import by_contingency
from gantline.results.afloat.attitude import Lie
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.variable import BoolArray, FloatArray

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


def lean_at_design(recording: Recording, crane: str, way: Literal["heel", "trim"]) -> FloatArray:
    """`crane_heel` or `crane_trim` where the vessel of a crane lies as it would with the design weight.

    As simulated of a crane ashore, and where no load has more than is simulated. What bears the boom goes
    along with its vessel.

    Args:
        recording: The recording.
        crane: Its name.
        way: Which of them.

    Returns:
        Shape (time,) [rad].
    """
    boom = next((one for one in recording.rig.booms if one.name == crane and one.vessel), None)
    vessel = next((one for one in recording.rig.vessels if boom and one.name == boom.vessel), None)
    if boom is None or vessel is None or not vessel.by_contingency:
        return recording.column(f"crane_{way}", crane)
    aboard, base = (axes(recording.column("body_orientation", body)) for body in (vessel.body, boom.base))
    heel, trim = (by_contingency(recording, vessel, of) for of in ("heel", "trim"))
    up = Lie(aboard, np.zeros(len(recording.time))).at_lean(heel, trim)
    along = base[:, :, {"heel": 1, "trim": 0}[way]]
    lean: FloatArray = np.arcsin(
        np.clip(np.einsum("ti,tij,tj->t", up, aboard.transpose(0, 2, 1), along), -1, 1)
    )
    return lean
