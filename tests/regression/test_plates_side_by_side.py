"""A deck of plates side by side, each a closed box whose end faces cover those of its neighbours.

From five by five plates on more than a quarter of all triangles were the backs of others, which was taken
for a surface that is drawn from both sides: one of each pair went, and the deck had no weight.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.cad.assumptions import Assumptions
from gantline.cad.bodies import parts_of_mesh
from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from gantline.cad.model import Part
from solids import box

STEEL = 7850.0


def parts(mesh: TriangleMesh, thickness: float | None = None) -> list[Part]:
    return list(parts_of_mesh("deck", mesh, mesh.size, Assumptions(thickness=thickness)))


@pytest.mark.parametrize("counts", [(5, 5, 1), (12, 12, 1), (4, 4, 4)])
def test_bodies_side_by_side_stay_bodies(counts: tuple[int, int, int]) -> None:
    """Each weighs what it does; together they are the box around all, m (b² + c²)/12."""
    size = np.array([1.0, 2.0, 0.5])
    places = np.stack(np.meshgrid(*map(np.arange, counts), indexing="ij"), axis=-1).reshape(-1, 3)
    found = parts(TriangleMesh.combined([box((1.0, 2.0, 0.5), tuple(place * size)) for place in places]))
    assert len(found) == len(places) and not any(part.doubts for part in found)
    whole = MassProperties.combined(part.properties for part in found if part.properties is not None)
    lengths = np.array(counts) * size
    mass = STEEL * float(np.prod(lengths))
    assert whole.mass == pytest.approx(mass, rel=1e-12)
    second = np.diag(lengths**2) * mass / 12
    assert whole.inertia == pytest.approx(np.trace(second) * np.eye(3) - second, rel=1e-9, abs=1e-6 * mass)


def test_a_surface_from_both_sides_beside_bodies_counts_once() -> None:
    """Five walls of a box drawn from both sides, beside a solid: area times thickness, and the solid."""
    solid = box((1, 1, 1), (10, 0, 0))
    open_box = box((2, 2, 2)).of(np.arange(2, 12))
    found = parts(TriangleMesh.combined([solid, open_box, open_box.flipped()]), thickness=0.01)
    assert sum(part.properties.mass for part in found if part.properties) == pytest.approx(
        STEEL * (1 + 5 * 4 * 0.01), rel=1e-12
    )
    assert "10 triangles are there from both sides" in found[0].doubts[0]
