"""Hulls of bodies: boxes, and meshes from CAD files, in the body's axes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.assembly.parts import Json
from gantline.assembly.spatial import Array
from gantline.assembly.stamp import stamp
from gantline.cad.mesh import TriangleMesh
from gantline.cad.simplify import contact_hull, light_mesh
from gantline.hydro.hull import Hull
from gantline.hydro.mesh_file import HullError, read_hull
from gantline.scenario import Scenario
from gantline.scenario.afloat.water import Afloat, HullShape

__all__ = ["HullMesh", "afloat_path", "box_mesh", "hull_mesh", "hull_shape"]

#: Triangles that stand for a hull in pictures.
_MOST_DRAWN = 4000
#: Its convex hull may be missed by this share of its size.
_CONVEX_ERROR = 1e-3
#: Triangles that are smaller than this as seen from above stand upright: twice their area [m^2].
_NO_PLAN = 1e-9


@dataclass(frozen=True)
class HullMesh:
    """A hull in the axes of its body.

    Attributes:
        vertices: places (n, 3) [m].
        triangles: three vertices each (m, 3), anticlockwise from outside.
        doubts: what is doubtful about the mesh, a sentence each.
    """

    vertices: Array
    triangles: npt.NDArray[np.int64]
    doubts: tuple[str, ...] = ()

    @property
    def box(self) -> Array:
        """Least and largest x, y, z (2, 3) [m]."""
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)])

    def top_at(self, x: float, y: float) -> float | None:
        """How high it goes over a place [m]; None beside of it."""
        a, b, c = (self.vertices[self.triangles[:, corner]] for corner in range(3))
        ab, ac, way = b - a, c - a, np.array([x, y]) - a[:, :2]
        twice = ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0]
        # Upright triangles have no place in plan: those beside them go as high.
        flat = np.where(np.abs(twice) > _NO_PLAN, twice, np.inf)
        along_b = (way[:, 0] * ac[:, 1] - way[:, 1] * ac[:, 0]) / flat
        along_c = (ab[:, 0] * way[:, 1] - ab[:, 1] * way[:, 0]) / flat
        over = np.isfinite(flat) & (along_b >= 0.0) & (along_c >= 0.0) & (along_b + along_c <= 1.0)
        heights = a[:, 2] + along_b * ab[:, 2] + along_c * ac[:, 2]
        return float(heights[over].max()) if over.any() else None

    @property
    def document(self) -> Json:
        """As the core reads it."""
        return {"vertices": self.vertices.tolist(), "triangles": self.triangles.tolist()}


def afloat_path(scenario: Scenario, name: str) -> tuple[str, ...]:
    """Path of a vessel or a body of `mechanics` in the lift file."""
    return ("vessels", name) if name in (scenario.vessels or {}) else ("mechanics", "bodies", name)


def hull_mesh(scenario: Scenario, name: str, body: Afloat) -> HullMesh | None:
    """The hull of a vessel or a body of `mechanics`; None of one that has none.

    Raises:
        ScenarioError: if its file cannot be read, or holds no hull.
    """
    given = body.hull
    if given is None:
        return None
    if given.mesh is None:
        assert given.box is not None  # validated
        return box_mesh(given.box, given.bottom)
    path = Path(scenario.source).parent / given.mesh
    try:
        hull = _read(path, stamp(path), given)
    except HullError as problem:
        sentence = str(problem).replace(str(path), given.mesh).removeprefix(f"{given.mesh}: ")
        sentence = f"{given.mesh}: {sentence.removeprefix(f'{path.name}: ')}"
        raise scenario.error((*afloat_path(scenario, name), "hull", "mesh"), sentence) from None
    vertices, triangles = hull.mesh
    doubts = tuple(f"the hull of {name}, {given.mesh}: {doubt}" for doubt in hull.doubts())
    return HullMesh(vertices * given.scale + np.array(given.at), triangles, doubts)


@lru_cache(maxsize=8)
def _read(path: Path, _stamp: tuple[int, int], given: HullShape) -> Hull:
    """A hull of a file, read once for all cases of a lift."""
    return read_hull(path, given.units, up=given.up, half=given.half)


def hull_shape(mesh: HullMesh) -> Json:
    """A hull to draw: a light mesh, to a millimetre, with the corners of a convex body to touch it with."""
    whole = TriangleMesh(mesh.vertices, mesh.triangles)
    light = light_mesh(whole, _MOST_DRAWN).mesh
    return {
        "type": "mesh",
        "vertices": np.round(light.vertices, 3).tolist(),
        "triangles": light.triangles.tolist(),
        "hull": np.round(contact_hull(whole, _CONVEX_ERROR * whole.size).vertices, 3).tolist(),
    }


def box_mesh(size: Sequence[float], bottom: Sequence[float]) -> HullMesh:
    """A box over the middle of its bottom."""
    (length, breadth, depth), (x, y, z) = size, bottom
    vertices = [
        [x + i * length, y + j * breadth, z + k * depth]
        for i in (-0.5, 0.5)
        for j in (-0.5, 0.5)
        for k in (0, 1)
    ]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [triangle for a, b, c, d in faces for triangle in ([a, b, c], [a, c, d])]
    return HullMesh(np.array(vertices), np.array(triangles))
