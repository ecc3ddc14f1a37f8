"""A hollow body of a mirrored file, where all triangles face the wrong side.

Its outside was turned, and its cavity, which faced outwards, was taken for a solid within: a box with walls
of 0.1 m weighed six times as much as it does.
"""

from __future__ import annotations

import pytest

from gantline.cad.assumptions import Assumptions
from gantline.cad.bodies import parts_of_mesh
from gantline.cad.mesh import TriangleMesh
from solids import box

OUTER, INNER, CORE = (box((size, size, size)) for size in (2.0, 1.8, 1.0))
HOLLOW = [OUTER, INNER.flipped()]


@pytest.mark.parametrize(
    ("shells", "volumes"),
    [
        (HOLLOW, [8 - 1.8**3]),
        ([shell.flipped() for shell in HOLLOW], [8 - 1.8**3]),
        ([shell.flipped() for shell in [*HOLLOW, CORE]], [8 - 1.8**3, 1.0]),
        ([*HOLLOW, CORE, box((1, 1, 1), (5, 0, 0)).flipped()], [8 - 1.8**3, 1.0, 1.0]),
    ],
)
def test_cavities_are_turned_with_their_body(shells: list[TriangleMesh], volumes: list[float]) -> None:
    """Outer less inner, and what is loose within it by itself."""
    mesh = TriangleMesh.combined(shells)
    found = list(parts_of_mesh("tank", mesh, mesh.size, Assumptions(density=1000.0)))
    masses = sorted(part.properties.mass for part in found if part.properties is not None)
    assert masses == pytest.approx(sorted(1000 * volume for volume in volumes), rel=1e-12)
