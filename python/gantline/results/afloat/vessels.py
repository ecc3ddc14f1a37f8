"""How vessels lie in the water: drafts, heel, trim and freeboard from the recorded motion of their bodies.

With o the origin of a vessel and w the level of the water, n . x + o_z - w is the height of one of its points
above the water, n upwards in its axes. Drafts are those in still water, freeboard is that in waves.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any, NamedTuple, Self

import numpy as np

from gantline.results.afloat.attitude import Lie
from gantline.results.afloat.sea import Sea
from gantline.results.file.form import Range, Vector
from gantline.results.rotation import axes
from gantline.results.strength import FromJson
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable

__all__ = [
    "AS_CARRIED",
    "AtRest",
    "ByContingency",
    "Heights",
    "Vessel",
    "vessel_state",
    "vessel_warnings",
    "with_rest",
]


#: What has to be known of heel and trim of a vessel that is carried.
AS_CARRIED = "its motion is given, and what hangs from it neither heels nor trims it"


#: Metacentric heights for heel and trim of vessels by their names [m].
Heights = dict[str, tuple[float, float]]


@dataclass(frozen=True)
class ByContingency(FromJson):
    """What the design weight of loads would change of how a vessel lies, beside what is simulated.

    Attributes:
        time: When [s].
        heel: Change of heel, to starboard positive [rad].
        trim: Change of trim, by the stern positive [rad].
        freeboard: Change of freeboard [m].
        metacentric_height: Change of the metacentric height for heel [m]; None where that is not asked for,
            or the design weight leaves no equilibrium.
        least_height: The least metacentric height, for heel or trim, with the design weight [m], where it is
            below zero; None where nothing turns over, or it is not known.
        rests: Whether an equilibrium with the design weight is found.
    """

    time: float
    heel: float
    trim: float
    freeboard: float
    metacentric_height: float | None = None
    least_height: float | None = None
    rests: bool = True


class AtRest(NamedTuple):
    """What equilibria say of the vessels of a lift at a moment.

    Attributes:
        heights: Metacentric heights; of vessels that are left out nothing is told.
        by_contingency: What the design weight would change, by their names.
    """

    heights: Heights
    by_contingency: Mapping[str, ByContingency]


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
        righting: Moments [s] with its metacentric heights for heel and trim then [m], of a start at rest, of
            the ends of steps and of the end: where a lift sets a limit for them, or one is below zero.
        by_contingency: What the design weight of loads would change at these moments, where a load has more
            than is simulated.
        is_carried: Whether its motion is given, so that nothing that hangs from it, or rights it, counts.
        grows_over: How long the motion of a record grows by which it goes [s]; 0 if it goes by none.
    """

    name: str
    body: str
    centre_of_gravity: Vector = (0.0, 0.0, 0.0)
    ends: Range = (0.0, 0.0)
    level: float = 0.0
    density: float = 1025.0
    hull: str = ""
    marks: Mapping[str, Sequence[Vector]] = field(default_factory=dict)
    righting: Sequence[Vector] = ()
    by_contingency: Sequence[ByContingency] = ()
    is_carried: bool = False
    grows_over: float = 0.0

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        changes = tuple(ByContingency.from_json(one) for one in document.get("by_contingency", ()))
        return super().from_json({**document, "by_contingency": changes})


def with_rest(rig: Mapping[str, Any], time: float, found: AtRest) -> dict[str, Any]:
    """The JSON of a rig whose vessels tell what equilibria say of them at a moment.

    Args:
        rig: Its JSON.
        time: That moment [s].
        found: What they say.
    """

    def told(one: Mapping[str, Any]) -> dict[str, Any]:
        name, more = one["name"], {}
        if name in found.heights:
            more["righting"] = [*one.get("righting", ()), [time, *found.heights[name]]]
        if name in found.by_contingency:
            change = replace(found.by_contingency[name], time=time)
            more["by_contingency"] = [*one.get("by_contingency", ()), asdict(change)]
        return {**one, **more}

    return {**rig, "vessels": [told(one) for one in rig["vessels"]]}


def vessel_state(
    columns: Columns, names: Names, vessels: Sequence[Vessel], sea: Sea | None = None
) -> Derived:
    """Drafts, heel, trim, freeboard and displacement of vessels over time.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        vessels: Those of the rig.
        sea: Waves on the water; None where it is still.
    """
    if not vessels:
        return {}, {}
    parts = [_afloat(columns, names, vessel, sea) for vessel in vessels]
    described = [
        ("vessel_draft", "m", "draft of a vessel at half its length, along its own z"),
        ("vessel_draft_aft", "m", "draft of a vessel at the stern of its hull"),
        ("vessel_draft_forward", "m", "draft of a vessel at the bow of its hull"),
        ("vessel_heel", "rad", "heel of a vessel, to starboard positive"),
        ("vessel_trim", "rad", "trim of a vessel, by the stern positive"),
        ("vessel_freeboard", "m", "height above the water of the lowest of deck edge and openings"),
        ("vessel_displacement", "kg", "mass of the water that a vessel displaces"),
    ]
    if sea is not None:
        elevation = "height of the undisturbed waves amidships of a vessel above still water"
        described.append(("vessel_wave_elevation", "m", elevation))
    return {
        name: Variable(("time", "vessel"), np.stack([one[name] for one in parts], axis=1), unit, description)
        for name, unit, description in described
    }, {"vessel": [vessel.name for vessel in vessels]}


def _afloat(columns: Columns, names: Names, vessel: Vessel, sea: Sea | None) -> dict[str, FloatArray]:
    body = list(names["body"]).index(vessel.body)
    turn = axes(columns["body_orientation"][:, body])
    origin = columns["body_position"][:, body] - turn @ np.asarray(vessel.centre_of_gravity)
    lie = Lie(turn, origin[:, 2] - vessel.level)
    aft, forward = vessel.ends
    points = np.array([point for mark in vessel.marks.values() for point in mark])
    volume = columns["displaced_volume"][:, list(names["hull"]).index(vessel.hull)]
    freeboard = (lie.up @ points.T).min(axis=1) + lie.height
    waves = {}
    if sea is not None:
        time = columns["time"]
        heights = lie.up @ points.T + lie.height[:, None] - sea.at_body(time, origin, turn, points)
        freeboard = heights.min(axis=1)
        amidships = origin[:, :2] + turn[:, :2] @ np.array([(aft + forward) / 2, 0.0, 0.0])
        waves = {"vessel_wave_elevation": sea.at(time, amidships)}
    return {
        "vessel_draft": lie.draft((aft + forward) / 2),
        "vessel_draft_aft": lie.draft(aft),
        "vessel_draft_forward": lie.draft(forward),
        "vessel_heel": lie.heel,
        "vessel_trim": lie.trim,
        "vessel_freeboard": freeboard,
        "vessel_displacement": vessel.density * volume,
        **waves,
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
