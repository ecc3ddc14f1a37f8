"""Triangle meshes of simple bodies, for tests of what mass properties they have."""

from __future__ import annotations

import numpy as np

from gantline.cad.mesh import TriangleMesh

#: The six faces of a box, corners 0…7 with x fastest, anticlockwise seen from outside.
_FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def box(sizes: tuple[float, float, float], middle: tuple[float, float, float] = (0, 0, 0)) -> TriangleMesh:
    """A closed box."""
    corners = [(x, y, z) for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
    triangles = [t for a, b, c, d in _FACES for t in ((a, b, c), (a, c, d))]
    return TriangleMesh(np.array(corners) * sizes + middle, np.array(triangles))


def sphere(radius: float, divisions: int) -> TriangleMesh:
    """An octahedron whose faces are cut into divisions² triangles each, all vertices on the sphere."""
    vertices: dict[tuple[int, int, int], int] = {}
    triangles = []

    def vertex(x: int, y: int, z: int) -> int:
        return vertices.setdefault((x, y, z), len(vertices))

    n = divisions
    for sx, sy, sz in ((x, y, z) for x in (1, -1) for y in (1, -1) for z in (1, -1)):
        for i in range(n):
            for j in range(n - i):
                k = n - i - j
                a = vertex(sx * i, sy * j, sz * k)
                b = vertex(sx * (i + 1), sy * j, sz * (k - 1))
                c = vertex(sx * i, sy * (j + 1), sz * (k - 1))
                faces = [(a, b, c)]
                if k > 1:
                    faces.append((b, vertex(sx * (i + 1), sy * (j + 1), sz * (k - 2)), c))
                triangles += faces if sx * sy * sz > 0 else [face[::-1] for face in faces]
    points = np.array(list(vertices), dtype=float)
    return TriangleMesh(radius * points / np.linalg.norm(points, axis=1, keepdims=True), np.array(triangles))


def plate_with_hole(outer: np.ndarray, inner: np.ndarray, thickness: float) -> TriangleMesh:
    """A plate about the plane z = 0 between two anticlockwise outlines (k, 2) of as many points."""
    count = len(outer)
    rings = [(outer, thickness / 2), (inner, thickness / 2), (outer, -thickness / 2), (inner, -thickness / 2)]
    vertices = np.concatenate([np.column_stack([ring, np.full(count, z)]) for ring, z in rings])
    triangles = []
    # Quads from ring to ring: top from outer to inner, inner wall, bottom, outer wall.
    for start, end in ((0, 1), (1, 3), (3, 2), (2, 0)):
        for i in range(count):
            j = (i + 1) % count
            a, b, c, d = start * count + i, start * count + j, end * count + j, end * count + i
            triangles += [(a, b, c), (a, c, d)]
    return TriangleMesh(vertices, np.array(triangles))


def surface_with_hole(outer: np.ndarray, inner: np.ndarray) -> TriangleMesh:
    """The middle surface of such a plate."""
    count = len(outer)
    vertices = np.concatenate([np.column_stack([ring, np.zeros(count)]) for ring in (outer, inner)])
    ring = [(i, (i + 1) % count) for i in range(count)]
    triangles = [t for i, j in ring for t in ((i, j, count + j), (i, count + j, count + i))]
    return TriangleMesh(vertices, np.array(triangles))
