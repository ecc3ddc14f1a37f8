"""Hydrostatics of hulls against closed forms: figures upright, at heel and trim, equilibria and righting
arms.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from gantline.hydro import (
    Attitude,
    CannotFloatError,
    Tank,
    box_hull,
    float_free,
    free_surface_correction,
    hydrostatics,
    raked_barge,
    righting_arms,
    wigley_hull,
)

LENGTH, BREADTH, DEPTH, DRAFT = 100.0, 30.0, 8.0, 4.0
BOX = box_hull((LENGTH, BREADTH, DEPTH))
MIDDLE = LENGTH / 2


def test_box_upright() -> None:
    """V = LBT, KB = T/2, BM = B²/12T and L²/12T, A = LB, S = LB + 2T(L + B); LCB and LCF amidships."""
    found = hydrostatics(BOX, Attitude(DRAFT, middle=MIDDLE))
    assert found.volume == pytest.approx(LENGTH * BREADTH * DRAFT, rel=1e-12)
    assert found.mass == pytest.approx(12.3e6, rel=1e-12)
    assert found.kb == pytest.approx(DRAFT / 2, rel=1e-12)
    assert found.bm_transverse == pytest.approx(BREADTH**2 / (12 * DRAFT), rel=1e-12)
    assert found.bm_longitudinal == pytest.approx(LENGTH**2 / (12 * DRAFT), rel=1e-12)
    assert (found.lcb, found.lcf) == pytest.approx((MIDDLE, MIDDLE), rel=1e-12)
    assert found.wetted_surface == pytest.approx(LENGTH * BREADTH + 2 * DRAFT * (LENGTH + BREADTH), rel=1e-12)
    assert found.waterline_size == pytest.approx([LENGTH, BREADTH], rel=1e-12)
    assert found.unbalanced < 1e-12
    assert found.gm([MIDDLE, 0, 5.0]) == pytest.approx((15.75, 2 + LENGTH**2 / 48 - 5), rel=1e-12)


@pytest.mark.parametrize(("heel", "trim"), [(0, 2.0), (0, -1.5), (9, 0), (-9, 0), (6, 1.2), (-4, -1.0)])
def test_box_heeled_and_trimmed(heel: float, trim: float) -> None:
    """With dry deck and wet bottom the volume is LB times the draft at the middle, the water's slopes a =
    n_x/n_z and b = n_y/n_z move B by −(a L², b B²)/12T and raise it by (a² L² + b² B²)/24T, and the
    waterplane has LB/n_z.
    """
    attitude = Attitude(DRAFT, math.radians(heel), math.radians(trim), MIDDLE)
    found = hydrostatics(BOX, attitude)
    n = attitude.normal
    a, b = n[0] / n[2], n[1] / n[2]
    shifted = np.array([MIDDLE - a * LENGTH**2 / (12 * DRAFT), -b * BREADTH**2 / (12 * DRAFT)])
    raised = DRAFT / 2 + ((a * LENGTH) ** 2 + (b * BREADTH) ** 2) / (24 * DRAFT)
    assert found.volume == pytest.approx(LENGTH * BREADTH * DRAFT, rel=1e-12)
    assert found.centre_of_buoyancy == pytest.approx([*shifted, raised], rel=1e-11, abs=1e-11)
    assert found.waterplane_area == pytest.approx(LENGTH * BREADTH / n[2], rel=1e-12)
    assert attitude.draft_at(0.0) == pytest.approx(DRAFT + a * MIDDLE, rel=1e-12)
    starboard_is_down = heel > 0
    assert (found.centre_of_buoyancy[1] < 0) == starboard_is_down or heel == 0


def test_righting_arms_of_a_box() -> None:
    """GZ = sin φ (GM + BM tan² φ/2) while the deck is dry (wall-sided formula); the section by hand beyond
    that.
    """
    kg, mass = 5.0, 12.3e6
    angles = np.radians([0.0, 3.0, 8.0, 14.0, -8.0])
    found = righting_arms(BOX, mass, [MIDDLE, 0, kg], angles)
    bm = BREADTH**2 / (12 * DRAFT)
    wanted = np.sin(angles) * (DRAFT / 2 + bm - kg + bm / 2 * np.tan(angles) ** 2)
    assert found.arm == pytest.approx(wanted, rel=1e-9, abs=1e-11)
    assert np.abs(found.trim).max() < 1e-10
    # Free surfaces raise G by their correction: GZ is less by that times sin φ.
    loose = righting_arms(BOX, mass, [MIDDLE, 0, kg], angles, correction=0.4)
    assert found.arm - loose.arm == pytest.approx(0.4 * np.sin(angles), abs=1e-9)
    # On its side: half of its breadth under water, B 4 m above the keel and G 5 m, both on the vertical's
    # other side.
    upended = righting_arms(BOX, mass, [MIDDLE, 0, kg], [math.pi / 2])
    assert upended.arm == pytest.approx([DEPTH / 2 - kg], abs=1e-9)
    # At 30° bottom and deck are cut: a rectangle of T and B has its corners 7.5 m and more from the water's
    # end.
    heel = math.radians(30)
    half = DRAFT / math.tan(heel) if DRAFT / math.tan(heel) < BREADTH / 2 else BREADTH / 2
    assert half < BREADTH / 2, "bottom and deck both meet the water"
    # Half as deep as the box, symmetric about its middle: a parallelogram, left of y = ±4 cot 30° about the
    # middle.
    slant = DEPTH / math.tan(heel)
    area = BREADTH / 2 * DEPTH
    left, right = -BREADTH / 2, -slant / 2  # deck side wet from the side to `right`, bottom to −`right`
    rectangle, triangle = (right - left) * DEPTH, slant * DEPTH / 2
    y = (rectangle * (left + right) / 2 + triangle * (right + slant / 3)) / area
    z = (rectangle * DEPTH / 2 + triangle * DEPTH / 3) / area
    arm = (0 - y) * math.cos(heel) + (z - kg) * math.sin(heel)
    assert righting_arms(BOX, mass, [MIDDLE, 0, kg], [heel]).arm == pytest.approx([arm], abs=1e-9)


def test_righting_arm_is_the_slope_of_the_energy_over_heel() -> None:
    """A raked barge, free to trim: the work over its weight that heeling takes, ∫ GZ cos τ dφ
    since it heels about its own trimmed axis, is what the depth of B and the height of G gain.
    """
    barge = raked_barge((LENGTH, BREADTH, DEPTH), 15.0, 3.0)
    mass, centre = 9e6, [48.0, 0, 6.0]
    angles = np.radians(np.linspace(0, 40, 801))
    arms = righting_arms(barge, mass, centre, angles)

    def height(index: int) -> float:
        angle, trim = angles[index], arms.trim[index]
        attitude = Attitude(0.0, angle, trim)
        low, high = -20.0, 20.0
        for _ in range(80):  # the height at which it displaces its weight, by halving
            middle = (low + high) / 2
            volume = barge.below(attitude.normal, middle)["volume"]
            low, high = (middle, high) if volume > mass / 1025 else (low, middle)
        below = barge.below(attitude.normal, middle)
        return float(attitude.normal @ centre + middle + below["depth_moment"] * 1025 / mass)

    # Simpson's rule over steps of 0.05°, with kinks where edges meet the water: h² times their change of
    # slope.
    h = angles[1] - angles[0]
    arm = arms.arm * np.cos(arms.trim)
    area = h / 3 * (arm[0] + arm[-1] + 4 * arm[1::2].sum() + 2 * arm[2:-1:2].sum())
    assert area == pytest.approx(height(800) - height(0), rel=1e-5)


def test_box_with_its_weight_off_centre_floats_where_statics_says() -> None:
    """Trim alone: t (GM + BM t²/2) = x_G with t = tan θ, as for the barge with a load ahead of its bow."""
    mass = 13.3e6
    x = 65e6 / mass * 1.0
    kg = (12.3e6 * 5 + 60e6) / mass
    found = float_free(BOX, mass, [MIDDLE + x, 0, kg])
    draft = mass / 1025 / (LENGTH * BREADTH)
    bm = LENGTH**2 / (12 * draft)
    (tangent,) = (
        root.real for root in np.roots([bm / 2, 0, draft / 2 + bm - kg, -x]) if abs(root.imag) < 1e-9
    )
    assert math.tan(-found.attitude.trim) == pytest.approx(tangent, rel=1e-9)
    assert found.attitude.draft == pytest.approx(draft, rel=1e-10)
    assert found.attitude.heel == pytest.approx(0, abs=1e-10)
    assert found.is_stable


def test_equilibrium_at_large_angles_has_g_above_b() -> None:
    """In equilibrium B is plumb below G and the displacement is the weight, whatever the hull and the
    angle; a box with G far up turns over, and its rest upside down has GM > 0.
    """
    barge = raked_barge((60.0, 20.0, 6.0), 8.0, 2.0)
    for centre, mass in (((31.0, 1.5, 4.0), 2.5e6), ((24.0, -3.0, 2.0), 3e6), ((30.0, 0.02, 25.0), 2e6)):
        found = float_free(barge, mass, centre, start=Attitude(2.0, -0.1, 0.0, 30.0))
        lever = np.asarray(centre) - found.hydrostatics.centre_of_buoyancy
        n = found.attitude.normal
        assert found.hydrostatics.mass == pytest.approx(mass, rel=1e-10)
        assert np.linalg.norm(lever - n * (n @ lever)) < 1e-8
        assert found.is_stable
    assert abs(found.attitude.heel) > math.radians(60), "G 25 m up cannot stay there"


def test_wigley_hull() -> None:
    """V = 4/9 LBT, A = 2/3 LB, KB = 5/8 T, and I_T = ∫ 2y³/3 dx = 4/105 · … of the parabola: LB³ · 4/105;
    extrapolated from three meshes, errors go by the squares of the panels.
    """
    length, breadth, draft = 100.0, 10.0, 6.25

    def figures(count: int) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
        hull = wigley_hull(length, breadth, draft, 4.0, 2 * count, count)
        assert hull.closure.is_closed
        found = hydrostatics(hull, Attitude(draft, middle=length / 2))
        return np.array([found.volume, found.waterplane_area, found.kb, found.second_transverse])

    rows = [figures(count) for count in (8, 16, 32, 64)]
    for order in range(1, 4):
        rows = [(4**order * fine - coarse) / (4**order - 1) for coarse, fine in pairwise(rows)]
    wanted = [4 / 9 * length * breadth * draft, 2 / 3 * length * breadth, 5 / 8 * draft]
    second = length * breadth**3 * 4 / 105
    assert rows[0] == pytest.approx([*wanted, second], rel=1e-9)


def test_free_surface_of_tanks() -> None:
    """ρ l b³/12 over the displacement: eight slack tanks of 26.4 × 11.5 m take 1.25 m from GM and 6.6 m
    lengthways at 21 908 t.
    """
    tanks = [Tank(26.4, 11.5)] * 8
    transverse, longitudinal = free_surface_correction(tanks, 21.908e6)
    assert (transverse, longitudinal) == pytest.approx((1.25, 6.6), abs=0.05)
    assert transverse == pytest.approx(8 * 1025 * 26.4 * 11.5**3 / 12 / 21.908e6, rel=1e-12)


def test_too_heavy_a_hull_does_not_float() -> None:
    """A box of 24 000 m³ carries no more than 24 600 t."""
    with pytest.raises(CannotFloatError, match=r"25000 t displace .* 24000 m³"):
        float_free(BOX, 25e6, [MIDDLE, 0, 4])
