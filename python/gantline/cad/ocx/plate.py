"""Plates: flat or curved areas with a thickness, and openings cut out of them.

A flat plate is integrated exactly from the curves of its contour. A curved plate is its surface, if that
ends where the contour runs, or the part of it that lies within the contour, seen along the contour's mean
normal: the surface in facets, each cut along the contour and integrated exactly, facets halved until the
area no longer changes. Across its thickness t a plate of mass m has m t²/12 about its middle. The contour
lies in the middle of the plate, as exporters declare centres of gravity.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cad.ocx.curves import Curve, polyline
from gantline.cad.ocx.moments import Frame, Moments, clipped, enclosed, of_polygon
from gantline.cad.ocx.openings import Opening, each_once, is_off, near, parted
from gantline.cad.ocx.surface import Surface, along_edge, bounds
from gantline.cad.ocx.triangulate import prism, simplified, triangulated

__all__ = ["Sheet", "contour_frame", "curved_sheet", "flat_sheet", "is_flat", "spans"]

Array = npt.NDArray[np.float64]
_Edges = Sequence[Curve]

_FLAT = 1e-3  # of the plate's size, and at least a millimetre
_COARSE = (
    2e-3  # chords of the polygons that openings and surfaces are cut along miss by this share of the size
)
_SETTLED = 1e-4  # of a curved plate's area
_SAME_EDGE = 5e-3  # of the size: how far apart a contour and the edge of its surface may be
_BOUNDARY_PARTS = 16
_FINEST = 64  # parts of a surface's span


@dataclass(frozen=True, eq=False)
class Sheet:
    """A plate's weight and triangles.

    Attributes:
        area: of one side, openings cut out [m^2].
        properties: None if nothing is left of it.
        mesh: triangles around it.
        doubts: what is not certain.
    """

    area: float
    properties: MassProperties | None
    mesh: TriangleMesh
    doubts: tuple[str, ...] = ()


def contour_frame(path: _Edges) -> Frame | None:
    """Plane of a contour: through its middle, normal to its vector area ½ ∮ r × dr; None if that is zero."""
    points = polyline(path, 1e-3)
    middle = points.mean(axis=0)
    around = points - middle
    normal = np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0) / 2
    size = float(np.linalg.norm(normal))
    if not size > 1e-12 * max(1e-6, float((around**2).sum(axis=1).max())):
        return None
    return Frame.across(middle, normal / size)


def is_flat(path: _Edges, frame: Frame) -> bool:
    """Whether a contour lies in its plane, within a thousandth of its size and a millimetre."""
    around = polyline(path, 1e-3) - frame.origin
    away = float(np.abs(around @ frame.normal).max())
    return away <= max(1e-3, _FLAT * float(np.linalg.norm(around, axis=1).max()))


def spans(surface: Surface, path: _Edges, frame: Frame) -> bool:
    """Whether a flat contour is the edge of a surface that leaves its plane, such as a dome."""
    outline = polyline(path, 1e-3)
    size = float(np.linalg.norm(outline - frame.origin, axis=1).max())
    facets = surface.facets(surface.parts(_BOUNDARY_PARTS))
    is_bent = float(np.abs((facets.reshape(-1, 3) - frame.origin) @ frame.normal).max()) > max(
        1e-3, _FLAT * size
    )
    return is_bent and bounds(facets, outline, _SAME_EDGE * size)


def flat_sheet(
    path: _Edges, frame: Frame, openings: Sequence[_Edges], thickness: float, density: float, tolerance: float
) -> Sheet:
    """A plate in a plane.

    Args:
        path: its contour, anticlockwise about the frame's normal.
        frame: its plane.
        openings: contours of what is cut out, in this plane; what lies outside the plate cuts nothing.
        thickness: [m].
        density: [kg/m^3].
        tolerance: by how much triangles may miss the plate [m].
    """
    rim = simplified(frame.flat(polyline(path, tolerance)), tolerance)
    moments = enclosed(path, frame)
    found = [Opening.of(each, frame, tolerance) for each in openings if not is_off(each, frame, tolerance)]
    inner, across = parted(rim, each_once(found))
    doubts = []
    for opening in inner:
        own = enclosed(opening.path, frame)
        moments = moments - (own if own.area >= 0 else -own)
    if across:
        # What an opening takes from the plate: the opening cut along each triangle of the plate.
        fine, triangles = triangulated(rim)
        for opening in across:
            for piece in opening.pieces:
                for triangle in near(piece, fine[triangles]):
                    moments = moments - _positive(of_polygon(clipped(piece, triangle)))
        doubts.append(
            "an opening runs over its edge or another opening: it is left out of the weight, but not of the "
            "picture"
        )
    drawn = [simplified(each.polygon, tolerance) for each in inner]
    corners, triangles = triangulated(rim, drawn)
    mesh = _slab([rim, *drawn], triangles, frame.spatial(corners), frame.normal, thickness)
    if not moments.area > 0:
        return Sheet(0.0, None, mesh, (*doubts, "nothing is left of it within its contour"))
    return Sheet(moments.area, _weighed([(moments, frame)], thickness, density), mesh, tuple(doubts))


def curved_sheet(
    path: _Edges,
    frame: Frame,
    surface: Surface,
    openings: Sequence[_Edges],
    thickness: float,
    density: float,
    tolerance: float,
) -> Sheet | None:
    """A plate on a curved surface; None if the surface does not reach over it.

    A surface that ends where the contour runs is the plate. Of any other the part is taken that lies within
    the contour, seen along its mean normal, as openings are; there it must not turn away. Other arguments as
    for `flat_sheet`.
    """
    outline = polyline(path, tolerance)
    size = float(np.linalg.norm(outline - frame.origin, axis=1).max())
    rim = simplified(frame.flat(outline), _COARSE * 1e-2 * size)
    apart = each_once([Opening.of(each, frame, tolerance) for each in openings])
    cuts = [
        simplified(piece, tolerance) if each.is_alone else piece for each in apart for piece in each.pieces
    ]
    if bounds(surface.facets(surface.parts(_BOUNDARY_PARTS)), outline, _SAME_EDGE * size):
        doubts = ["openings in a curved surface that it bounds alone are not cut out"] if cuts else []
        return _whole(surface, thickness, density, tuple(doubts))
    seen = abs(of_polygon(rim).area)
    pieces: list[tuple[Moments, Frame]] = []
    drawn: list[Array] = []
    area, is_steep = 0.0, False
    for facets in _finer(surface):
        pieces, drawn, is_steep = _pieces(facets, rim, cuts, frame, size)
        if _covered(pieces, frame) > 1.02 * seen:
            # The surface comes over the contour twice, as the far side of a cylinder does.
            near = along_edge(facets[_over(facets, rim, frame)], outline)
            pieces, drawn, is_steep = _pieces(near, rim, cuts, frame, size)
        before, area = area, sum(moments.area for moments, _ in pieces)
        if abs(area - before) <= _SETTLED * area:
            break
    covered = _covered(pieces, frame)
    holes = sum(_positive(of_polygon(cut)).area for cut in cuts)
    if not pieces or not 0.98 * seen <= covered + holes <= 1.02 * seen + holes:
        return None
    doubts = []
    if is_steep:
        doubts.append("its surface is too steep to be seen along one direction: its area is doubtful")
    return Sheet(area, _weighed(pieces, thickness, density), _mesh(np.concatenate(drawn)), tuple(doubts))


def _finer(surface: Surface) -> Iterator[Array]:
    """Facets of a surface, halved from one to the next; where it has only its own, these."""
    parts = surface.parts(2)
    while parts <= surface.parts(_FINEST):
        yield surface.facets(parts)
        if surface.is_faceted:
            return
        parts *= 2


def _mesh(facets: Array) -> TriangleMesh:
    corners = np.round(facets, 6)  # neighbours meet to a micrometre
    return TriangleMesh(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3)).welded()


def _whole(surface: Surface, thickness: float, density: float, doubts: tuple[str, ...]) -> Sheet | None:
    """All of a surface.

    A facet of area A with corners r₁, r₂, r₃ and their sum s has ∫ r dA = ⅓ A s and
    ∫ r rᵀ dA = A/12 (r₁r₁ᵀ + r₂r₂ᵀ + r₃r₃ᵀ + s sᵀ).
    """
    area = 0.0
    for facets in _finer(surface):
        normals = np.cross(facets[:, 1] - facets[:, 0], facets[:, 2] - facets[:, 0])
        doubled = np.linalg.norm(normals, axis=1)
        before, area = area, float(doubled.sum()) / 2
        if abs(area - before) <= _SETTLED * area:
            break
    if not area > 0.0:
        return None
    origin = facets[0, 0]
    sums = (facets - origin).sum(axis=1)
    ways = np.concatenate([facets - origin, sums[:, None]], axis=1)
    second = np.einsum("n,nki,nkj->ij", doubled / 24, ways, ways)
    # Seen along its normal n a facet of thickness t has A t²/12 n nᵀ; |normal| is 2 A.
    shares = np.divide(1.0, doubled, out=np.zeros_like(doubled), where=doubled > 0.0)
    second += thickness**2 / 24 * np.einsum("n,ni,nj->ij", shares, normals, normals)
    properties = _about_centre(origin, area, doubled @ sums / 6, second, thickness * density)
    return Sheet(area, properties, _mesh(facets), doubts)


def _covered(pieces: Sequence[tuple[Moments, Frame]], frame: Frame) -> float:
    """Area of pieces as it is seen along a frame's normal [m^2]."""
    return sum(abs(moments.area * float(own.normal @ frame.normal)) for moments, own in pieces)


def _over(facets: Array, rim: Array, frame: Frame) -> npt.NDArray[np.bool_]:
    """Which facets are seen within a polygon, even in part, and not edge on."""
    flat = frame.flat(facets)
    normals = np.cross(facets[:, 1] - facets[:, 0], facets[:, 2] - facets[:, 0])
    slope = np.abs(normals @ frame.normal) > 0.02 * np.linalg.norm(normals, axis=1)
    reach = np.all(flat.max(axis=1) >= rim.min(axis=0), axis=1) & np.all(
        flat.min(axis=1) <= rim.max(axis=0), axis=1
    )
    rim = rim if of_polygon(rim).area > 0 else rim[::-1]
    for index in np.flatnonzero(slope & reach):
        triangle = flat[index] if of_polygon(flat[index]).area > 0 else flat[index][::-1]
        reach[index] = len(clipped(rim, triangle)) >= 3
    return np.asarray(slope & reach)


def _pieces(
    facets: Array, rim: Array, cuts: Sequence[Array], frame: Frame, size: float
) -> tuple[list[tuple[Moments, Frame]], list[Array], bool]:
    """Each facet as far as it lies within the rim: moments in its own plane, triangles; is any too steep."""
    rim = rim if of_polygon(rim).area > 0 else rim[::-1]
    low, high = rim.min(axis=0), rim.max(axis=0)
    pieces: list[tuple[Moments, Frame]] = []
    drawn: list[Array] = []
    steep = False
    for facet in facets:
        normal = np.cross(facet[1] - facet[0], facet[2] - facet[0])
        doubled = float(np.linalg.norm(normal))
        if not doubled > 1e-14 * size**2:
            continue
        normal = normal / doubled
        slope = float(normal @ frame.normal)
        flat = frame.flat(facet)
        if np.any(flat.max(axis=0) < low) or np.any(flat.min(axis=0) > high):
            continue
        if float(np.abs((facet - frame.origin) @ frame.normal).max()) > 2.0 * size:
            continue
        if slope < 0:
            normal, slope, flat = -normal, -slope, flat[::-1]
        if slope < 0.02:
            steep = True
            continue
        inside = clipped(rim, flat)
        if len(inside) < 3:
            continue
        steep = steep or slope < 0.2
        own = Frame.across(facet[0], normal)
        moments = _lifted(inside, frame, own, slope)
        for cut in cuts:
            moments = moments - _positive_lifted(clipped(cut, flat), frame, own, slope)
        if moments.area > 0:
            pieces.append((moments, own))
        points, triangles = triangulated(inside)
        drawn.append(_raised(points, frame, own, slope)[triangles])
    return pieces, drawn, steep


def _raised(points: Array, frame: Frame, own: Frame, slope: float) -> Array:
    """Points (n, 3) in a facet's plane that are seen at (n, 2) along the frame's normal."""
    base = frame.spatial(points)
    return np.asarray(base + ((own.origin - base) @ own.normal / slope)[:, None] * frame.normal)


def _lifted(polygon: Array, frame: Frame, own: Frame, slope: float) -> Moments:
    return _positive(of_polygon(own.flat(_raised(polygon, frame, own, slope))))


def _positive_lifted(polygon: Array, frame: Frame, own: Frame, slope: float) -> Moments:
    return _lifted(polygon, frame, own, slope) if len(polygon) >= 3 else Moments.none()


def _positive(moments: Moments) -> Moments:
    return moments if moments.area >= 0 else -moments


def _weighed(pieces: Sequence[tuple[Moments, Frame]], thickness: float, density: float) -> MassProperties:
    """Mass properties of flat pieces with a thickness, joined."""
    origin = pieces[0][1].origin
    area, first, second = 0.0, np.zeros(3), np.zeros((3, 3))
    for moments, frame in pieces:
        axes, shift = frame.axes, frame.origin - origin
        own = axes @ moments.first
        mixed = np.outer(shift, own)
        area += moments.area
        first = first + moments.area * shift + own
        second = second + axes @ moments.second @ axes.T + mixed + mixed.T
        second = second + moments.area * np.outer(shift, shift)
        second = second + moments.area * thickness**2 / 12 * np.outer(frame.normal, frame.normal)
    return _about_centre(origin, area, first, second, density * thickness)


def _about_centre(origin: Array, area: float, first: Array, second: Array, mass: float) -> MassProperties:
    """Mass properties by an area [m²], its moments about a point, and the mass of a square metre [kg]."""
    centre = first / area
    about = second - area * np.outer(centre, centre)
    about = (about + about.T) / 2
    return MassProperties(mass * area, origin + centre, mass * (np.trace(about) * np.eye(3) - about))


def _slab(
    loops: Sequence[Array], triangles: npt.NDArray[np.int64], middle: Array, normal: Array, thickness: float
) -> TriangleMesh:
    half = thickness / 2 * normal
    return TriangleMesh(*prism(loops, triangles, np.stack([middle - half, middle + half])))
