"""An L-shaped plate as one polygon of an OBJ file: it weighed more than twice what it does.

Polygons were cut into a fan of triangles about their first corner. Of one that is not convex some of these
lie outside, and turn the other way: what a body encloses comes out right, the area of a plate does not.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from gantline.cad.mesh import TriangleMesh
from gantline.cad.plain import read_obj

#: Legs of 4 m, 1 m wide: 7 m², anticlockwise seen from above.
L = [(4, 0), (4, 1), (1, 1), (1, 4), (0, 4), (0, 0)]
TURN = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])


def mesh(corners: Sequence[tuple[float, ...]], faces: list[list[int]], turn: np.ndarray) -> TriangleMesh:
    places = np.array(corners, dtype=float) @ turn.T
    text = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in places.tolist())
    text += "".join("f " + " ".join(str(corner + 1) for corner in face) + "\n" for face in faces)
    return read_obj(text.encode(), 1000)[""]


@pytest.mark.parametrize("turn", [np.eye(3), TURN, -TURN])
@pytest.mark.parametrize("first", range(6))
@pytest.mark.parametrize("way", [1, -1])
def test_an_l_has_its_area(turn: np.ndarray, first: int, way: int) -> None:
    """7 m², centre at (4 · 0.5 + 3 · 2.5)/7 = 19/14 m both ways, all triangles to the side of the polygon."""
    corners = [(*point, 0.0) for point in (L[first:] + L[:first])[::way]]
    found = mesh(corners, [list(range(6))], turn)
    assert found.area == pytest.approx(7.0, rel=1e-12)
    centre = found.areas @ found.corners.mean(axis=1) / found.area
    assert centre == pytest.approx(turn @ [9.5 / 7, 9.5 / 7, 0.0])
    outwards = turn @ [0.0, 0.0, way * np.linalg.det(turn)]
    assert found.normals == pytest.approx(np.tile(outwards, (4, 1)), abs=1e-12)


def test_a_body_with_such_faces_stays_closed() -> None:
    """A prism on it, with a corner along a straight side: faces to either side have the same edges."""
    around = [*L, (2, 0)]
    count = len(around)
    corners = [(*point, float(z)) for z in (0, 0.5) for point in around]
    faces = [list(range(count))[::-1], list(range(count, 2 * count))]
    faces += [[k, (k + 1) % count, count + (k + 1) % count, count + k] for k in range(count)]
    found = mesh(corners, faces, TURN).welded(1e-9)
    assert found.is_closed and found.is_consistent
    assert found.volume == pytest.approx(3.5, rel=1e-12)
    assert found.area == pytest.approx(2 * 7 + 16 * 0.5, rel=1e-12)
