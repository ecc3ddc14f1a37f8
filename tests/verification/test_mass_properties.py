"""Mass properties against closed forms: exact where faces are flat, converging where they are not."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from gantline.cad.mass_properties import MassProperties
from gantline.cad.mesh import TriangleMesh
from solids import box, plate_with_hole, sphere, surface_with_hole

STEEL = 7850.0
#: Rounding of sums over some dozen triangles, a thousand times over; the requirement is 1e-10.
EXACT = 1e-12
SQUARE = np.array([(1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1)], dtype=float)


def box_inertia(mass: float, x: float, y: float, z: float) -> np.ndarray:
    """Of a homogeneous box: m/12 (y² + z²) and so on."""
    return np.diag([y * y + z * z, x * x + z * z, x * x + y * y]) * mass / 12


def assert_same(
    found: MassProperties, mass: float, centre: object, inertia: np.ndarray, within: float = EXACT
) -> None:
    size = float(np.abs(inertia).max())
    assert found.mass == pytest.approx(mass, rel=within)
    assert found.centre == pytest.approx(np.asarray(centre, dtype=float), rel=within, abs=within)
    assert found.inertia == pytest.approx(inertia, rel=within, abs=within * size)


def test_a_box() -> None:
    """m/12 (b² + c²), wherever the box is."""
    mass = STEEL * 2 * 3 * 5
    found = MassProperties.of_closed_mesh(box((2, 3, 5), middle=(10, -20, 30)), STEEL)
    assert_same(found, mass, (10, -20, 30), box_inertia(mass, 2, 3, 5))


def test_a_box_far_from_the_origin_loses_nothing() -> None:
    """Ship coordinates in millimetres from a far datum: integrals start from the body's own middle."""
    mass = STEEL * 0.01 * 3 * 2
    found = MassProperties.of_closed_mesh(box((0.01, 3, 2), middle=(4096, 2048, 8192)), STEEL)
    # The plate's thickness itself is rounded to 8192 · 2⁻⁵² of 0.01 m there: 1e-10 relative.
    assert_same(found, mass, (4096, 2048, 8192), box_inertia(mass, 0.01, 3, 2), within=2e-10)


def test_a_hollow_box_is_the_outer_less_the_inner() -> None:
    """Closed forms of both boxes, joined by parallel axes."""
    hollow = TriangleMesh.combined([box((4, 3, 2)), box((3.9, 2.8, 1.7), middle=(0.01, 0, 0.02)).flipped()])
    outer, inner = 4 * 3 * 2, 3.9 * 2.8 * 1.7
    mass = outer - inner
    centre = -np.array([0.01, 0, 0.02]) * inner / mass
    offset = np.array([0.01, 0, 0.02])
    second_axis = float(offset @ offset) * np.eye(3) - np.outer(offset, offset)
    own_axis = float(centre @ centre) * np.eye(3) - np.outer(centre, centre)
    about_origin = box_inertia(outer, 4, 3, 2) - box_inertia(inner, 3.9, 2.8, 1.7) - inner * second_axis
    assert_same(MassProperties.of_closed_mesh(hollow, 1.0), mass, centre, about_origin - mass * own_axis)


def test_a_plate_with_a_square_hole() -> None:
    """Closed form of the plate less that of the hole."""
    thickness = 0.02
    found = MassProperties.of_closed_mesh(plate_with_hole(2 * SQUARE, 0.5 * SQUARE, thickness), STEEL)
    outer, inner = STEEL * 16 * thickness, STEEL * 1 * thickness
    inertia = box_inertia(outer, 4, 4, thickness) - box_inertia(inner, 1, 1, thickness)
    assert_same(found, outer - inner, (0, 0, 0), inertia)


def test_a_shell_with_thickness_is_the_plate() -> None:
    """Flat plates: the prism over a surface has m t²/12 more along its normal, which is exact."""
    outline = 2 * SQUARE
    hole = 0.5 * SQUARE + (0.3, -0.4)
    solid = MassProperties.of_closed_mesh(plate_with_hole(outline, hole, 0.05), STEEL)
    shell = MassProperties.of_shell(surface_with_hole(outline, hole), STEEL * 0.05, thickness=0.05)
    assert_same(shell, solid.mass, solid.centre, solid.inertia)


def test_a_thin_shell_has_no_inertia_of_its_thickness() -> None:
    """Izz = Ixx + Iyy of a flat sheet."""
    shell = MassProperties.of_shell(surface_with_hole(SQUARE, 0.5 * SQUARE), 10.0)
    # Square frame 2 × 2 less 1 × 1 of 10 kg/m²: Ixx = (40·4 − 10·1)/12, Izz the sum of both.
    assert_same(shell, 30, (0, 0, 0), np.diag([12.5, 12.5, 25.0]))


def test_shells_of_unlike_plates() -> None:
    """Mass per area and thickness of each triangle; the heavy half by its area."""
    mesh = surface_with_hole(SQUARE, 0.5 * SQUARE)
    heavy = np.where(mesh.corners[:, :, 0].mean(axis=1) > 0, 20.0, 10.0)
    found = MassProperties.of_shell(mesh, heavy, thickness=heavy / STEEL)
    assert found.mass == pytest.approx(45.0, rel=EXACT)  # each half has 1.5 m²
    assert found.centre[0] > 0


def test_a_round_hole_converges() -> None:
    """A polygon of n sides lacks area by its second order: errors fall by four when n doubles."""
    errors = []
    for count in (64, 128, 256):
        angle = 2 * np.pi * np.arange(count) / count
        circle = np.column_stack([np.cos(angle), np.sin(angle)])
        mesh = plate_with_hole(2 * circle, 0.5 * circle, 0.02)
        found = MassProperties.of_closed_mesh(mesh, STEEL)
        mass = STEEL * 0.02 * math.pi * (4 - 0.25)
        polar = mass * (4 + 0.25) / 2  # m (R² + r²)/2
        errors.append([found.mass / mass - 1, found.inertia[2, 2] / polar - 1])
    ratios = np.array(errors[:-1]) / np.array(errors[1:])
    assert np.allclose(ratios, 4.0, atol=0.02)
    assert np.abs(errors[-1]).max() < 3e-4  # 2 π²/(3 · 256²) and twice that


def test_a_sphere_converges() -> None:
    """Solid 2/5 m r²; inscribed triangles: second order."""
    errors = []
    for divisions in (8, 16, 32):
        found = MassProperties.of_closed_mesh(sphere(2.0, divisions), STEEL)
        mass = STEEL * 4 / 3 * math.pi * 8
        assert found.centre == pytest.approx(np.zeros(3), abs=1e-12)
        errors.append([found.mass / mass - 1, found.inertia[0, 0] / (0.4 * mass * 4) - 1])
    ratios = np.array(errors[:-1]) / np.array(errors[1:])
    assert np.allclose(ratios, 4.0, atol=0.1)
    assert np.abs(errors[-1]).max() < 1e-2


def test_a_hollow_sphere_as_a_shell_converges() -> None:
    """Thin spherical shell: 2/3 m r²."""
    error = []
    for divisions in (8, 16):
        found = MassProperties.of_shell(sphere(2.0, divisions), 10.0)
        error.append(found.inertia[1, 1] / (2 / 3 * 10 * 4 * math.pi * 4 * 4) - 1)
    assert error[0] / error[1] == pytest.approx(4.0, abs=0.2)


def orthonormal(matrix: np.ndarray) -> np.ndarray:
    turn, _ = np.linalg.qr(matrix + 3 * np.eye(3))
    return np.asarray(turn)


lengths = st.floats(0.01, 20.0)
places = arrays.arrays(float, 3, elements=st.floats(-50, 50))
turns = arrays.arrays(float, (3, 3), elements=st.floats(-1, 1)).map(orthonormal)
sizes = st.tuples(lengths, lengths, lengths)


@given(sizes, turns, places)
def test_moving_the_mesh_is_moving_its_properties(
    lengths: tuple[float, float, float], turn: np.ndarray, at: np.ndarray
) -> None:
    """Rotation, mirrors and shifts, for solids and shells."""
    mesh = box(lengths, middle=(1, 2, 3))
    ways: tuple[Callable[[TriangleMesh], MassProperties], ...] = (
        lambda body: MassProperties.of_closed_mesh(body, STEEL),
        lambda body: MassProperties.of_shell(body, 80.0, thickness=0.01),
    )
    for made in ways:
        expected = made(mesh).moved(turn, at)
        # Coordinates to 100 m are rounded to 1e-14 m, the thinnest box is 0.01 m: 1e-11 of its size at worst.
        assert_same(
            made(mesh.moved(turn, at)), expected.mass, expected.centre, expected.inertia, within=1e-10
        )


@given(sizes, st.floats(0.05, 0.95), places)
def test_two_halves_make_the_whole(lengths: tuple[float, float, float], cut: float, at: np.ndarray) -> None:
    """Parallel axes: a box cut in two, each half by its closed form, and a half's half by its mesh."""
    x, y, z = lengths
    halves = [(cut * x, (cut - 1) / 2 * x), ((1 - cut) * x, cut / 2 * x)]
    parts = [
        MassProperties(w * y * z, at + np.array([m, 0, 0]), box_inertia(w * y * z, w, y, z))
        for w, m in halves
    ]
    found = MassProperties.combined(parts)
    # Two thin slices far away: what is left of positions to 50 m, rounded to 7e-15 m.
    assert_same(found, x * y * z, at, box_inertia(x * y * z, x, y, z), within=1e-10)


@given(sizes, places)
def test_parallel_axes(lengths: tuple[float, float, float], at: np.ndarray) -> None:
    """About a point that is moved away and back, and by Steiner's term written out."""
    body = MassProperties.of_closed_mesh(box(lengths), STEEL)
    x, y, z = at
    steiner = np.array(
        [[y * y + z * z, -x * y, -x * z], [-x * y, x * x + z * z, -y * z], [-x * z, -y * z, x * x + y * y]]
    )
    expected = body.inertia + body.mass * steiner
    assert body.about(at) == pytest.approx(expected, rel=1e-12, abs=1e-12 * float(np.abs(expected).max()))


def test_scaling_keeps_the_radii_of_gyration() -> None:
    """A box of another mass."""
    body = MassProperties.of_closed_mesh(box((2, 3, 5), middle=(1, 1, 1)), STEEL)
    scaled = body.scaled_to(1000.0)
    assert_same(scaled, 1000.0, (1, 1, 1), box_inertia(1000.0, 2, 3, 5))


def test_the_goliath_load_by_hand() -> None:
    """Steel 300 t as a solid box 43 × 23 × 11 m at 5.1 m, outfitting 30 t and 20 t: by pencil, in t and m.

    Centre: x = (−16·30 − 11·20)/350 = −2, y = (4·30 − 6·20)/350 = 0, z = (5.1·300 + 3·50)/350 = 4.8.
    Ixx = 25(23² + 11²) + 300·0.09 + 30(16 + 3.24) + 20(36 + 3.24) = 16250 + 27 + 577.2 + 784.8 = 17639.
    """
    steel = MassProperties(300.0, np.array([0, 0, 5.1]), box_inertia(300.0, 43, 23, 11))
    outfitting = [
        MassProperties.of_point(30.0, np.array([-16, 4, 3])),
        MassProperties.of_point(20.0, np.array([-11, -6, 3])),
    ]
    whole = MassProperties.combined([steel, *outfitting])
    assert whole.mass == 350.0
    assert whole.centre == pytest.approx([-2.0, 0.0, 4.8], abs=1e-14)
    assert whole.inertia[0, 0] == pytest.approx(17639.0, abs=1e-9)
    # Iyy = 25(43² + 11²) + 300(4 + 0.09) + 30(196 + 3.24) + 20(81 + 3.24) = 49250 + 1227 + 5977.2 + 1684.8
    assert whole.inertia[1, 1] == pytest.approx(58139.0, abs=1e-9)
    # Izz = 25(43² + 23²) + 300·4 + 30(196 + 16) + 20(81 + 36) = 59450 + 1200 + 6360 + 2340
    assert whole.inertia[2, 2] == pytest.approx(69350.0, abs=1e-9)
    # Ixy = −Σ m x y = −(30·(−14)·4 + 20·(−9)·(−6)) = 600; Ixz = −(300·2·0.3 + 30·14·1.8 + 20·9·1.8) = −1260
    assert whole.inertia[0, 1] == pytest.approx(600.0, abs=1e-9)
    assert whole.inertia[0, 2] == pytest.approx(-1260.0, abs=1e-9)


def test_what_is_no_body_is_refused() -> None:
    """A principal value of an inertia is at most the sum of the two others."""
    opened = box((1, 1, 1))
    opened = opened.of(np.arange(11))
    with pytest.raises(ValueError, match="open"):
        MassProperties.of_closed_mesh(opened, STEEL)
    with pytest.raises(ValueError, match="face inwards"):
        MassProperties.of_closed_mesh(box((1, 1, 1)).flipped(), STEEL)
    one = box((1, 1, 1))
    mixed = np.vstack([one.triangles[:1, ::-1], one.triangles[1:]])
    with pytest.raises(ValueError, match="do not agree"):
        MassProperties.of_closed_mesh(TriangleMesh(one.vertices, mixed), STEEL)
    with pytest.raises(ValueError, match="no body has mass"):
        MassProperties.combined([])
    with pytest.raises(ValueError, match="not positive"):
        MassProperties.of_point(0.0, np.zeros(3))
    with pytest.raises(ValueError, match="no body has this inertia"):
        MassProperties(1.0, np.zeros(3), np.diag([1.0, 1.0, 3.0]))
    with pytest.raises(ValueError, match="not symmetric"):
        MassProperties(1.0, np.zeros(3), np.eye(3) + np.array([[0, 1, 0], [0, 0, 0], [0, 0, 0]]))
    with pytest.raises(ValueError, match="finite"):
        MassProperties(1.0, np.array([0, 0, np.nan]), np.eye(3))
    with pytest.raises(ValueError, match="orthonormal"):
        MassProperties.of_point(1.0, np.zeros(3)).moved(2 * np.eye(3), np.zeros(3))
