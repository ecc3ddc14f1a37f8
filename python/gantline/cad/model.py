"""What every CAD format is read into: parts with mass, centre of gravity and inertia, and their doubts."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np
import numpy.typing as npt

from gantline.cad.errors import CadError
from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh

__all__ = ["CadModel", "Comparison", "DeclaredWeight", "Part", "PartKind"]

Array = npt.NDArray[np.float64]


class PartKind(StrEnum):
    """Kinds of parts, as a yard's weight list has them; files of plain geometry have solids and shells."""

    PLATE = "plate"
    STIFFENER = "stiffener"
    BRACKET = "bracket"
    PILLAR = "pillar"
    EDGE_REINFORCEMENT = "edge reinforcement"
    SOLID = "solid"
    SHELL = "shell"


@dataclass(frozen=True, eq=False)
class DeclaredWeight:
    """What the file itself says that a part weighs.

    Attributes:
        mass: [kg].
        centre: centre of gravity (3,) [m]; None if the file does not say it.
    """

    mass: float
    centre: Array | None = None


@dataclass(frozen=True, eq=False)
class Part:
    """One part of a model, in the axes of the file, lengths in metres.

    Attributes:
        name: as in the file; not necessarily unique.
        kind: what it is.
        properties: mass, centre of gravity and inertia from its geometry; None if they cannot be computed.
        declared: what the file says that it weighs; None if it says nothing.
        mesh: triangles to draw it and to touch it with; may have none.
        material: name of the material; empty if none is named.
        size: thickness or section as text, such as ``10 mm`` or ``HP200X10``; empty if there is none.
        group: name of what it is part of, such as a panel; empty if it stands alone.
        doubts: what is not certain of it, a plain sentence each.
    """

    name: str
    kind: PartKind
    properties: MassProperties | None
    declared: DeclaredWeight | None
    mesh: TriangleMesh
    material: str = ""
    size: str = ""
    group: str = ""
    doubts: tuple[str, ...] = ()

    @property
    def counted(self) -> MassProperties | None:
        """What the part weighs in a sum: its geometry if that is known, else its declared weight as a point.

        A declared weight without a centre of gravity acts in the middle of the part's mesh.
        """
        if self.properties is not None or self.declared is None or self.declared.mass <= 0:
            return self.properties
        if self.declared.centre is not None:
            return MassProperties.of_point(self.declared.mass, self.declared.centre)
        if not len(self.mesh.triangles):
            return None
        return MassProperties.of_point(self.declared.mass, self.mesh.middle)


@dataclass(frozen=True)
class Comparison:
    """Masses from geometry against declared ones, over the parts that have both.

    Attributes:
        computed: sum from geometry [kg].
        declared: sum as declared [kg].
        worst: the part whose masses are furthest apart [kg]; None if no part has both.
    """

    computed: float
    declared: float
    worst: Part | None

    @property
    def difference(self) -> float:
        """(computed − declared)/declared [1]; 0 where nothing is declared."""
        return (self.computed - self.declared) / self.declared if self.declared else 0.0


@dataclass(frozen=True, eq=False)
class CadModel:
    """Parts of one CAD file.

    Attributes:
        name: what the file calls it, or the file's name.
        form: format with version and the program that wrote it, such as ``OCX 3.1.0, NAPA Steel``.
        parts: in the order of the file.
        unit: unit of length in the file and how it is known, such as ``mm, as the file says``.
        doubts: what is not certain of the whole, a plain sentence each.
    """

    name: str
    form: str
    parts: tuple[Part, ...]
    unit: str
    doubts: tuple[str, ...] = field(default=())

    @property
    def properties(self) -> MassProperties:
        """All parts joined rigidly, each with `Part.counted`.

        Raises:
            CadError: if no part has a mass.
        """
        bodies = [body for part in self.parts if (body := part.counted) is not None]
        if not bodies:
            why = next((f" ({part.doubts[-1]})" for part in self.parts if part.doubts), "")
            hint = "; open surfaces need a plate thickness" if self.of_kind(PartKind.SHELL) else ""
            raise CadError(f"{self.name}: no part has a mass, so there is no centre of gravity{why}{hint}")
        return MassProperties.combined(bodies)

    @property
    def mesh(self) -> TriangleMesh:
        """Meshes of all parts, one after another; nothing is welded."""
        return TriangleMesh.combined([part.mesh for part in self.parts])

    @property
    def box(self) -> Array:
        """Least and largest x, y, z of all parts (2, 3) [m].

        Raises:
            CadError: if no part has geometry.
        """
        mesh = self.mesh
        if not len(mesh.triangles):
            raise CadError(f"{self.name}: no part has geometry that can be drawn")
        return mesh.box

    def of_kind(self, kind: PartKind) -> tuple[Part, ...]:
        """Parts of one kind."""
        return tuple(part for part in self.parts if part.kind is kind)

    @property
    def kinds(self) -> Iterator[tuple[PartKind, tuple[Part, ...]]]:
        """Kinds that there are, each with its parts."""
        for kind in PartKind:
            if parts := self.of_kind(kind):
                yield kind, parts

    @property
    def without_weight(self) -> tuple[Part, ...]:
        """Parts that weigh nothing in the sum: neither geometry nor file says what they weigh."""
        return tuple(part for part in self.parts if part.counted is None)

    def compared(self, kind: PartKind | None = None) -> Comparison:
        """Masses from geometry against declared ones, of all parts or of one kind."""
        pairs = [
            (part, part.properties.mass, part.declared.mass)
            for part in (self.parts if kind is None else self.of_kind(kind))
            if part.properties is not None and part.declared is not None
        ]
        worst = max(pairs, key=lambda pair: abs(pair[1] - pair[2]), default=(None, 0.0, 0.0))[0]
        return Comparison(
            computed=sum(computed for _, computed, _ in pairs),
            declared=sum(declared for _, _, declared in pairs),
            worst=worst,
        )
