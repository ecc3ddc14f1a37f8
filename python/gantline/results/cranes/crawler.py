"""Crawler cranes in a recording: pressure under tracks and mats, nearness to tipping.

Sizes and weights come with the rig; docs/concepts/crawler.md has the equations.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from gantline.results.cranes.track_pressure import line_pressures, raised_forces, tipping_utilisation
from gantline.results.file.form import Vector
from gantline.results.passing import passed
from gantline.results.rotation import axes, heading, tilt
from gantline.results.strength import FromJson
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable

__all__ = ["Crawler", "crawler_events", "crawler_state", "raised_state", "tipping_warnings"]

#: Lean of the tracks from which on a crane has gone over, wherever it comes to rest then [rad].
_GONE_OVER = np.radians(10.0)


@dataclass(frozen=True)
class Crawler(FromJson):
    """A crawler crane.

    Attributes:
        name: Its name.
        tracks: Body that stands on the ground.
        length: Of a track on the ground [m].
        width: Of a track [m].
        gauge: Distance of the tracks, middle to middle [m].
        mats: Width of the mats under each track [m]; None without.
        outrigger_mats: Area of the mat under each end of a crane on outriggers [m^2]; None on tracks.
        allowed_pressure: What the ground bears [Pa]; None if not said.
        centre: Centre of gravity of the tracks' body in its frame, whose origin is on the ground [m].
        corners: Contacts under the ends of the tracks, in the order of
            `gantline.results.cranes.track_pressure.CORNERS`.
        stiffness: Of mats and ground under each end of a track [N/m].
        levels: How much higher than the rest the ground under each of the corners is at the start [m].
        feet: Joints by which the ground under each of the corners goes down, None where it stays.
        weights: Weight of each body of the crane [N].
        hooks: Its hooks.
    """

    name: str
    tracks: str = ""
    length: float = 0.0
    width: float = 0.0
    gauge: float = 0.0
    mats: float | None = None
    outrigger_mats: float | None = None
    allowed_pressure: float | None = None
    centre: Vector = (0.0, 0.0, 0.0)
    corners: Sequence[str] = ()
    stiffness: float = 0.0
    levels: Sequence[float] = (0.0, 0.0, 0.0, 0.0)
    feet: Sequence[str | None] = (None, None, None, None)
    weights: Mapping[str, float] = field(default_factory=dict)
    hooks: Sequence[str] = ()


def crawler_state(columns: Columns, names: Names, crawlers: Sequence[Crawler]) -> Derived:
    """Pressures under the ends of tracks, utilisation against tipping.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        crawlers: Crawler cranes of the rig.
    """
    if not crawlers:
        return {}, {}
    forces = [_corner_forces(columns, names, crane) for crane in crawlers]
    pressures = [
        _pressures(crane, force, _uneven(columns, names, crane))
        for crane, force in zip(crawlers, forces, strict=True)
    ]
    on_track, on_ground = ([pair[which] for pair in pressures] for which in (0, 1))
    tipping = [_tipping(columns, names, crane, one) for crane, one in zip(crawlers, forces, strict=True)]
    at_corners, of_crawlers = ("time", "track_corner"), ("time", "crawler")
    return {
        "track_pressure": Variable(
            at_corners, np.concatenate(on_track, axis=1), "Pa", "pressure under the end of a track"
        ),
        "ground_pressure": Variable(
            at_corners,
            np.concatenate(on_ground, axis=1),
            "Pa",
            "pressure on the ground there, under the mats where there are any",
        ),
        "tipping_utilisation": Variable(
            of_crawlers,
            np.stack(tipping, axis=1),
            "1",
            "moment of what hangs over that of the crane's weight about its worst tipping line; it tips at 1",
        ),
    }, {
        "track_corner": [corner for crane in crawlers for corner in crane.corners],
        "crawler": [crane.name for crane in crawlers],
    }


def raised_state(
    columns: Columns, names: Names, crane: Crawler, by: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Pressures on the ground and utilisation against tipping if more hung in the hooks of a crane.

    All that is not the crane's own weight comes from its hooks, and grows with what they bear: along falls
    out of plumb and as it swings too. What leans it, its ground and its falls, stays as it is.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        crane: The crane.
        by: Hoist load of all its hooks over what it is, shape (time,) [1].

    Returns:
        Pressures under the ends of its tracks, shape (time, 4) [Pa]; utilisation, shape (time,) [1].
    """
    total, centre = _own_weight(columns, names, crane)
    own = np.full(len(by), total)
    forces = _corner_forces(columns, names, crane)
    forces = raised_forces(forces, own, centre, (crane.length, crane.gauge), by)
    _, on_ground = _pressures(crane, forces, _uneven(columns, names, crane))
    return on_ground, _tipping(columns, names, crane, forces)


def _pressures(crane: Crawler, force: FloatArray, uneven: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Pressure under the ends of tracks, or the feet of outriggers, and on the ground there [Pa]."""
    if crane.outrigger_mats is not None:
        return force / crane.width**2, force / crane.outrigger_mats
    line = line_pressures(force, crane.length, uneven)
    return line / crane.width, line / (crane.mats or crane.width)


def _corner_forces(columns: Columns, names: Names, crane: Crawler) -> FloatArray:
    """Forces under the ends of the tracks, shape (time, 4) [N]."""
    contacts = list(names["contact"])
    forces: FloatArray = columns["contact_force"][:, [contacts.index(one) for one in crane.corners]]
    return forces


def _uneven(columns: Columns, names: Names, crane: Crawler) -> FloatArray:
    """What the ground adds to the slope of the force per length of each track, shape (time, 2) [N/m^2].

    The ground under a track resists its rocking as its two ends do, so that as long as all four carry, the
    moment of each track is that of the forces under its own ends: 6 k/L, times the slope of the ground.
    """
    joints = list(names["joint"])
    level = np.tile(np.asarray(crane.levels, dtype=np.float64), (len(columns["time"]), 1))
    for corner, foot in enumerate(crane.feet):
        if foot is not None:
            level[:, corner] -= columns["joint_position"][:, joints.index(foot)]
    rises: FloatArray = 6 * crane.stiffness * (level[:, 0::2] - level[:, 1::2]) / crane.length**2
    return rises


def _tipping(columns: Columns, names: Names, crane: Crawler, forces: FloatArray) -> FloatArray:
    """Utilisation against tipping over the worst of four lines, shape (time,) [1]."""
    orientation = columns["body_orientation"][:, list(names["body"]).index(crane.tracks)]
    total, centre = _own_weight(columns, names, crane)
    own = np.full(len(columns["time"]), total)
    used = tipping_utilisation(forces, own, centre, crane.length, crane.gauge)
    return np.where(tilt(orientation) > _GONE_OVER, np.maximum(used, 1.0), used)


def _own_weight(columns: Columns, names: Names, crane: Crawler) -> tuple[float, FloatArray]:
    """Weight of a crane [N], and where it acts forward and to the left of the middle of its tracks [m]."""
    bodies = list(names["body"])
    place = {name: columns["body_position"][:, bodies.index(name)] for name in crane.weights}
    total = sum(crane.weights.values())
    middle = np.sum([weight * place[name] for name, weight in crane.weights.items()], axis=0) / total
    orientation = columns["body_orientation"][:, bodies.index(crane.tracks)]
    # Lines are level and as far from each other as when the tracks stand: a crane that leans more than a few
    # degrees is past them anyway.
    ahead = heading(orientation)
    forward = np.stack([np.cos(ahead), np.sin(ahead)], axis=1)
    left = np.stack([-forward[:, 1], forward[:, 0]], axis=1)
    origin = place[crane.tracks] - axes(orientation) @ np.asarray(crane.centre)
    away = (middle - origin)[:, :2]
    return total, np.stack([(away * forward).sum(axis=1), (away * left).sum(axis=1)], axis=1)


def crawler_events(
    time: FloatArray, crawlers: Sequence[Crawler], tipping: Mapping[str, FloatArray]
) -> Iterator[tuple[float, str, str]]:
    """Moments at which a crane tips: time [s], kind, crane.

    Args:
        time: Shape (time,) [s].
        crawlers: Crawler cranes of the rig.
        tipping: Utilisation against tipping by crane, shape (time,) [1].
    """
    for crane in crawlers:
        # At 1 both corners of one side are clear of the ground; rounding is far below this.
        for at in passed(time, tipping[crane.name] - (1.0 - 1e-9)):
            yield at, "tipping", crane.name


def tipping_warnings(columns: Columns, names: Names, crawlers: Sequence[Crawler]) -> list[str]:
    """A sentence for each crawler crane that tips, as `crawler_state` sees it."""
    if not crawlers:
        return []
    tipping = crawler_state(columns, names, crawlers)[0]["tipping_utilisation"].values
    by_crane = {crane.name: used for crane, used in zip(crawlers, tipping.T, strict=True)}
    first: dict[str, float] = {}
    for time, _, name in crawler_events(columns["time"], crawlers, by_crane):
        first.setdefault(name, time)
    return [
        f"crane '{name}' tips at {time:.2f} s: both corners of one side are clear of the ground"
        for name, time in first.items()
    ]
