"""Ropes with nodes as the ropes that they are: many pieces of the core become one rope with many segments.

The core has a rope of distributed weight as pieces `<rope>/<k>` between bodies `<rope>/<k>`. A recording has
one rope whose segments are the pieces, whose drawn path runs through the nodes, and no such bodies.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results.alike import earliest_peak, first_peak
from gantline.results.gear import Rope
from gantline.results.rig import Rig
from gantline.results.ropes.parting import PARTING
from gantline.results.variable import Columns, FloatArray, Names, Variable

__all__ = ["joined"]

#: Rounding of the time of an event [s].
_AT_ONCE = 1e-9
_OF_BODIES = ("body_position", "body_orientation", "body_velocity", "body_angular_velocity", "joint_force")


def joined(columns: Columns, names: Names, rig: Rig) -> tuple[Columns, Names, dict[str, Variable]]:
    """Columns and names in which each rope with nodes is one rope.

    Its tension is the largest anywhere along it, and 0 from when it parts or is taken off, as of every rope:
    what is left of it falls and whips, which its segments and ends have. Events of its pieces become those of
    the rope: slack when the first piece goes slack, taut when no piece is slack any more, and neither once
    the rope has parted.

    Args:
        columns: columns of the core by name.
        names: names along their dimensions.
        rig: the lift, whose ropes say how many nodes they have.

    Returns:
        The columns, the names, and `rope_end_tension` if any rope has nodes.
    """
    split = {rope.name: rope for rope in rig.ropes if rope.nodes}
    if not split:
        return columns, names, {}
    owner = {f"{rope.name}/{piece}": rope.name for rope in split.values() for piece in range(rope.nodes + 1)}
    merged, labels = dict(columns), {key: list(value) for key, value in names.items()}
    order = list(dict.fromkeys(owner.get(rope, rope) for rope in names["rope"]))
    pieces = _Pieces(columns, names, split, rig.gravity)
    groups = [pieces.group(rope) for rope in order]
    ends = np.stack([pieces.ends(rope) for rope in order], axis=1)
    within = np.stack([columns["rope_tension"][:, group].max(axis=1) for group in groups], axis=1)
    has_nodes = [rope in split for rope in order]
    whole_until = _whole_until(columns, names, owner)
    until = np.array([whole_until.get(rope, np.inf) for rope in order])
    is_whole = columns["time"][:, None] <= until
    tension = np.where(has_nodes, np.maximum(within, ends.max(axis=2)), within)
    merged["rope_tension"] = np.where(is_whole, tension, 0.0)
    if columns["rope_lengthening"].size:
        lengthened = [columns["rope_lengthening"][:, group].sum(axis=1) for group in groups]
        merged["rope_lengthening"] = np.stack(lengthened, axis=1)
    if columns["rope_peak_tension"].size:  # a moment by itself has none
        merged["rope_peak_tension"], merged["rope_peak_time"] = _peaks(
            columns, groups, merged["rope_tension"], until
        )
    labels["rope"] = order
    labels["segment"] = [_segment(segment, owner) for segment in names["segment"]]
    kept = _kept_points(names["rope_point"], owner)
    merged["rope_point"] = columns["rope_point"][:, kept]
    labels["rope_point"] = [owner.get(names["rope_point"][at], names["rope_point"][at]) for at in kept]
    bodies = [at for at, body in enumerate(names["body"]) if body not in owner]
    for column in _OF_BODIES:
        merged[column] = columns[column][:, bodies]
    labels["body"] = [names["body"][at] for at in bodies]
    _join_events(merged, labels, owner)
    variable = Variable(
        ("time", "rope", "rope_end"), ends, "N", "tension at the first and the last end of a rope"
    )
    return merged, labels, {"rope_end_tension": variable}


@dataclass(frozen=True)
class _Pieces:
    """Where the pieces of each rope are among the columns."""

    columns: Columns
    names: Names
    split: Mapping[str, Rope]
    gravity: float

    def group(self, rope: str) -> list[int]:
        """Places of a rope's pieces among the ropes of the core, in order."""
        known = list(self.names["rope"])
        count = self.split[rope].nodes + 1 if rope in self.split else 0
        return [known.index(f"{rope}/{piece}") for piece in range(count)] or [known.index(rope)]

    def ends(self, rope: str) -> FloatArray:
        """Tension at the first and the last end of a rope [N], shape (time, 2).

        With nodes the force there is that of the outermost piece and the weight of what the end carries. That
        is exact at rest, and leaves out only what little mass that is times the acceleration of the end.
        """
        if rope not in self.split:
            at = [place for place, name in enumerate(self.names["segment"]) if _rope_of(name) == rope]
            outer: FloatArray = self.columns["segment_tension"][:, [at[0], at[-1]]]
            return outer
        group = self.group(rope)
        weight = np.array([0.0, 0.0, (self.split[rope].end_mass or 0.0) * self.gravity])
        # Along the rope the force grows by what hangs on it: before its first end it is less.
        forces = [self._force(group[0]) - weight, self._force(group[-1]) + weight]
        taut = self.columns["rope_tension"][:, [group[0], group[-1]]] > 0.0
        return np.where(taut, np.linalg.norm(np.stack(forces, axis=1), axis=2), 0.0)

    def _force(self, piece: int) -> FloatArray:
        """Force in a piece [N], directed along the rope, world axes, shape (time, 3)."""
        at = list(self.names["rope_point"]).index(self.names["rope"][piece])
        along = self.columns["rope_point"][:, at + 1] - self.columns["rope_point"][:, at]
        # A piece without length carries nothing and has no direction.
        size = np.maximum(np.linalg.norm(along, axis=1), np.finfo(np.float64).tiny)
        force: FloatArray = along * (self.columns["rope_tension"][:, piece] / size)[:, None]
        return force


def _peaks(
    columns: Columns, groups: Sequence[Sequence[int]], tension: FloatArray, until: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Largest tension of every rope and its time: over all steps in its pieces, over samples at its ends.

    Of a rope with nodes that parts, up to then [s]: what is left of it falls, and whips.
    """
    peaks, times = [], []
    of_steps, when = columns["rope_peak_tension"], columns["rope_peak_time"]
    for rope, group in enumerate(groups):
        found = [(float(of_steps[piece]), float(when[piece])) for piece in group]
        if len(group) > 1:
            found = [one for one in found if one[1] <= until[rope]]
            at = first_peak(tension[:, rope]) if len(tension) else None
            found += [] if at is None else [(float(tension[at, rope]), float(columns["time"][at]))]
        peak, time = earliest_peak(*found) if found else (0.0, 0.0)
        peaks.append(peak)
        times.append(time)
    return np.array(peaks), np.array(times)


def _whole_until(columns: Columns, names: Names, owner: Mapping[str, str]) -> dict[str, float]:
    """When each rope with nodes that parts does so [s]."""
    until: dict[str, float] = {}
    events = zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True)
    for time, kind, subject in events:
        if kind in PARTING and subject in owner:
            until.setdefault(owner[subject], float(time) + _AT_ONCE)
    return until


def _rope_of(segment: str) -> str:
    return segment.rpartition("/")[0]


def _segment(segment: str, owner: Mapping[str, str]) -> str:
    """The one segment of a piece is called like the piece."""
    rope = _rope_of(segment)
    return rope if rope in owner else segment


def _kept_points(points: Sequence[str], owner: Mapping[str, str]) -> list[int]:
    """Drawn points without those at which a piece only repeats where the piece before it ended."""
    return [
        at
        for at, name in enumerate(points)
        if name not in owner or at == 0 or points[at - 1] == name or owner.get(points[at - 1]) != owner[name]
    ]


def _join_events(
    columns: dict[str, FloatArray], names: dict[str, list[str]], owner: Mapping[str, str]
) -> None:
    """Events of pieces into events of their ropes, in place."""
    kinds, subjects = names["event_kind"], names["event_name"]
    slack: dict[str, set[str]] = {rope: set() for rope in owner.values()}
    seen: set[str] = set()
    for kind, subject in zip(
        kinds, subjects, strict=True
    ):  # who begins with going taut was slack at the start
        if subject in owner and subject not in seen and kind == "taut":
            slack[owner[subject]].add(subject)
        seen.add(subject)
    kept = []
    parted: set[str] = set()  # what is left of them whips, and carries nothing
    for at, (kind, subject) in enumerate(zip(kinds, subjects, strict=True)):
        if subject not in owner or kind not in ("taut", "slack"):
            kept.append(at)
            if subject in owner and kind in PARTING:
                parted.add(owner[subject])
            continue
        rope = owner[subject]
        if rope in parted:
            continue
        before = bool(slack[rope])
        (slack[rope].add if kind == "slack" else slack[rope].discard)(subject)
        if bool(slack[rope]) != before:
            kept.append(at)
    names["event_kind"] = [kinds[at] for at in kept]
    names["event_name"] = [owner.get(subjects[at], subjects[at]) for at in kept]
    columns["event_time"] = columns["event_time"][kept]
