"""A hull: a mesh that the water can cut."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from gantline import _core
from gantline.arguments import needed

__all__ = ["Closure", "Hull", "hull_of"]

Array = npt.NDArray[np.float64]
Triangles = npt.NDArray[np.int64]

#: Vertices closer than this share of the hull's size are one; files in single precision have 6e-8.
_WELD = 1e-6


@dataclass(frozen=True)
class Closure:
    """How far a mesh is closed.

    Attributes:
        boundary_edges: edges with one triangle only, of holes and gaps.
        boundary_length: of these together [m].
        lowest_boundary: z of the lowest of them [m]; infinite where there is none.
        turned_edges: edges whose two triangles disagree about what is outside.
        crowded_edges: edges of more than two triangles.
        unbalanced_area: sum of all triangles' areas as vectors (3,) [m^2].
        volume: inside [m^3]; holes count as closed by triangles between their edges and the middle of all of
            these: of a hull without a deck what is below the plane of its edge.
    """

    boundary_edges: int
    boundary_length: float
    lowest_boundary: float
    turned_edges: int
    crowded_edges: int
    unbalanced_area: Array
    volume: float

    @property
    def is_closed(self) -> bool:
        """True where every edge has two triangles that agree."""
        return self.boundary_edges + self.turned_edges + self.crowded_edges == 0

    def doubts(self) -> list[str]:
        """What is doubtful about the mesh, a sentence each."""
        found = []
        if self.boundary_edges:
            found.append(
                f"{self.boundary_edges} edges are open, {self.boundary_length:.3g} m together, "
                f"the lowest at z = {self.lowest_boundary:.3g} m; under water they displace nothing"
            )
        if self.turned_edges:
            found.append(f"at {self.turned_edges} edges neighbours disagree about what is outside")
        if self.crowded_edges:
            found.append(f"{self.crowded_edges} edges have more than two triangles")
        return found


class Hull:
    """A hull in vessel axes: x forward, y to port, z up from the keel.

    Args:
        name: What it is called.
        vertices: positions (n, 3) [m].
        triangles: three vertices each (m, 3), counter-clockwise seen from outside.
        doubts: What is doubtful about where they come from, a sentence each.

    Raises:
        ValueError: if these are no such arrays, a coordinate is not finite, a vertex does not exist, or
            nothing is enclosed.
    """

    def __init__(
        self, name: str, vertices: npt.ArrayLike, triangles: npt.ArrayLike, *, doubts: Sequence[str] = ()
    ) -> None:
        try:
            points = np.asarray(vertices, dtype=float).reshape(-1, 3)
            faces = np.asarray(triangles, dtype=np.int64).reshape(-1, 3)
        except (TypeError, ValueError):  # a text, say, or rows of other lengths
            shapes = "vertices are numbers [m] of the shape (n, 3), triangles whole numbers of (m, 3)"
            raise ValueError(f"{name}: its vertices and triangles are no mesh; {shapes}") from None
        if not (len(faces) and len(points)):
            raise ValueError(f"{name}: a hull needs vertices and triangles")
        size = float(np.linalg.norm(np.ptp(points, axis=0)))
        if not np.isfinite(size) or size == 0:
            raise ValueError(f"{name}: its coordinates enclose nothing")
        self.name = name
        self._doubts = list(doubts)
        self._core = _core.Hull(points, faces, _WELD * size)
        self.is_turned = self.closure.volume < 0
        if self.is_turned:
            self._core = _core.Hull(points, np.ascontiguousarray(faces[:, ::-1]), _WELD * size)
        if not self.closure.volume > 1e-9 * size**3:
            raise ValueError(f"{name}: its triangles enclose no volume")

    @property
    def closure(self) -> Closure:
        """How far it is closed."""
        return Closure(**self._core.closure())

    def doubts(self) -> list[str]:
        """What is doubtful about it, a sentence each."""
        turned = ["all its triangles face inwards; they have been turned round"] if self.is_turned else []
        return self._doubts + turned + self.closure.doubts()

    @property
    def mesh(self) -> tuple[Array, npt.NDArray[np.int64]]:
        """Vertices (n, 3) [m] and triangles (m, 3)."""
        vertices, triangles = self._core.mesh()
        return vertices, triangles.astype(np.int64)

    def __repr__(self) -> str:
        length, breadth, depth = self.box[1] - self.box[0]
        triangles = f"{len(self.mesh[1])} triangles"
        return f"<Hull {self.name!r}: {length:.4g} m by {breadth:.4g} m by {depth:.4g} m, {triangles}>"

    @property
    def box(self) -> Array:
        """Least and largest x, y, z (2, 3) [m]."""
        vertices, triangles = self.mesh
        used = vertices[triangles.reshape(-1)]
        return np.array([used.min(axis=0), used.max(axis=0)])

    def below(self, normal: npt.ArrayLike, height: float) -> dict[str, Any]:
        """What lies below h(x) = normal . x + height = 0, see `gantline._core.Hull`."""
        return self._core.below([float(part) for part in np.asarray(normal)], float(height))

    def surface(self, normal: npt.ArrayLike, height: float) -> dict[str, Any]:
        """The skin below that plane, see `gantline._core.Hull`."""
        return self._core.surface([float(part) for part in np.asarray(normal)], float(height))


def hull_of(value: Hull) -> Hull:
    """What is a hull, as it is; for functions that take one, which would end inside otherwise.

    Raises:
        TypeError: If it is none, such as its file.
    """
    return needed(value, Hull, "a hull", "gantline.hydro.read_hull reads the file of one")
