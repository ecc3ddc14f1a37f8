"""Booms in a recording: their angles, outreach of their hooks, off-lead and side-lead of the falls.

docs/concepts/booms.md has the equations.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from gantline.results.bodies import axes_of, places_of
from gantline.results.cranes.crane import CraneHook, bearing_and_falls
from gantline.results.file.form import Range, Vector
from gantline.results.strength import FromJson
from gantline.results.variable import Columns, Derived, FloatArray, Names, Variable

__all__ = ["Boom", "boom_state"]


@dataclass(frozen=True)
class Slew(FromJson):
    """How a boom slews with the upper structure that bears it.

    Attributes:
        joint: By which that slews.
        slews: Whether it can; the joint is fixed if not.
        at_start: Its direction at the start, from ahead to the left [rad].
    """

    joint: str = ""
    slews: bool = False
    at_start: float = 0.0


@dataclass(frozen=True)
class Boom(FromJson):
    """A boom with the hooks at its head.

    Attributes:
        name: Name of its crane.
        boom: Its body, whose axes begin midway between the heel pins, x along the boom.
        base: The body that bears the heel pins.
        ropes: Its luffing ropes; none where its angle is as told.
        parts: Parts of line of each.
        range: Least and largest angle [rad]; None of a boom that does not luff.
        reach_from: From where outreach or radius counts, axes of the base from its origin [m].
        base_from: Origin of the base from its centre of gravity, its axes [m].
        wind_limit: Largest gust [m/s]; None if not said.
        wind: Gust of this lift [m/s]; None if not said.
        hooks: Its hooks.
        slew: How it slews; None of one that does not.
        vessel: The vessel on which its crane stands; empty of one on the ground.
    """

    name: str
    boom: str = ""
    base: str = ""
    ropes: Sequence[str] = ()
    parts: int = 0
    range: Range | None = None
    reach_from: Vector = (0.0, 0.0, 0.0)
    base_from: Vector = (0.0, 0.0, 0.0)
    wind_limit: float | None = None
    wind: float | None = None
    hooks: Sequence[CraneHook] = ()
    slew: Slew | None = None
    vessel: str = ""

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        hooks = tuple(CraneHook.from_json(one) for one in document.get("hooks", ()))
        slew = document.get("slew")
        given = {**document, "hooks": hooks, "slew": None if slew is None else Slew.from_json(slew)}
        return super().from_json(given)


def boom_state(columns: Columns, names: Names, booms: Sequence[Boom]) -> Derived:
    """Angles of booms; outreach, off-lead and side-lead of their hooks.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        booms: Booms of the rig.
    """
    if not booms:
        return {}, {}
    angles = [_angle(columns, names, boom) for boom in booms]
    leans = [_leans(columns, names, boom) for boom in booms]
    of_hooks = [values for boom in booms for values in _hooks(columns, names, boom)]
    reach, off, side = (np.stack(values, axis=1) for values in zip(*of_hooks, strict=True))
    dims = ("time", "boom_hook")
    found = {
        "boom_angle": Variable(
            ("time", "boom"), np.stack(angles, axis=1), "rad", "angle of a boom over the plane of its base"
        ),
        "crane_heel": Variable(
            ("time", "boom"),
            np.stack([heel for heel, _ in leans], axis=1),
            "rad",
            "angle of the heel pins to level, of the base of a boom; starboard side down positive",
        ),
        "crane_trim": Variable(
            ("time", "boom"),
            np.stack([trim for _, trim in leans], axis=1),
            "rad",
            "angle of the base of a boom to level in the plane of the boom; away from the boom down positive",
        ),
        "crane_radius": Variable(
            dims,
            reach,
            "m",
            "outreach or radius: level distance of a hook along its boom from bow or slewing axis",
        ),
        "off_lead": Variable(
            dims, off, "rad", "angle of the falls from plumb in the plane of the boom, outwards positive"
        ),
        "side_lead": Variable(
            dims, side, "rad", "angle of the falls from plumb across the boom, to its port side positive"
        ),
    }
    if any(boom.ropes for boom in booms):
        pulls = [_pull(columns, names, boom) for boom in booms]
        found["luffing_pull"] = Variable(
            ("time", "boom"), np.stack(pulls, axis=1), "N", "pull of all parts of line of the luffing tackles"
        )
    if any(boom.slew is not None for boom in booms):
        angles = [_slew(columns, names, boom) for boom in booms]
        found["slew_angle"] = Variable(
            ("time", "boom"), np.stack(angles, axis=1), "rad", "angle of the boom from ahead, to the left"
        )
    return found, {
        "boom": [boom.name for boom in booms],
        "boom_hook": [hook.name for boom in booms for hook in boom.hooks],
    }


def _slew(columns: Columns, names: Names, boom: Boom) -> FloatArray:
    """Angle by which its upper structure is slewed, shape (time,) [rad]; 0 of one that has none."""
    if boom.slew is None or not boom.slew.slews:
        return np.full(len(columns["time"]), 0.0 if boom.slew is None else boom.slew.at_start)
    angle: FloatArray = columns["joint_position"][:, list(names["joint"]).index(boom.slew.joint)]
    return angle


def _pull(columns: Columns, names: Names, boom: Boom) -> FloatArray:
    """Pull of all parts of line of its tackles, shape (time,) [N]."""
    at = [list(names["rope"]).index(rope) for rope in boom.ropes]
    pull: FloatArray = boom.parts * columns["rope_tension"][:, at].sum(axis=1)
    return pull


def _angle(columns: Columns, names: Names, boom: Boom) -> FloatArray:
    """Angle of the boom in the axes of its base, shape (time,) [rad]."""
    along = axes_of(columns, names, boom.boom)[:, :, 0]
    base = axes_of(columns, names, boom.base)
    ahead, up = (np.einsum("ti,ti->t", along, base[:, :, axis]) for axis in (0, 2))
    angle: FloatArray = np.arctan2(up, ahead)
    return angle


def _leans(columns: Columns, names: Names, boom: Boom) -> tuple[FloatArray, FloatArray]:
    """Heel and trim of what bears the boom, shapes (time,) [rad]."""
    base = axes_of(columns, names, boom.base)
    return np.arcsin(np.clip(base[:, 2, 1], -1, 1)), np.arcsin(np.clip(base[:, 2, 0], -1, 1))


def _hooks(columns: Columns, names: Names, boom: Boom) -> Iterator[tuple[FloatArray, FloatArray, FloatArray]]:
    """Of each hook outreach [m], off-lead and side-lead [rad], shapes (time,)."""
    port = axes_of(columns, names, boom.boom)[:, :2, 1]
    port = port / np.linalg.norm(port, axis=1, keepdims=True)
    ahead = np.stack((port[:, 1], -port[:, 0]), axis=1)  # level, in the plane of the boom
    offset = np.asarray(boom.reach_from) + np.asarray(boom.base_from)
    start = places_of(columns, names, boom.base, offset)
    for hook in boom.hooks:
        bearing, falls = bearing_and_falls(columns, names, hook)
        reach = np.einsum("ti,ti->t", bearing[:, :2] - start[:, :2], ahead)
        leads = [-np.einsum("ti,ti->t", falls[:, :2], axis) for axis in (ahead, port)]
        off, side = (np.arctan2(lead, falls[:, 2]) for lead in leads)
        yield reach, off, side
