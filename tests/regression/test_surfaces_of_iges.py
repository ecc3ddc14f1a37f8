"""Bodies of IGES, whose files mostly hold trimmed surfaces and no solids.

A plate with a round and a square hole weighed 7 % too much and had its centre of gravity 0.19 m aside,
without a doubt: a face of revolution, by the boundary that the file gives on the surface, came out with its
outside in. A cylinder had its centre 2 mm and its inertia 0.6 % off, since the integrals were refined until
the volume seemed to settle, and moments lag behind it. A box with a cavity weighed as two solids, ninety
times as much as it does. A sphere, which is one face, was an open surface without weight.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from gantline.cad import CadModel, PartKind, read
from gantline.cad.mass_properties import MassProperties
from occt_files import written

pytestmark = pytest.mark.usefixtures("occt_loaded")
STEEL = 7850.0
AT = np.array([153.2, -17.1, 22.4])


def model(folder: Path, body: str, name: str = "a.igs") -> CadModel:
    return read(written(folder / name, body), keep=False)


def a_box(
    sizes: tuple[float, float, float], corner: np.ndarray, sign: float = 1.0
) -> tuple[float, np.ndarray]:
    """Mass and second moment about the origin, both positive or negative."""
    mass = sign * STEEL * math.prod(sizes)
    middle = corner + np.array(sizes) / 2
    return mass, np.diag(np.square(sizes)) * mass / 12 + mass * np.outer(middle, middle)


def held_against(found: MassProperties, mass: float, centre: np.ndarray, inertia: np.ndarray) -> None:
    """Mass to 1e-7; centre to a micrometre; inertia to 5e-5, which faces of revolution lag behind by."""
    assert found.mass == pytest.approx(mass, rel=1e-7)
    assert found.centre == pytest.approx(centre, abs=1e-6)
    assert found.inertia == pytest.approx(inertia, abs=5e-5 * float(np.abs(inertia).max()))


def test_a_plate_with_holes(tmp_path: Path) -> None:
    """6 × 4 m, 20 mm thick; a hole of radius 0.6 m at (1, 1), one of 1 × 2 m from (3, 1) on."""
    corner = tuple((1000 * AT).tolist())
    hole = tuple((1000 * (AT + np.array([1, 1, -0.5]))).tolist())
    square = tuple((1000 * (AT + np.array([3, 1, -0.5]))).tolist())
    found = model(
        tmp_path,
        f"cut(box((6000, 4000, 20), {corner}), cylinder(600, 1000, {hole}),"
        f" box((1000, 2000, 1000), {square}))",
    )
    plate, cut = (6.0, 4.0, 0.02), (1.0, 2.0, 0.02)
    disc = -STEEL * math.pi * 0.6**2 * 0.02
    middle = np.array([1, 1, 0.01])
    own = disc * np.diag([0.6**2 / 4, 0.6**2 / 4, 0.02**2 / 12])
    pieces = [a_box(plate, np.zeros(3)), a_box(cut, np.array([3.0, 1, 0]), -1)]
    pieces += [(disc, own + disc * np.outer(middle, middle))]
    mass = sum(piece[0] for piece in pieces)
    first = pieces[0][0] * np.array([3, 2, 0.01]) + pieces[1][0] * np.array([3.5, 2, 0.01]) + disc * middle
    centre = first / mass
    second = sum(piece[1] for piece in pieces) - mass * np.outer(centre, centre)
    inertia = np.trace(second) * np.eye(3) - second
    held_against(found.properties, mass, AT + centre, inertia)
    assert found.doubts == () and found.parts[0].doubts == ()


def test_a_cylinder(tmp_path: Path) -> None:
    """m (3 r² + h²)/12 across, m r²/2 along."""
    found = model(tmp_path, "cylinder(500, 4000, (0, 0, 0))")
    mass = STEEL * math.pi * 0.25 * 4
    across = mass * (3 * 0.25 + 16) / 12
    held_against(found.properties, mass, np.array([0, 0, 2.0]), np.diag([across, across, mass * 0.125]))


def test_a_cavity_among_loose_faces(tmp_path: Path) -> None:
    """A box of 4 × 3 × 2 m with walls of 10 mm, and the doubt that says what was taken for granted."""
    found = model(tmp_path, "cut(box((4000, 3000, 2000), (0, 0, 0)), box((3980, 2980, 1980), (10, 10, 10)))")
    volume = 24 - 3.98 * 2.98 * 1.98
    assert len(found.parts) == 1
    assert found.properties.mass == pytest.approx(STEEL * volume, rel=1e-9)
    assert found.parts[0].doubts == ("1 closed surface within it: taken as what is hollow",)


def test_a_plate_that_stands_on_another(tmp_path: Path) -> None:
    """A tee of 4 × 3 m and 1 × 3 m, 20 mm thick, is two plates; joined over pieces of edges it was none."""
    found = model(
        tmp_path, "together(box((4000, 3000, 20), (0, 0, 0)), box((20, 3000, 1000), (2000, 0, 20)))"
    )
    masses = sorted(part.properties.mass for part in found.parts if part.properties)
    assert masses == pytest.approx([STEEL * 0.06, STEEL * 0.24], rel=1e-12)
    assert not any(part.doubts for part in found.parts)
    centre = (4 * np.array([2, 1.5, 0.01]) + np.array([2.01, 1.5, 0.52])) / 5
    assert found.properties.centre == pytest.approx(centre, abs=1e-12)


def test_plates_that_meet_in_a_corner(tmp_path: Path) -> None:
    """They have a whole edge in common, over which one was seen from inside: volumes were subtracted."""
    found = model(
        tmp_path, "together(box((4000, 3000, 20), (0, 0, 0)), box((20, 3000, 1000), (3980, 0, 20)))"
    )
    masses = sorted(part.properties.mass for part in found.parts if part.properties)
    assert masses == pytest.approx([STEEL * 0.06, STEEL * 0.24], rel=1e-12)
    assert found.doubts == () and not any(part.doubts for part in found.parts)


def test_a_sphere_is_one_face_and_closed(tmp_path: Path) -> None:
    """4/3 π r³, inertia 2/5 m r²."""
    found = model(tmp_path, f"sphere(1000, {tuple((1000 * AT).tolist())})")
    mass = STEEL * 4 / 3 * math.pi
    assert found.parts[0].kind is PartKind.SOLID
    held_against(found.properties, mass, AT, np.eye(3) * 0.4 * mass)


def test_a_solid_with_a_gap_is_a_surface(tmp_path: Path) -> None:
    """A STEP solid that lacks a face encloses nothing, so it has no weight, as an open mesh has none."""
    found = model(tmp_path, "without_a_face(box((2000, 3000, 4000), (5000, 6000, 7000)))", "a.step")
    assert found.without_weight == found.parts
    assert "its surface is open" in found.parts[0].doubts[0]
