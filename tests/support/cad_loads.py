"""Loads from CAD on supports: prisms as OBJ files, in lifts of the hull section."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial import ConvexHull

from gantline.assembly import Assembly, assemble
from gantline.cad.mesh import TriangleMesh
from gantline.results.variable import FloatArray
from gantline.scenario import load_scenario
from hull_lift import HULL, lift, text

#: Level at which loads start, and places of usual rows of supports along their length [m].
LEVEL, ROWS = 1.5, (-6.0, 6.0)


def prism(section: Sequence[tuple[float, float]] | FloatArray, length: float) -> TriangleMesh:
    """A closed prism along x, its section (n, 2) in y, z anticlockwise seen from +x and convex [m]."""
    outline, count = np.asarray(section, dtype=float), len(section)
    ends = [np.column_stack([np.full(count, x), outline]) for x in (-length / 2, length / 2)]
    triangles = []
    for one in range(count):
        other = (one + 1) % count
        triangles += [(one, count + one, count + other), (one, count + other, other)]
    for place in range(1, count - 1):
        triangles += [(0, place, place + 1), (count, count + place + 1, count + place)]
    return TriangleMesh(np.concatenate(ends), np.array(triangles)[:, ::-1])


def half_cylinder(radius: float, length: float, facets: int = 720) -> TriangleMesh:
    """The lower half of a cylinder along x, its lowest line at z = 0, closed by a deck at z = radius."""
    angles = np.linspace(np.pi, 2 * np.pi, facets + 1)
    return prism(np.column_stack([radius * np.cos(angles), radius * (1 + np.sin(angles))]), length)


def obj(mesh: TriangleMesh) -> str:
    """A mesh as an OBJ file."""
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in mesh.vertices.tolist()]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in mesh.triangles.tolist()]
    return "\n".join([*lines, ""])


def cad_lift(folder: Path, mesh: TriangleMesh, keel_blocks: dict[str, Any], **load: Any) -> dict[str, Any]:
    """A lift of a mesh of 20 t, standing at `LEVEL`, with a group of supports; its CAD file in the folder."""
    (folder / "load.obj").write_text(obj(mesh))
    middle = [f"{part} m" for part in (0.0, 0.0, 0.5 * float(mesh.box[1, 2]))]
    own = {
        "shape": {"cad": "load.obj", "units": "m"},
        "position": ["-35 m", "0 m", f"{LEVEL} m"],
        "weight": {"calculated": "20 t"},
        "centre_of_gravity": {"at": middle},
    }
    group = {"under": "hull", "stiffness": "100 MN/m", "damping": "1 MN s/m", "friction": 0.4, **keel_blocks}
    given = {key: value for key, value in {**HULL["load"], **own, **load}.items() if key != "lugs"}
    return lift(load=given, supports={"keel_blocks": group}, cranes=None, slings=None)


def assembled(folder: Path, given: dict[str, Any]) -> Assembly:
    """A lift put together."""
    path = folder / "scenario.yaml"
    path.write_text(text(given))
    return assemble(load_scenario(path))


def convex(points: Sequence[tuple[float, float, float]] | FloatArray) -> TriangleMesh:
    """The convex hull of points (n, 3) [m]."""
    given = np.asarray(points, dtype=float)
    hull = ConvexHull(given)
    a, b, c = given[hull.simplices].transpose(1, 0, 2)
    inwards = np.einsum("nx,nx->n", np.cross(b - a, c - a), hull.equations[:, :3]) < 0.0
    return TriangleMesh(given, np.where(inwards[:, None], hull.simplices[:, ::-1], hull.simplices))
