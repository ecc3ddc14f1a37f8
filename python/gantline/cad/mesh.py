"""Triangle meshes: what they enclose, and whether they enclose anything."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

__all__ = ["TriangleMesh", "connected"]

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]

#: Triangles around an edge closer than this cover each other [rad].
_SAME_ANGLE = 1e-5


class _Edges(NamedTuple):
    """Edges of a mesh, each once.

    Attributes:
        ends: the two vertices, the lower index first (e, 2).
        uses: by how many triangles each is used (e,).
        turns: triangles that run along it from the lower index, less those that run against it (e,).
        of_triangle: which edge each side of each triangle is (m, 3).
        forward: whether that side runs from the lower index (m, 3).
    """

    ends: Whole
    uses: Whole
    turns: Whole
    of_triangle: Whole
    forward: npt.NDArray[np.bool_]


@dataclass(frozen=True, eq=False, init=False)
class TriangleMesh:
    """Triangles over shared vertices.

    Attributes:
        vertices: positions (n, 3) [m].
        triangles: three vertices each (m, 3), anticlockwise seen from outside.

    Raises:
        ValueError: if a coordinate is not finite, or a triangle names a vertex that does not exist.
    """

    vertices: Array
    triangles: npt.NDArray[np.int32]

    def __init__(self, vertices: npt.ArrayLike, triangles: npt.ArrayLike) -> None:
        points = np.array(vertices, dtype=float).reshape(-1, 3)
        given = np.asarray(triangles).reshape(-1, 3)
        if not np.isfinite(points).all():
            raise ValueError("a coordinate of the mesh is not a finite number")
        if given.size and (int(given.min()) < 0 or int(given.max()) >= len(points)):
            wrong = int(given.min()) if int(given.min()) < 0 else int(given.max())
            raise ValueError(
                f"a triangle names vertex {wrong}, but there are {len(points)} vertices, counted from 0"
            )
        indices = given.astype(np.int32)
        points.setflags(write=False)
        indices.setflags(write=False)
        object.__setattr__(self, "vertices", points)
        object.__setattr__(self, "triangles", indices)

    @classmethod
    def combined(cls, meshes: Sequence[TriangleMesh]) -> TriangleMesh:
        """Several meshes as one, vertices and triangles one after another; nothing is welded."""
        if not meshes:
            return cls(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32))
        starts = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes[:-1])])
        return cls(
            np.concatenate([mesh.vertices for mesh in meshes]),
            np.concatenate([mesh.triangles + start for mesh, start in zip(meshes, starts, strict=True)]),
        )

    @cached_property
    def corners(self) -> Array:
        """Corners of each triangle (m, 3 corners, xyz) [m]."""
        return self.vertices[self.triangles]

    @cached_property
    def _doubled(self) -> Array:
        """Normals with twice the area as length (m, 3) [m^2]."""
        first, second, third = self.corners.transpose(1, 0, 2)
        return np.cross(second - first, third - first)

    @cached_property
    def areas(self) -> Array:
        """Area of each triangle (m,) [m^2]."""
        return np.asarray(np.linalg.norm(self._doubled, axis=1) / 2)

    @cached_property
    def normals(self) -> Array:
        """Unit normal of each triangle (m, 3); zero where a triangle has no area."""
        size = 2 * self.areas[:, None]
        return np.divide(self._doubled, size, out=np.zeros_like(self._doubled), where=size > 0)

    @property
    def area(self) -> float:
        """Area of one side [m^2]."""
        return float(self.areas.sum())

    @cached_property
    def box(self) -> Array:
        """Least and largest x, y, z of all triangles (2, 3) [m]; vertices without triangles do not count."""
        used = self.corners.reshape(-1, 3)
        if not len(used):
            raise ValueError("a mesh without triangles has no box")
        return np.array([used.min(axis=0), used.max(axis=0)])

    @property
    def middle(self) -> Array:
        """Middle of the box (3,) [m]."""
        return np.asarray(self.box.mean(axis=0))

    @property
    def size(self) -> float:
        """Diagonal of the box [m]."""
        return float(np.linalg.norm(self.box[1] - self.box[0]))

    @property
    def volume(self) -> float:
        """Enclosed volume [m^3], by the divergence theorem; negative where triangles face inwards.

        Of an open mesh it is that of the cone from the middle of its box, which means nothing.
        """
        return float(np.linalg.det(self.corners - self.middle).sum() / 6)

    @cached_property
    def _edges(self) -> _Edges:
        sides = np.stack([self.triangles, np.roll(self.triangles, -1, axis=1)], axis=2).astype(np.int64)
        forward = sides[:, :, 0] < sides[:, :, 1]
        sides = np.sort(sides.reshape(-1, 2), axis=1)
        count = max(len(self.vertices), 1)
        keys, place = np.unique(sides[:, 0] * count + sides[:, 1], return_inverse=True)
        turns = np.where(forward.reshape(-1), 1.0, -1.0)
        return _Edges(
            ends=np.stack([keys // count, keys % count], axis=1),
            uses=np.bincount(place, minlength=len(keys)),
            turns=np.bincount(place, weights=turns, minlength=len(keys)).astype(np.int64),
            of_triangle=place.reshape(-1, 3),
            forward=forward,
        )

    @property
    def boundary_edges(self) -> Whole:
        """Edges at which the surface ends: pairs of vertices (e, 2)."""
        return np.asarray(self._edges.ends[self._edges.uses % 2 == 1])

    @property
    def is_closed(self) -> bool:
        """Whether each edge is used by an even number of triangles; weld first, or nothing is."""
        return len(self.triangles) > 0 and not len(self.boundary_edges)

    @property
    def is_consistent(self) -> bool:
        """Whether neighbours agree on which side is outside: opposite directions along their common edge."""
        return not np.any(self._edges.turns[self._edges.uses % 2 == 0])

    @cached_property
    def duplicates(self) -> Whole:
        """Triangles with the same vertices in the same turn as an earlier one: their indices."""
        turned = np.argmin(self.triangles, axis=1)[:, None] + np.arange(3)
        same = np.take_along_axis(self.triangles, turned % 3, axis=1)
        return self._repeated(same)

    @cached_property
    def backs(self) -> Whole:
        """Triangles with the same vertices as an earlier one, in whichever turn: their indices.

        Bodies that touch have a few, one's face being the other's; surfaces drawn from both sides only such.
        """
        return self._repeated(np.sort(self.triangles, axis=1))

    @property
    def backs_of_surfaces(self) -> Whole:
        """Those of `backs` that belong to surfaces drawn from both sides: their indices.

        Pieces that hang together over edges are told apart. Faces of bodies that touch cover each other too,
        but what is left without them is closed, for it encloses all of these bodies. Of a piece that is drawn
        from both sides more than a quarter are backs, and nothing is left, or something with free edges.
        """
        backs = self.backs
        if not len(backs):
            return backs
        sides = self._edges.of_triangle
        owners = np.repeat(np.arange(len(self.triangles)), 3)
        count = len(self.triangles)
        piece = connected(
            count + len(self._edges.ends), np.stack([owners, count + sides.reshape(-1)], axis=1)
        )[:count]
        _, same, times = np.unique(
            np.sort(self.triangles, axis=1), axis=0, return_inverse=True, return_counts=True
        )
        lone = times[same.reshape(-1)] == 1
        uses = np.bincount(sides[lone].reshape(-1), minlength=len(self._edges.ends))
        ends_free = np.bincount(piece, weights=np.any(uses[sides] % 2 == 1, axis=1) & lone) > 0
        left, all_of = np.bincount(piece, weights=lone), np.bincount(piece)
        of_backs = np.bincount(piece[backs], minlength=len(all_of))
        drawn = (4 * of_backs > all_of) & (ends_free | (left == 0))
        return np.asarray(backs[drawn[piece[backs]]])

    def _repeated(self, rows: npt.NDArray[np.int32]) -> Whole:
        _, first = np.unique(rows, axis=0, return_index=True)
        return np.setdiff1d(np.arange(len(self.triangles)), first)

    def without(self, triangles: Whole) -> TriangleMesh:
        """All triangles but some."""
        return self.of(np.setdiff1d(np.arange(len(self.triangles)), triangles)) if len(triangles) else self

    def of(self, triangles: npt.NDArray[np.int64] | npt.NDArray[np.bool_]) -> TriangleMesh:
        """Some of the triangles, with the vertices that they use."""
        kept = self.triangles[triangles]
        used, place = np.unique(kept, return_inverse=True)
        return TriangleMesh(self.vertices[used], place.reshape(-1, 3))

    def flipped(self) -> TriangleMesh:
        """All triangles seen from the other side."""
        return TriangleMesh(self.vertices, self.triangles[:, ::-1])

    def scaled(self, factor: float) -> TriangleMesh:
        """All positions times a positive factor."""
        return TriangleMesh(self.vertices * factor, self.triangles)

    def moved(self, rotation: Array, translation: Array) -> TriangleMesh:
        """Turned by a matrix (3, 3) about the origin, then moved by (3,) [m]; mirrors flip the triangles."""
        turn = np.asarray(rotation, dtype=float)
        mesh = TriangleMesh(self.vertices @ turn.T + np.asarray(translation, dtype=float), self.triangles)
        return mesh.flipped() if np.linalg.det(turn) < 0 else mesh

    def welded(self, tolerance: float = 0.0) -> TriangleMesh:
        """Vertices closer than a tolerance [m] made one; triangles that thereby lose their area left out.

        Chains of close vertices become one, at the place of the first.
        """
        places, of_vertex = np.unique(self.vertices + 0.0, axis=0, return_inverse=True)  # −0 is 0
        of_vertex = of_vertex.reshape(-1)
        if tolerance > 0 and len(places):
            from scipy.spatial import cKDTree  # takes a third of a second to load

            pairs = cKDTree(places).query_pairs(tolerance, output_type="ndarray")
            if len(pairs):
                groups = connected(len(places), pairs)
                _, first = np.unique(groups, return_index=True)
                places, of_vertex = places[first], groups[of_vertex]
        triangles = of_vertex[self.triangles]
        a, b, c = triangles.T
        kept = triangles[(a != b) & (b != c) & (c != a)]
        used, place = np.unique(kept, return_inverse=True)
        return TriangleMesh(places[used], place.reshape(-1, 3))

    def shells(self) -> list[TriangleMesh]:
        """Pieces that hang together, ordered by their first triangles.

        Over an edge of two triangles they do. Where bodies touch along an edge, four triangles or more, the
        two with material between them belong together. Plates that meet in a tee are pieces of their own.
        """
        if not len(self.triangles):
            return []
        groups = connected(len(self.triangles), self._neighbours()[0])
        order = np.argsort(groups, kind="stable")
        cuts = np.flatnonzero(np.diff(groups[order])) + 1
        pieces = sorted(np.split(order, cuts), key=lambda piece: int(piece[0]))
        return [self.of(piece) for piece in pieces]

    def _neighbours(self) -> tuple[Whole, npt.NDArray[np.bool_]]:
        """Pairs of triangles that hang together (e, 2), and whether the two agree on the side (e,)."""
        sides = self._edges.of_triangle.reshape(-1)
        order = np.argsort(sides, kind="stable")
        two = order[self._edges.uses[sides[order]] == 2].reshape(-1, 2)
        forward = self._edges.forward.reshape(-1)
        wedges = self._wedges(
            order[(self._edges.uses > 2)[sides[order]] & (self._edges.turns == 0)[sides[order]]]
        )
        agree = np.concatenate([forward[two[:, 0]] != forward[two[:, 1]], np.ones(len(wedges), dtype=bool)])
        return np.concatenate([two, wedges]) // 3, agree

    def _wedges(self, sides: Whole) -> Whole:
        """Pairs of sides with material between them (e, 2), of edges where four triangles or more meet.

        Seen along the edge, material lies clockwise of a triangle that runs along it, and anticlockwise of
        one that runs against it. So each of the latter belongs to the next of the former. Those that cover
        one another are faces of two bodies that touch: material ends at one before it begins at the other.

        Args:
            sides: sides of triangles, 3 times the triangle plus which, all of one edge after another.
        """
        edge = self._edges.of_triangle.reshape(-1)[sides]
        if not len(edge):
            return np.zeros((0, 2), dtype=np.int64)
        starts = np.flatnonzero(np.diff(edge, prepend=-1))
        group = np.cumsum(np.diff(edge, prepend=-1) != 0) - 1
        ends = self.vertices[self._edges.ends[edge]]
        along = ends[:, 1] - ends[:, 0]
        along = along / np.linalg.norm(along, axis=1, keepdims=True)
        away = self.vertices[self.triangles[sides // 3, (sides + 2) % 3]] - ends[:, 0]
        away = away - np.einsum("ei,ei->e", away, along)[:, None] * along
        first = away[starts][group]
        sine, cosine = (np.einsum("ei,ei->e", side, away) for side in (np.cross(along, first), first))
        angle = np.arctan2(sine, cosine) % (2 * np.pi)
        angle = np.where(angle > 2 * np.pi - _SAME_ANGLE, 0.0, angle)
        order = np.lexsort((angle, group))
        step = (np.diff(angle[order], prepend=0.0) > _SAME_ANGLE) | (np.diff(group[order], prepend=-1) != 0)
        covering = np.empty(len(order), dtype=np.int64)
        covering[order] = np.cumsum(step)
        forward = self._edges.forward.reshape(-1)[sides]
        order = np.lexsort((~forward, covering))
        count = np.bincount(group)[group]
        place = np.arange(len(order))
        following = starts[group] + (place - starts[group] + 1) % count
        ahead = forward[order]
        # Where they do not alternate, surfaces run through one another: nothing hangs together there.
        clear = np.bincount(group, weights=ahead == ahead[following])[group] == 0
        chosen = clear & ~ahead
        return np.stack([sides[order[place[chosen]]], sides[order[following[chosen]]]], axis=1)

    def oriented(self) -> tuple[TriangleMesh, int]:
        """Neighbours made to agree within each shell, closed shells made to face outwards.

        Returns:
            the mesh, and how many triangles had to be flipped. Of an open shell the fewer are flipped. A
            surface with one side only, such as a Möbius strip, stays inconsistent.
        """
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import breadth_first_order

        count = len(self.triangles)
        pairs, agree = self._neighbours()
        links = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(count, count)).tocsr()
        disagree = {(int(a), int(b)) for a, b in pairs[~agree]}
        disagree |= {(b, a) for a, b in disagree}
        flip = np.zeros(count, dtype=bool)
        groups = connected(count, pairs) if count else np.zeros(0, dtype=np.int64)
        order = np.argsort(groups, kind="stable")
        for piece in np.split(order, np.flatnonzero(np.diff(groups[order])) + 1) if count else []:
            if disagree:
                walk, before = breadth_first_order(links, int(piece[0]), directed=False)
                for triangle in walk[1:]:
                    flip[triangle] = flip[before[triangle]] ^ (
                        (int(before[triangle]), int(triangle)) in disagree
                    )
            shell = self.of(piece)
            turned = flip[piece]
            shell = TriangleMesh(
                shell.vertices, np.where(turned[:, None], shell.triangles[:, ::-1], shell.triangles)
            )
            inwards = shell.volume < 0 if shell.is_closed else 2 * np.count_nonzero(turned) > len(piece)
            if inwards:
                flip[piece] = ~flip[piece]
        triangles = np.where(flip[:, None], self.triangles[:, ::-1], self.triangles)
        return TriangleMesh(self.vertices, triangles), int(np.count_nonzero(flip))


def connected(count: int, pairs: Whole) -> Whole:
    """Group of each of `count` things, from 0 on, given pairs (e, 2) that belong together.

    Groups count up in the order of their first things. Each thing points at the head of its group, which is
    no later; the later one of two heads that a pair joins is put below the earlier, until no pair joins two.
    It takes as long as scipy does, without the quarter of a second in which that is loaded: a vessel's deck
    asks for it.
    """
    heads = np.arange(count)
    while True:
        first, other = heads[pairs[:, 0]], heads[pairs[:, 1]]
        if np.array_equal(first, other):
            return np.asarray(np.unique(heads, return_inverse=True)[1], dtype=np.int64)
        np.minimum.at(heads, np.maximum(first, other), np.minimum(first, other))
        while not np.array_equal(above := heads[heads], heads):
            heads = above
