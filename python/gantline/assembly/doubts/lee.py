"""Vessels that lie so close that each is in the lee of the other, of which their files know nothing."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from gantline.assembly.afloat.hulls import hull_mesh
from gantline.assembly.afloat.side_by_side import shared_files
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.units import format_quantity

__all__ = ["distance_in_plan", "doubtful_lee"]


def doubtful_lee(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """Each pair of vessels in waves that lie nearer than the breadth of the wider where the lift begins.

    None of a pair whose wave forces are by one computation of both.
    """
    if not scenario.waves:
        return
    outlines = {}
    known = shared_files(scenario)
    for name, vessel in (scenario.vessels or {}).items():
        hull = hull_mesh(scenario, name, vessel) if vessel.wave_forces is not None else None
        if hull is not None:
            position, turn = parts.pose(name)
            breadth = float(np.ptp(hull.vertices[:, 1]))
            outlines[name] = _outline((position + hull.vertices @ turn.T)[:, :2]), breadth
    for (one, (first, wide)), (other, (second, wider)) in combinations(outlines.items(), 2):
        if any({one, other} <= names for names in known):
            continue
        breadth, distance = max(wide, wider), distance_in_plan(first, second)
        if distance < breadth:
            lie = f"{one} and {other} lie {format_quantity(distance, 'm', 1)} apart"
            near = f"nearer than a breadth, {format_quantity(breadth, 'm', 1)}"
            left_out = "the lee of the other and the water between them are left out"
            yield Doubt(("vessels", other), f"{lie}, {near}, and feel waves as if alone: {left_out}")


def _outline(points: Array) -> Array:
    """Corners of the convex outline of points in plan (n, 2), anticlockwise."""
    from scipy.spatial import ConvexHull  # only where vessels lie side by side

    corners: Array = points[ConvexHull(points).vertices]
    return corners


def distance_in_plan(first: Array, second: Array) -> float:
    """Distance of two convex outlines [m], 0 where they overlap.

    The widest strip that parts them is as wide; its direction is across a side, or from corner to corner.
    """
    sides = [np.roll(outline, -1, axis=0) - outline for outline in (first, second)]
    across = np.concatenate([np.column_stack([side[:, 1], -side[:, 0]]) for side in sides])
    between = (second[:, np.newaxis] - first).reshape(-1, 2)
    ways = np.concatenate([across, -across, between])
    length = np.linalg.norm(ways, axis=1)
    ways = ways[length > 0.0] / length[length > 0.0, np.newaxis]
    strips = (second @ ways.T).min(axis=0) - (first @ ways.T).max(axis=0)
    return max(0.0, float(strips.max()))
