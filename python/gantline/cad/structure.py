"""Ship structure as plates and bars: rectangles with lightening holes, straight profiles, weighed exactly."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import numpy.typing as npt

from gantline.cad.assumptions import STEEL
from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cad.model import DeclaredWeight, Part, PartKind

__all__ = ["Bar", "Hole", "Panel", "Plate", "Profile"]

Array = npt.NDArray[np.float64]

#: Corners of a half circle of a hole, and of a tube, where they are drawn.
_HALF_CIRCLE = 8
_TUBE = 16


@dataclass(frozen=True)
class Profile:
    """A rolled section; sizes as OCX has them.

    Attributes:
        kind: ``FlatBar`` (height along the web, width is the thickness), ``LBar`` (height over all) or
            ``Tube`` (height is the diameter, web the wall).
        height: [m].
        width: [m].
        web: thickness of the web [m]; 0 of a flat bar.
        flange: thickness of the flange [m]; 0 where there is none.
    """

    kind: str
    height: float
    width: float
    web: float = 0.0
    flange: float = 0.0

    @property
    def name(self) -> str:
        """Such as ``FB120X8`` or ``L100X75X7/10``."""
        h, w, web, flange = (f"{1e3 * size:g}" for size in (self.height, self.width, self.web, self.flange))
        names = {"FlatBar": f"FB{h}X{w}", "LBar": f"L{h}X{w}X{web}/{flange}", "Tube": f"CH{h}X{web}"}
        return names[self.kind]

    @property
    def outline(self) -> Array:
        """Corners (k, 2) [m] along flange and web from its box's corner, anticlockwise; a tube's outside."""
        h, w, web, flange = self.height, self.width, self.web, self.flange
        if self.kind == "FlatBar":
            return np.array([(0, 0), (w, 0), (w, h), (0, h)])
        if self.kind == "LBar":
            return np.array([(0, 0), (web, 0), (web, h - flange), (w, h - flange), (w, h), (0, h)])
        angle = 2 * np.pi * np.arange(_TUBE) / _TUBE
        return h / 2 * (1 + np.column_stack([np.cos(angle), np.sin(angle)]))


@dataclass(frozen=True, eq=False)
class Bar:
    """A straight profile.

    Attributes:
        name: of the part.
        kind: stiffener or pillar.
        profile: its section.
        ends: of the trace line (2, 3) [m].
        web: direction of the web away from what it stiffens (3,).
        flange: direction of the flange (3,).
        offset: of the section's corner from the trace line along flange and web [m].
    """

    name: str
    kind: PartKind
    profile: Profile
    ends: Array
    web: Array
    flange: Array
    offset: tuple[float, float] = (0.0, 0.0)

    @property
    def part(self) -> Part:
        """The bar with its weight."""
        way = self.ends[1] - self.ends[0]
        outline = self.profile.outline + self.offset
        if float(np.cross(self.flange, self.web) @ way) < 0:
            outline = outline[::-1]
        ring = self.ends[0] + outline[:, :1] * self.flange + outline[:, 1:] * self.web
        if self.profile.kind == "Tube":
            inner = 1 - 2 * self.profile.web / self.profile.height
            middle = ring.mean(axis=0)
            mesh = _pipe(ring, middle + inner * (ring - middle), way)
            properties = self._tube(way)
        else:
            mesh = _prism(ring, [], way)
            properties = MassProperties.of_closed_mesh(mesh, STEEL)
        return _part(self.name, self.kind, properties, mesh, self.profile.name)

    def _tube(self, way: Array) -> MassProperties:
        """Closed form: m (R² + r²)/4 about an axis across, and l²/12 along."""
        length = float(np.linalg.norm(way))
        outer = self.profile.height / 2
        inner = outer - self.profile.web
        mass = STEEL * math.pi * (outer**2 - inner**2) * length
        across = np.eye(3) - np.outer(way, way) / length**2
        round_it = (outer**2 + inner**2) / 4
        inertia = mass * (round_it * (2 * np.eye(3) - across) + length**2 / 12 * across)
        middle = self.ends.mean(axis=0)
        middle = middle + (self.offset[0] + outer) * self.flange + (self.offset[1] + outer) * self.web
        return MassProperties(mass, middle, inertia)


@dataclass(frozen=True, eq=False)
class Hole:
    """A lightening hole with round ends in a plate, in a cell of the plate that is its own.

    Attributes:
        centre: (3,) [m].
        width: along the plate's first side [m].
        height: along its second side, not larger than the width [m].
    """

    centre: Array
    width: float
    height: float

    @property
    def area(self) -> float:
        """[m^2]."""
        return (self.width - self.height) * self.height + math.pi * self.height**2 / 4

    def moments(self) -> tuple[float, float]:
        """∫ u² dA along the width, ∫ v² dA along the height, about its centre [m^4].

        A rectangle a × 2r between half circles, each shifted by d = a/2 from the middle: their second moment
        is that of the circle π r⁴/4, with π r² d² and twice the shift of their first moment, 8 d r³/3.
        """
        a, r = self.width - self.height, self.height / 2
        d = a / 2
        disc = math.pi * r**4 / 4
        return 2 * r * a**3 / 12 + disc + math.pi * r**2 * d**2 + 8 * d * r**3 / 3, a * (
            2 * r
        ) ** 3 / 12 + disc

    def outline(self) -> Array:
        """Corners (k, 2) [m] about its centre, anticlockwise from its rightmost."""
        angle = np.pi * np.arange(_HALF_CIRCLE + 1) / _HALF_CIRCLE
        half = self.height / 2 * np.column_stack([np.cos(angle - np.pi / 2), np.sin(angle - np.pi / 2)])
        right = half + np.array([(self.width - self.height) / 2, 0.0])
        return np.concatenate([right[_HALF_CIRCLE // 2 :], -right, right[: _HALF_CIRCLE // 2]])


@dataclass(frozen=True, eq=False)
class Plate:
    """A rectangular plate about its middle surface.

    Attributes:
        name: of the part.
        corner: of the middle surface (3,) [m].
        sides: from there to the two neighbouring corners (2, 3) [m], at right angles.
        thickness: [m].
        holes: each in the middle of its own of so many equal cells side by side along the first side.
    """

    name: str
    corner: Array
    sides: Array
    thickness: float
    holes: tuple[Hole, ...] = ()

    @property
    def outline(self) -> Array:
        """Its four corners (4, 3) [m]."""
        a, b = self.sides
        return np.array([self.corner, self.corner + a, self.corner + a + b, self.corner + b])

    @property
    def area(self) -> float:
        """Of one side, holes taken off [m^2]."""
        lengths = np.linalg.norm(self.sides, axis=1)
        return float(lengths[0] * lengths[1]) - sum(hole.area for hole in self.holes)

    @property
    def part(self) -> Part:
        """The plate with its weight."""
        lengths = np.linalg.norm(self.sides, axis=1)
        axes = np.array([*(self.sides / lengths[:, None]), np.zeros(3)])
        axes[2] = np.cross(axes[0], axes[1])
        second = lengths**2 / 12 * lengths[0] * lengths[1]
        middle = self.corner + self.sides.sum(axis=0) / 2
        whole = self._sheet(float(lengths[0] * lengths[1]), middle, (second[0], second[1]), axes)
        properties = _less(whole, [self._sheet(h.area, h.centre, h.moments(), axes) for h in self.holes])
        return _part(
            self.name, PartKind.PLATE, properties, self._mesh(axes), f"{1e3 * self.thickness:.4g} mm"
        )

    def _sheet(self, area: float, centre: Array, second: tuple[float, float], axes: Array) -> MassProperties:
        """Of an area of this thickness with its second moments along the plate's sides."""
        moments = np.diag([*second, area * self.thickness**2 / 12]) * STEEL * self.thickness
        inertia = np.trace(moments) * np.eye(3) - moments
        return MassProperties(STEEL * self.thickness * area, centre, axes.T @ inertia @ axes)

    def _mesh(self, axes: Array) -> TriangleMesh:
        depth = self.thickness * axes[2]
        low = self.corner - depth / 2
        if not self.holes:
            return _prism(self.outline - depth / 2, [], depth)
        cells = []
        step = self.sides[0] / len(self.holes)
        for place, hole in enumerate(self.holes):
            start = low + place * step
            ring = np.array([start, start + step, start + step + self.sides[1], start + self.sides[1]])
            inside = hole.centre - depth / 2 + hole.outline() @ axes[:2]
            cells.append(_prism(ring, [inside], depth))
        return TriangleMesh.combined(cells)


@dataclass(frozen=True, eq=False)
class Panel:
    """Plates and stiffeners in one plane.

    Attributes:
        name: of the panel.
        function: what it is for, in the words of OCX, such as ``WEB_FRAME``.
        plates: its plates.
        bars: stiffeners on them.
    """

    name: str
    function: str
    plates: tuple[Plate, ...]
    bars: tuple[Bar, ...] = field(default=())

    @property
    def parts(self) -> list[Part]:
        """All parts, in the panel's group."""
        found = [plate.part for plate in self.plates] + [bar.part for bar in self.bars]
        return [replace(part, group=self.name) for part in found]


def _part(name: str, kind: PartKind, weighed: MassProperties, mesh: TriangleMesh, size: str) -> Part:
    declared = DeclaredWeight(weighed.mass, weighed.centre)
    return Part(name, kind, weighed, declared, mesh, material="A", size=size)


def _less(whole: MassProperties, holes: Sequence[MassProperties]) -> MassProperties:
    """What is left of a body when others are cut out of it."""
    if not holes:
        return whole
    mass = whole.mass - math.fsum(hole.mass for hole in holes)
    centre = (whole.mass * whole.centre - sum(hole.mass * hole.centre for hole in holes)) / mass
    inertia = whole.about(centre) - np.sum([hole.about(centre) for hole in holes], axis=0)
    return MassProperties(mass, centre, inertia)


def _prism(ring: Array, holes: Sequence[Array], way: Array) -> TriangleMesh:
    """What a polygon (k, 3), or a rectangle with a hole, sweeps along a way; anticlockwise against it."""
    count = len(ring)
    if holes:
        (hole,) = holes
        bottom, faces = np.concatenate([ring, hole]), _ring_faces(len(hole))
        walls = [(i, (i + 1) % 4) for i in range(4)]
        walls += [(4 + (i + 1) % len(hole), 4 + i) for i in range(len(hole))]
    else:
        bottom, faces = ring, _polygon_faces(count)
        walls = [(i, (i + 1) % count) for i in range(count)]
    n = len(bottom)
    triangles = [(a, c, b) for a, b, c in faces] + [(n + a, n + b, n + c) for a, b, c in faces]
    triangles += [t for i, j in walls for t in ((i, j, n + j), (i, n + j, n + i))]
    return TriangleMesh(np.concatenate([bottom, bottom + way]), np.array(triangles))


def _pipe(outer: Array, inner: Array, way: Array) -> TriangleMesh:
    """What the area between two polygons of as many corners (k, 3) sweeps along a way (3,)."""
    count = len(outer)
    rings = [outer, inner, inner + way, outer + way]
    triangles = []
    for start, end in ((0, 1), (1, 2), (2, 3), (3, 0)):
        for i in range(count):
            j = (i + 1) % count
            a, b, c, d = start * count + i, start * count + j, end * count + j, end * count + i
            triangles += [(a, c, b), (a, d, c)]
    return TriangleMesh(np.concatenate(rings), np.array(triangles))


def _polygon_faces(count: int) -> list[tuple[int, int, int]]:
    """Triangles of a convex polygon, or of the six corners of an L."""
    if count == 6:
        return [(0, 1, 2), (0, 2, 5), (2, 3, 4), (2, 4, 5)]
    return [(0, i, i + 1) for i in range(1, count - 1)]


def _ring_faces(count: int) -> list[tuple[int, int, int]]:
    """Triangles between a rectangle, corners 0 to 3, and a hole with round ends within.

    Each corner of the rectangle, of which 0 lies left and below, sees the quarter of the hole in its
    quadrant.
    """
    half = count // 2
    quarters = [range(half // 2 + 1), range(half // 2 + 1, half + 1)]
    quarters += [range(half, half + half // 2 + 1), range(half + half // 2 + 1, count + 1)]
    faces = []
    for place, corner in enumerate((2, 3, 0, 1)):
        arc = [4 + k % count for k in quarters[place]]
        after = 4 + quarters[(place + 1) % 4][0] % count
        faces += [(corner, b, a) for a, b in itertools.pairwise(arc)]
        faces.append((corner, (corner + 1) % 4, arc[-1]))
        if after != arc[-1]:
            faces.append(((corner + 1) % 4, after, arc[-1]))
    return faces
