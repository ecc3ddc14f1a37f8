"""Vessels that lie in the ground: nothing holds a hull off it in a simulation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from gantline.results.afloat.vessels import Vessel
from gantline.results.rotation import axes
from gantline.results.surroundings import SIGNS, Ground, is_cut
from gantline.results.variable import Columns, FloatArray, Indices, Names

__all__ = ["grounding_warnings"]

#: Samples at which a vessel is looked at, at most: so many evenly apart, and so many at which it is deepest.
_LOOKS = 60
#: Rounding of places [m]: a hull that just touches is not in the ground.
_ROUNDING = 1e-6


def grounding_warnings(
    columns: Columns,
    names: Names,
    vessels: Sequence[Vessel],
    hulls: Mapping[str, FloatArray],
    ground: Ground | None,
    depth: float | None = None,
) -> list[str]:
    """A sentence for each vessel of which part is in the ground, at the worst moment looked at.

    Only ground that says where there is water counts: with a dock in it, or below the water. The bed does at
    the depth of the water.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        vessels: Those of the rig.
        hulls: Vertices of hulls by the body of their vessel, vessel axes, shape (vertices, 3) [m].
        ground: That of the lift; None if it has none.
        depth: Of the water [m]; None if not known.
    """
    if ground is not None and vessels and not is_cut(ground, min(one.level for one in vessels)):
        ground = None
    if (ground is None and depth is None) or not vessels:
        return []
    warnings = []
    for vessel in vessels:
        body = list(names["body"]).index(vessel.body)
        from_centre = hulls[vessel.body] - np.asarray(vessel.centre_of_gravity)
        place, turn = columns["body_position"][:, body], columns["body_orientation"][:, body]
        looks = _looks(place, turn, from_centre)
        places = place[looks, None] + from_centre @ axes(turn[looks]).transpose(0, 2, 1)
        in_ground, in_bed = np.full((2, len(looks)), -np.inf)
        if ground is not None:
            in_ground = np.array([(ground.under(points) - points[:, 2]).max() for points in places])
        if depth is not None:
            in_bed = vessel.level - depth - places[..., 2].min(axis=1)
        deepest = np.maximum(in_ground, in_bed)
        worst = int(np.argmax(deepest))
        if deepest[worst] > _ROUNDING:
            when = f"{deepest[worst]:.2f} m in the ground at {columns['time'][looks[worst]]:.2f} s"
            without = "which does not hold its hull here, as it would"
            see = "position, draft and the floor of its dock"
            if ground is not None and _is_beside(ground, places[worst], vessel.level):
                see = "position, mooring lines, fenders and the edges of its dock"
            if in_bed[worst] > in_ground[worst]:
                see = "its draft and the 'depth' of the 'water'"
            warnings.append(f"{vessel.name} is {when}, {without}; see {see}")
    return warnings


def _looks(place: FloatArray, turn: FloatArray, from_centre: FloatArray) -> Indices:
    """Samples evenly apart, and those at which the lowest corner of the box about a hull is lowest."""
    count = len(place)
    low, high = from_centre.min(axis=0), from_centre.max(axis=0)
    corners = (low + high) / 2 + SIGNS * (high - low) / 2
    lowest = (place[:, 2:] + axes(turn)[:, 2] @ corners.T).min(axis=1)
    evenly = np.linspace(0, count - 1, min(count, _LOOKS)).astype(int)
    return np.unique(np.concatenate([evenly, np.argsort(lowest, kind="stable")[:_LOOKS]]))


def _is_beside(ground: Ground, points: FloatArray, level: float) -> bool:
    """Whether the ground that a hull is deepest in comes out of the water: a quay, and no floor."""
    under = ground.under(points)
    return bool(under[np.argmax(under - points[:, 2])] > level)
