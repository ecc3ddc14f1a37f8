"""Hulls from files, read as CAD files are: STL and OBJ, GLB, STEP and IGES."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import numpy as np

from gantline.arguments import path_of
from gantline.cad import Assumptions, CadError, read_surface
from gantline.cad.mesh import TriangleMesh
from gantline.cad.mesh_file import MESH_FORMATS, mesh_format
from gantline.hydro.hull import Array, Hull, Triangles
from gantline.hydro.shapes import box_hull
from gantline.hydro.skin import facing_alike, inner_share, lies_on_one_side
from gantline.units import DIMENSIONS, UnitError, quantity

__all__ = ["HullError", "read_hull"]

#: Share of a skin within other parts of it that is told: chance finds none of less than this.
_RUNS_THROUGH = 0.002
#: Length that no hull has [m]; the longest ship has 458 m.
_LONGEST = 1000.0
#: Places closer to the centre plane than this share of a hull's size lie in it.
_IN_PLANE = 1e-6


class HullError(ValueError):
    """A hull that cannot be read; the message says what is wrong."""


def read_hull(
    given: str | Path, unit: str | None = None, *, up: Literal["y", "z"] | None = None, half: bool = False
) -> Hull:
    """A hull from a file, or `box:100m,30m,8m` for a box of that length, breadth and depth.

    Args:
        given: CAD file of the hull, see `gantline.cad.read_surface`, or a box.
        unit: unit of length in the file; None takes what the file says, or metres where it says none.
        up: axis of the file that points up; None for the format's own: y in glTF, z in all others.
        half: whether the file has one side of the hull alone, up to its centre plane y = 0.

    Raises:
        HullError: if there is no such file, or it holds no hull.
    """
    text = str(path_of(given, "the file of a hull")) if not isinstance(given, str) else given
    try:
        if unit is not None and unit not in DIMENSIONS["length"]:
            raise HullError(f"'{unit}' is no unit of length; there are {', '.join(DIMENSIONS['length'])}")
        if text.startswith("box:"):
            return _box(text)
        path = Path(given)
        if unit is None and MESH_FORMATS.get(mesh_format(path) or "") in ("STL", "OBJ"):
            unit = "m"
        mesh, doubts = read_surface(path, Assumptions(unit=unit, up=up))
        vertices, triangles = mesh.vertices, mesh.triangles.astype(np.int64)
        if half:
            vertices, triangles = _both_sides(vertices, triangles)
        whole, count = facing_alike(TriangleMesh(vertices, triangles))
        told = [*doubts, *_turned(count, len(whole.triangles)), *_of_the_skin(whole)]
        return Hull(path.name, whole.vertices, whole.triangles.astype(np.int64), doubts=told)
    except (HullError, CadError) as problem:
        raise HullError(str(problem)) from None
    except ValueError as problem:
        raise HullError(f"{text}: {problem}") from None


def _turned(count: int, whole: int) -> list[str]:
    return [f"{count} of {whole} triangles faced the wrong side; they are turned"] if count else []


def _of_the_skin(mesh: TriangleMesh) -> list[str]:
    """What is doubtful of where a hull's skin runs, a sentence each."""
    found: list[str] = []
    if lies_on_one_side(mesh):
        found.append(
            "all of it is on one side of the centre plane y = 0; half of a hull needs its other half"
        )
    share = inner_share(mesh if mesh.volume > 0 else mesh.flipped())
    if share > _RUNS_THROUGH:
        found.append(
            f"{100 * share:.2g} % of its skin lies within other parts of it, which displace twice there"
        )
    longest = float(np.ptp(mesh.box, axis=0).max())
    if longest > _LONGEST:
        found.append(f"it is {longest:.4g} m long; no hull is, so its unit may be another")
    return found


def _both_sides(vertices: Array, triangles: Triangles) -> tuple[Array, Triangles]:
    """A side of a hull with its mirror image; what lies in the centre plane, as a wall there, is left out."""
    used = vertices[triangles.reshape(-1)]
    slack = _IN_PLANE * float(np.linalg.norm(np.ptp(used, axis=0)))
    least, most = float(used[:, 1].min()), float(used[:, 1].max())
    if min(-least, most) > slack:
        sides = f"it reaches from y = {least:.4g} to {most:.4g} m"
        raise HullError(f"{sides}, to both sides of the centre plane y = 0: it is no half of a hull")
    in_plane = np.abs(vertices[:, 1]) <= slack
    own = np.where(in_plane[:, None], vertices * (1.0, 0.0, 1.0), vertices)
    skin = triangles[~in_plane[triangles].all(axis=1)]
    mirrored = skin[:, ::-1] + len(own)
    return np.concatenate([own, own * (1.0, -1.0, 1.0)]), np.concatenate([skin, mirrored])


def _box(text: str) -> Hull:
    parts = text.removeprefix("box:").split(",")
    if len(parts) != 3:
        raise HullError(f"'{text}' is no box; it would be right as box:100m,30m,8m: length, breadth, depth")
    try:
        return box_hull([quantity(part.strip(), "length") for part in parts], text)
    except UnitError as problem:
        raise HullError(f"'{text}': {problem}") from None
