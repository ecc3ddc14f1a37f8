"""Loads that begin within a structure, put where they lie, or longer than was thought."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise, product

import numpy as np

from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.parts import Json, Parts
from gantline.assembly.shapes import load_parts
from gantline.assembly.spatial import Array, rotation_matrix
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.loads.structures import Dock
from gantline.units import format_quantity

__all__ = ["depth_within", "doubtful_inside"]

#: Less than this [m] is how a load sits on what it stands on, or against it.
_SITS = 0.05


def doubtful_inside(parts: Parts, scenario: Scenario, lifted: LiftedLoad | None) -> Iterator[Doubt]:
    """The load in each structure that it begins in, and how deep.

    What touches pushes apart from the first moment on, as hard as its stiffness makes it.

    Args:
        parts: The system, with all its bodies and shapes.
        scenario: The lift.
        lifted: Its load; None if it has none.
    """
    structures = scenario.structures or {}
    solid = [name for name, given in structures.items() if not isinstance(given, Dock)]
    if lifted is None or scenario.load is None or not solid:
        return
    name = scenario.load.name
    position, turn = parts.pose(name)
    pieces = [position + _corners(part) @ turn.T for part in load_parts(lifted)]
    for structure in solid:
        corners = _corners(parts.shapes[structure]["parts"][0])
        deep = max(depth_within(piece, corners) for piece in pieces)
        if deep > _SITS:
            begins = f"{name} begins {format_quantity(deep, 'm', 2)} deep in {structure}"
            sentence = (
                f"{begins}, which pushes it out: see its 'position', how large it is, and where that stands"
            )
            yield Doubt(("structures", structure), sentence)


def depth_within(first: Array, second: Array) -> float:
    """How far two convex hulls would have to be shifted to be apart [m]; 0 or less where they are.

    By separating axes, as boxes are held against boxes: across faces of either, and across edges of both.

    Args:
        first: Corners of the one (n, 3) [m].
        second: Corners of the other (m, 3) [m].
    """
    upright = _along(np.eye(3), first, second)
    if upright <= 0.0:
        return upright
    from scipy.spatial import ConvexHull  # only where their boxes overlap

    hulls = [ConvexHull(corners) for corners in (first, second)]
    across = np.concatenate([hull.equations[:, :3] for hull in hulls])
    one, other = (_edges(hull.points[hull.simplices]) for hull in hulls)
    crossed = np.cross(one[:, np.newaxis], other).reshape(-1, 3)
    length = np.linalg.norm(crossed, axis=1)
    is_one = length > 1e-6  # edges along each other have no axis
    return _along(np.concatenate([across, crossed[is_one] / length[is_one, np.newaxis]]), first, second)


def _along(axes: Array, first: Array, second: Array) -> float:
    """The least overlap of two sets of points along unit vectors (k, 3) [m]."""
    own, other = first @ axes.T, second @ axes.T
    return float(np.minimum(own.max(0) - other.min(0), other.max(0) - own.min(0)).min())


def _edges(triangles: Array) -> Array:
    """Directions of the edges of triangles (n, 3, 3), each once (k, 3)."""
    sides = np.concatenate([triangles[:, b] - triangles[:, a] for a, b in pairwise((0, 1, 2, 0))])
    sides /= np.linalg.norm(sides, axis=1)[:, np.newaxis]
    turned: Array = np.unique(np.round(sides, 6), axis=0)
    return turned


def _corners(part: Json) -> Array:
    """Corners of a box or of a convex part, in the frame of its body (n, 3) [m]."""
    if part["type"] == "convex":
        return np.array(part["vertices"])
    corners = np.array(list(product((-0.5, 0.5), repeat=3))) * part["size"]
    turn = rotation_matrix(part["orientation"]) if "orientation" in part else np.eye(3)
    placed: Array = np.array(part["centre"]) + corners @ turn.T
    return placed
