"""Vessels that lie in the ground: nothing holds a hull off it in a simulation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from gantline.results.afloat.vessels import Vessel
from gantline.results.rotation import axes
from gantline.results.surroundings import Ground, is_cut
from gantline.results.variable import Columns, FloatArray, Names

__all__ = ["grounding_warnings"]

#: Samples at which a vessel is looked at, at most: one that pitches or is moved is seen often enough.
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
    count = len(columns["time"])
    looks = np.unique(np.linspace(0, count - 1, min(count, _LOOKS)).astype(int))
    warnings = []
    for vessel in vessels:
        body = list(names["body"]).index(vessel.body)
        from_centre = hulls[vessel.body] - np.asarray(vessel.centre_of_gravity)
        turns = axes(columns["body_orientation"][looks, body])
        places = columns["body_position"][looks, body][:, None] + from_centre @ turns.transpose(0, 2, 1)
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


def _is_beside(ground: Ground, points: FloatArray, level: float) -> bool:
    """Whether the ground that a hull is deepest in comes out of the water: a quay, and no floor."""
    under = ground.under(points)
    return bool(under[np.argmax(under - points[:, 2])] > level)
