"""Solids and open surfaces of plain geometry as parts: weighed, and what is doubtful about them said."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from gantline.cad.assumptions import Assumptions
from gantline.cad.errors import CadError
from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cad.model import Part, PartKind

__all__ = ["NO_THICKNESS", "NO_WEIGHT", "parts_of_mesh"]

#: Vertices closer than this share of the whole are one; single precision has 6e-8.
_WELD = 1e-6
#: Closed pieces in one mesh.
_MOST_PIECES = 100_000
#: Bodies above which it is not looked for whether one lies within another: each is held against all.
_MOST_COMPARED = 5000
#: Vertices of a piece that tell whether it lies within another one.
_SOME = 12
NO_THICKNESS = "its surface is open and no plate thickness is given, so it has no weight"
RUNS_THROUGH_ITSELF = "its surface runs through itself, so it has no weight"
NO_WEIGHT = "it encloses next to nothing, so it has no weight"


def parts_of_mesh(name: str, mesh: TriangleMesh, size: float, given: Assumptions) -> Iterator[Part]:
    """Parts of one mesh [m]: each closed piece with its cavities a solid, all open pieces together a shell.

    Args:
        name: of the parts; where there are several they are numbered.
        mesh: in metres, not necessarily welded.
        size: diagonal of the whole file's geometry [m].
        given: density and plate thickness.

    Raises:
        CadError: if the mesh falls into too many pieces.
    """
    welded = mesh.welded(_WELD * size)
    doubts = []
    whole = welded.without(welded.duplicates)
    if len(welded.duplicates):
        doubts.append(
            f"{len(welded.duplicates)} of {len(welded.triangles)} triangles are there twice; they count once"
        )
    drawn_twice = whole.backs_of_surfaces
    if len(drawn_twice):
        doubts.append(f"{len(drawn_twice)} triangles are there from both sides; they count once")
        whole = whole.without(drawn_twice)
    closed: list[TriangleMesh] = []
    opened: list[TriangleMesh] = []
    for shell in whole.shells():
        (closed if shell.is_closed else opened).append(shell)
    if len(closed) > _MOST_PIECES:
        raise CadError(f"'{name}' has more than {_MOST_PIECES} closed pieces")
    found = [_solid(body, cavities, given, within) for body, cavities, within in _nested(closed)]
    if opened:
        found.append(_surface(opened, given))
    for place, (kind, properties, body, own) in enumerate(found, start=1):
        yield Part(
            name=name if len(found) == 1 else f"{name} {place}",
            kind=kind,
            properties=properties,
            declared=None,
            mesh=body,
            size=f"{given.thickness * 1e3:g} mm" if given.thickness and kind is PartKind.SHELL else "",
            doubts=(*doubts, *own) if place == 1 else tuple(own),
        )


_Found = tuple[PartKind, MassProperties | None, TriangleMesh, list[str]]


def _nested(closed: list[TriangleMesh]) -> Iterator[tuple[TriangleMesh, list[TriangleMesh], bool]]:
    """Bodies with their cavities, and whether they lie in the material of another one.

    Cavities are pieces that face inwards and lie within one that faces outwards. Where a piece that faces
    inwards lies in none, it is inside out, and so is what lies within it: a mirrored file has its cavities
    facing outwards.
    """
    inwards = [shell.volume < 0 for shell in closed]
    inside_out = [
        place
        for place, shell in enumerate(closed)
        if inwards[place] and not any(_contains(other, shell) for other in closed if other is not shell)
    ]
    turned = [
        place in inside_out or any(_contains(closed[outer], shell) for outer in inside_out)
        for place, shell in enumerate(closed)
    ]
    outer = [place for place in range(len(closed)) if inwards[place] == turned[place]]
    cavities: dict[int, list[TriangleMesh]] = {}
    alone = []
    for place, shell in enumerate(closed):
        if inwards[place] == turned[place]:
            continue
        within = [other for other in outer if _contains(closed[other], shell)]
        if within:
            smallest = min(within, key=lambda other: abs(closed[other].volume))
            cavities.setdefault(smallest, []).append(shell.flipped() if turned[place] else shell)
        else:
            alone.append(place)
    filled = _in_material(closed, outer, cavities)
    for place in [*outer, *alone]:
        yield closed[place], cavities.get(place, []), place in filled


def _in_material(
    closed: list[TriangleMesh], outer: list[int], cavities: dict[int, list[TriangleMesh]]
) -> set[int]:
    """Which bodies lie within another one and not in a cavity of it."""
    if len(outer) > _MOST_COMPARED:
        return set()
    boxes = np.array([closed[place].box for place in outer])
    found = set()
    for place, (low, high) in zip(outer, boxes, strict=True):
        around = np.all(boxes[:, 0] <= low, axis=1) & np.all(boxes[:, 1] >= high, axis=1)
        for other in (outer[which] for which in np.flatnonzero(around) if outer[which] != place):
            hollow = cavities.get(other, [])
            if _holds(closed[other], closed[place]) and not any(_holds(one, closed[place]) for one in hollow):
                found.add(place)
    return found


def _holds(outer: TriangleMesh, inner: TriangleMesh) -> bool:
    """Whether all of one is within the other, as far as some of its vertices tell."""
    if not _contains(outer, inner):
        return False
    some = np.unique(np.linspace(0, len(inner.vertices) - 1, _SOME).astype(int))
    return all(_sees_all_round(outer, inner.vertices[which]) for which in some)


def _contains(outer: TriangleMesh, inner: TriangleMesh) -> bool:
    """Whether one may be within the other: its box is, and one vertex."""
    if np.any(inner.box[0] < outer.box[0]) or np.any(inner.box[1] > outer.box[1]):
        return False
    return _sees_all_round(outer, inner.vertices[0])


def _sees_all_round(outer: TriangleMesh, point: npt.NDArray[np.float64]) -> bool:
    """Whether a point (3,) is within a closed mesh: the solid angle that it sees of it is 4 π."""
    a, b, c = (outer.corners - point).transpose(1, 0, 2)
    la, lb, lc = (np.linalg.norm(side, axis=1) for side in (a, b, c))
    triple = np.einsum("mi,mi->m", a, np.cross(b, c))
    dots = [np.einsum("mi,mi->m", one, other) for one, other in ((a, b), (b, c), (c, a))]
    angle = 2 * np.arctan2(triple, la * lb * lc + dots[0] * lc + dots[1] * la + dots[2] * lb)
    return abs(float(angle.sum())) > 2 * np.pi


def _solid(body: TriangleMesh, cavities: list[TriangleMesh], given: Assumptions, within: bool) -> _Found:
    mesh, flipped = body.oriented()
    doubts = [_flipped(flipped, len(mesh.triangles))] if flipped else []
    if not mesh.is_consistent or mesh.volume <= 1e-12 * mesh.size**3:
        return PartKind.SHELL, None, mesh, [*doubts, NO_WEIGHT]
    if within:
        doubts.append("it lies within another solid, and both weigh; a cavity has to face inwards")
    mesh = TriangleMesh.combined([mesh, *cavities])
    try:
        return PartKind.SOLID, MassProperties.of_closed_mesh(mesh, given.density), mesh, doubts
    except ValueError:  # of closed meshes that run through themselves
        return PartKind.SHELL, None, mesh, [*doubts, RUNS_THROUGH_ITSELF]


def _surface(opened: list[TriangleMesh], given: Assumptions) -> _Found:
    mesh, flipped = TriangleMesh.combined(opened).oriented()
    edges = len(mesh.boundary_edges)
    doubts = [f"open surface of {len(opened)} piece{'s' * (len(opened) > 1)} with {edges} free edges"]
    if flipped:
        doubts.append(_flipped(flipped, len(mesh.triangles)))
    if given.thickness is None:
        return PartKind.SHELL, None, mesh, [*doubts, NO_THICKNESS]
    if not mesh.area > 0:
        return PartKind.SHELL, None, mesh, [*doubts, NO_WEIGHT]
    weighed = MassProperties.of_shell(mesh, given.density * given.thickness, given.thickness)
    return PartKind.SHELL, weighed, mesh, doubts


def _flipped(flipped: int, count: int) -> str:
    if flipped == count:
        return "all its triangles faced inwards; they are turned"
    return f"{flipped} of {count} triangles faced the wrong side; they are turned"
