"""Mass, centre of gravity and inertia of bodies, shells and points, by exact integrals.

`docs/concepts/mass_properties.md` derives what stands here. A body enters by three integrals over its mass:
m, the first moment ∫ r dm, and the second moment S = ∫ r rᵀ dm about its centre of gravity, of which the
inertia is tr(S) E − S. Over simplices these integrals of polynomials are finite sums, so a mesh of flat
triangles has no error but that of rounding.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.cad.mesh import TriangleMesh

__all__ = ["MassProperties", "point_inertia"]

Array = npt.NDArray[np.float64]

#: Inertias may be this far from symmetric, and rotations from orthonormal, relative to their size.
_ROUNDING = 1e-9


@dataclass(frozen=True, eq=False, init=False)
class MassProperties:
    """Mass, centre of gravity and inertia of a body.

    Attributes:
        mass: mass, greater than zero [kg].
        centre: centre of gravity (3,) [m].
        inertia: about the centre of gravity (3, 3) [kg m^2]; products as off-diagonal terms, −∫ x y dm.

    Raises:
        ValueError: if a value is not finite, the mass not positive, or the inertia not that of a body:
            symmetric, and no principal value larger than the sum of the two others.
    """

    mass: float
    centre: Array
    inertia: Array

    def __init__(self, mass: float, centre: npt.ArrayLike, inertia: npt.ArrayLike) -> None:
        at, about = np.array(centre, dtype=float), np.array(inertia, dtype=float)
        if at.shape != (3,) or about.shape != (3, 3):
            raise ValueError(f"a centre (3,) and an inertia (3, 3) are needed, not {at.shape}, {about.shape}")
        if not (math.isfinite(mass) and np.isfinite(at).all() and np.isfinite(about).all()):
            raise ValueError("mass, centre of gravity and inertia must be finite numbers")
        if mass <= 0:
            raise ValueError(f"a mass of {mass:g} kg is not positive")
        size = float(np.abs(about).max())
        if float(np.abs(about - about.T).max()) > _ROUNDING * size:
            raise ValueError("the inertia is not symmetric")
        about = (about + about.T) / 2
        # S = tr(I)/2 E − I is a sum of squares, so it has no negative eigenvalue.
        second = np.trace(about) / 2 * np.eye(3) - about
        if float(np.linalg.eigvalsh(second)[0]) < -_ROUNDING * size:
            raise ValueError(
                "no body has this inertia: one principal value is larger than the two others together"
            )
        at.setflags(write=False)
        about.setflags(write=False)
        object.__setattr__(self, "mass", float(mass))
        object.__setattr__(self, "centre", at)
        object.__setattr__(self, "inertia", about)

    def moved(self, rotation: npt.ArrayLike, translation: npt.ArrayLike) -> MassProperties:
        """The same body turned by a matrix (3, 3) about the origin, then moved by (3,) [m].

        A rotation with determinant −1 mirrors the body.

        Raises:
            ValueError: if the rotation is not orthonormal.
        """
        turn = np.asarray(rotation, dtype=float)
        if turn.shape != (3, 3) or not np.allclose(turn @ turn.T, np.eye(3), rtol=0, atol=_ROUNDING):
            raise ValueError("a rotation is an orthonormal matrix (3, 3)")
        return MassProperties(
            self.mass, turn @ self.centre + np.asarray(translation, dtype=float), turn @ self.inertia @ turn.T
        )

    def scaled_to(self, mass: float) -> MassProperties:
        """The same body with another mass [kg], spread in the same way."""
        return MassProperties(mass, self.centre, self.inertia * (mass / self.mass))

    def about(self, point: npt.ArrayLike) -> Array:
        """Inertia about another point (3,) [m], axes unchanged: (3, 3) [kg m^2] (parallel axes)."""
        return self.inertia + point_inertia(self.mass, self.centre - np.asarray(point, dtype=float))

    @classmethod
    def combined(cls, bodies: Iterable[MassProperties]) -> MassProperties:
        """Several bodies joined rigidly.

        Raises:
            ValueError: if there is none.
        """
        parts = list(bodies)
        if not parts:
            raise ValueError("no body has mass, so there is no centre of gravity")
        mass = math.fsum(part.mass for part in parts)
        centre = (
            np.array([math.fsum(part.mass * part.centre[axis] for part in parts) for axis in range(3)]) / mass
        )
        inertia = np.sum([part.about(centre) for part in parts], axis=0)
        return cls(mass, centre, inertia)

    @classmethod
    def of_point(cls, mass: float, centre: npt.ArrayLike) -> MassProperties:
        """A point mass [kg] at a place (3,) [m]."""
        return cls(mass, centre, np.zeros((3, 3)))

    @classmethod
    def of_closed_mesh(cls, mesh: TriangleMesh, density: float) -> MassProperties:
        """A solid within a closed mesh, triangles anticlockwise seen from outside; density [kg/m^3].

        Tetrahedra from the middle of the mesh's box to each triangle, with their signs (divergence theorem).

        Raises:
            ValueError: if the mesh is open, its triangles do not agree on their sides, or face inwards.
        """
        if not mesh.is_closed:
            raise ValueError("the mesh is open, so it has no volume")
        if not mesh.is_consistent:
            raise ValueError("neighbouring triangles of the mesh do not agree on which side is inside")
        middle = mesh.middle
        corners = mesh.corners - middle
        volumes = np.linalg.det(corners) / 6
        if float(volumes.sum()) <= 0:
            raise ValueError("the triangles of the mesh face inwards")
        # A tetrahedron with one corner in the origin: ∫ r rᵀ dV = V/20 (Σ p pᵀ + s sᵀ) over the other three.
        return cls._of_simplices(middle, corners, density * volumes, 4)

    @classmethod
    def of_shell(
        cls,
        mesh: TriangleMesh,
        areal_mass: float | Array,
        thickness: float | Array = 0.0,
    ) -> MassProperties:
        """A shell of flat triangles with a mass per area [kg/m^2], for all or for each triangle (m,).

        Args:
            mesh: the middle surface.
            areal_mass: mass per area, density times thickness [kg/m^2].
            thickness: what the mass is spread over, half to each side [m]; 0 for an infinitely thin shell.
        """
        middle = mesh.middle
        corners = mesh.corners - middle
        masses = np.broadcast_to(areal_mass, mesh.areas.shape) * mesh.areas
        depth = np.broadcast_to(thickness, mesh.areas.shape)
        # Through its thickness a slab has m t²/12 along its normal.
        normals = mesh.normals
        across = np.einsum("m,mi,mj->ij", masses * depth**2 / 12, normals, normals)
        return cls._of_simplices(middle, corners, masses, 3, across)

    @classmethod
    def _of_simplices(
        cls, origin: Array, corners: Array, masses: Array, count: int, more: Array | float = 0.0
    ) -> MassProperties:
        """Simplices of `count` corners, of which three are given (m, 3, 3) and a fourth is the origin.

        With n = count: ∫ r dm = m s/n, ∫ r rᵀ dm = m (Σ p pᵀ + s sᵀ)/(n (n + 1)), s the sum of the corners.
        """
        mass = float(masses.sum())
        if not mass > 0:
            raise ValueError("the surface has no area or no mass")
        sums = corners.sum(axis=1)
        centre = masses @ sums / (count * mass)
        second = np.einsum("m,mci,mcj->ij", masses, corners, corners) + np.einsum(
            "m,mi,mj->ij", masses, sums, sums
        )
        second = second / (count * (count + 1)) + more - mass * np.outer(centre, centre)
        return cls(mass, origin + centre, np.trace(second) * np.eye(3) - second)


def point_inertia(mass: float, offset: Array) -> Array:
    """Inertia (3, 3) of a point mass at an offset [m] from the point of reference [kg m^2]."""
    return mass * (float(offset @ offset) * np.eye(3) - np.outer(offset, offset))
