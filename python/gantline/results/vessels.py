"""How vessels lie in the water: drafts, heel, trim and freeboard from the recorded motion of their bodies.

With R the orientation of a vessel, o its origin and w the level of the water, n = Rᵀ ẑ is the upward
direction in its axes, and h(x) = n . x + o_z - w the height of one of its points above the water. Trim and
heel are those of `gantline.hydro.Attitude`, asin n_x and atan2(n_y, n_z); the draft at a station is the z of
the water in the centre plane there. Close to 90 deg of heel or trim no draft means anything, and it becomes
very large.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from gantline.results.rotation import axes
from gantline.results.strength import FromJson
from gantline.results.variable import FloatArray, Variable

__all__ = ["Vessel", "vessel_state", "vessel_warnings"]

Columns = Mapping[str, FloatArray]
Names = Mapping[str, Sequence[str]]

#: Least cosine by which drafts are divided.
_UPRIGHT = 1e-6


@dataclass(frozen=True)
class Vessel(FromJson):
    """A vessel.

    Attributes:
        name: Its name.
        body: Name of its body.
        centre_of_gravity: Of that body, from its origin [m], to which recorded positions belong.
        ends: Stern and bow of its hull along x [m].
        level: Height of the water [m].
        density: Of the water [kg/m^3].
        hull: Name of its hull among those of the recording.
        marks: Points that should stay above the water, vessel axes [m], by what they belong to.
    """

    name: str
    body: str
    centre_of_gravity: Sequence[float] = (0.0, 0.0, 0.0)
    ends: Sequence[float] = (0.0, 0.0)
    level: float = 0.0
    density: float = 1025.0
    hull: str = ""
    marks: Mapping[str, Sequence[Sequence[float]]] = field(default_factory=dict)


_Derived = tuple[dict[str, Variable], dict[str, Sequence[str]]]


def vessel_state(columns: Columns, names: Names, vessels: Sequence[Vessel]) -> _Derived:
    """Drafts, heel, trim, freeboard and displacement of vessels over time.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        vessels: Those of the rig.
    """
    if not vessels:
        return {}, {}
    parts = [_afloat(columns, names, vessel) for vessel in vessels]
    described = (
        ("vessel_draft", "m", "draft of a vessel at half its length, along its own z"),
        ("vessel_draft_aft", "m", "draft of a vessel at the stern of its hull"),
        ("vessel_draft_forward", "m", "draft of a vessel at the bow of its hull"),
        ("vessel_heel", "rad", "heel of a vessel, to starboard positive"),
        ("vessel_trim", "rad", "trim of a vessel, by the stern positive"),
        ("vessel_freeboard", "m", "height above the water of the lowest of deck edge and openings"),
        ("vessel_displacement", "kg", "mass of the water that a vessel displaces"),
    )
    return {
        name: Variable(("time", "vessel"), np.stack([one[name] for one in parts], axis=1), unit, description)
        for name, unit, description in described
    }, {"vessel": [vessel.name for vessel in vessels]}


def _afloat(columns: Columns, names: Names, vessel: Vessel) -> dict[str, FloatArray]:
    body = list(names["body"]).index(vessel.body)
    turn = axes(columns["body_orientation"][:, body])
    origin = columns["body_position"][:, body] - turn @ np.asarray(vessel.centre_of_gravity)
    up, height = turn[:, 2, :], origin[:, 2] - vessel.level
    steep = np.where(np.abs(up[:, 2]) < _UPRIGHT, np.copysign(_UPRIGHT, up[:, 2]), up[:, 2])

    def draft(station: float) -> FloatArray:
        found: FloatArray = -(height + up[:, 0] * station) / steep
        return found

    aft, forward = vessel.ends
    points = np.array([point for mark in vessel.marks.values() for point in mark])
    volume = columns["displaced_volume"][:, list(names["hull"]).index(vessel.hull)]
    return {
        "vessel_draft": draft((aft + forward) / 2),
        "vessel_draft_aft": draft(aft),
        "vessel_draft_forward": draft(forward),
        "vessel_heel": np.arctan2(up[:, 1], up[:, 2]),
        "vessel_trim": np.arcsin(np.clip(up[:, 0], -1.0, 1.0)),
        "vessel_freeboard": (up @ points.T).min(axis=1) + height,
        "vessel_displacement": vessel.density * volume,
    }


def vessel_warnings(columns: Columns, names: Names) -> list[str]:
    """A sentence for each deck edge and opening that went under water, the first time."""
    events = zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True)
    first: dict[str, float] = {}
    for time, kind, name in events:
        if kind == "flooding":
            first.setdefault(name, float(time))
    return [
        f"{name} goes under water at {time:.2f} s; no water comes in here, as it would"
        for name, time in first.items()
    ]
