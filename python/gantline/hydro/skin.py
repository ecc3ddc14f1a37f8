"""What is doubtful about the skin of a hull that its edges do not show: does it run through itself?"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from gantline.cad.mesh import TriangleMesh

__all__ = ["facing_alike", "inner_share", "lies_on_one_side"]

Array = npt.NDArray[np.float64]

#: Points of the skin that are looked at, their number times that of the triangles, and the fewest.
_MOST_POINTS, _MOST_PAIRS, _FEWEST_POINTS = 2000, 4_000_000, 60
#: Pairs of a point and a triangle that are looked at together, few enough to stay in the processor's cache.
_AT_ONCE = 200_000
#: Depth below the skin of these points, as a share of the hull's size.
_DEPTH = 1e-5
#: Share of a hull's size by which it may go beyond the centre plane and still lie on one side of it.
_IN_PLANE = 1e-6


def facing_alike(mesh: TriangleMesh) -> tuple[TriangleMesh, int]:
    """A mesh whose triangles agree on what is outside, and how many were turned for that.

    Returns:
        the mesh as it is, and 0, where they agree already or no turning helps.
    """
    welded = mesh.welded(_IN_PLANE * mesh.size)
    if welded.is_consistent:
        return mesh, 0
    turned, count = welded.oriented()
    return (turned, count) if turned.is_consistent else (mesh, 0)


def lies_on_one_side(mesh: TriangleMesh) -> bool:
    """Whether all of it is on one side of the centre plane y = 0."""
    return max(float(mesh.box[0, 1]), -float(mesh.box[1, 1])) >= -_IN_PLANE * mesh.size


def inner_share(mesh: TriangleMesh) -> float:
    """Share of its skin that lies within other parts of it, which displace twice there [1].

    Points of the skin, spread evenly over its area and moved a little inwards, see all of it from inside
    once; within two bodies, twice (the winding number, from solid angles).

    Args:
        mesh: triangles that face outwards.
    """
    count = min(_MOST_POINTS, max(_MOST_PAIRS // len(mesh.triangles), _FEWEST_POINTS))
    ends = np.cumsum(mesh.areas)
    places = (np.arange(count) + 0.5) / count * ends[-1]
    which = np.minimum(np.searchsorted(ends, places), len(ends) - 1)
    # Places in their triangles by the fractions of two irrational steps, evenly and always the same.
    steps = np.outer(np.arange(1, count + 1), (0.7548776662466927, 0.5698402909980532)) % 1.0
    folded = np.where(steps.sum(axis=1, keepdims=True) > 1, 1 - steps, steps)
    a, b, c = mesh.corners[which].transpose(1, 0, 2)
    points = a + folded[:, :1] * (b - a) + folded[:, 1:] * (c - a) - _DEPTH * mesh.size * mesh.normals[which]
    chunk = max(_AT_ONCE // len(mesh.triangles), 1)
    turns = [_winding(mesh.corners, points[start : start + chunk]) for start in range(0, count, chunk)]
    return float(np.mean(np.concatenate(turns) > 1.5))


def _winding(corners: Array, points: Array) -> Array:
    """How many times triangles (m, 3, 3) enclose points (n, 3): shape (n,)."""
    # Each coordinate apart: numpy's own products of short vectors take several times as long.
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (
        [corners[None, :, corner, axis] - points[:, None, axis] for axis in range(3)] for corner in range(3)
    )
    la, lb, lc = (np.sqrt(x * x + y * y + z * z) for x, y, z in ((ax, ay, az), (bx, by, bz), (cx, cy, cz)))
    triple = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    ab, bc, ca = ax * bx + ay * by + az * bz, bx * cx + by * cy + bz * cz, cx * ax + cy * ay + cz * az
    angle = 2 * np.arctan2(triple, la * lb * lc + ab * lc + bc * la + ca * lb)
    return np.asarray(angle.sum(axis=1) / (4 * np.pi))
