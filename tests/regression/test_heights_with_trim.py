"""Heights of buoyancy and metacentre of a hull with trim.

`gantline hydro --trim` says that heights are above z = 0. They were square to the water instead, from the
hull's origin at its stern: a box of 100 m with 2 deg by the stern had KB 3.617 m in place of 2.127 m and KM
22.378 m in place of 20.877 m, so that KM - KG was 1.5 m more than GM. The centre of gravity was taken at the
x of that of buoyancy, with which such a hull does not lie so: GM 12 mm too large.
"""

from __future__ import annotations

import math

import pytest

from gantline.hydro import Attitude, box_hull, float_free, hydrostatics, righting_arms

LENGTH, BREADTH, DEPTH, DRAFT, KG, DENSITY = 100.0, 30.0, 8.0, 4.0, 12.0, 1000.0  # m, kg/m^3
TRIM = math.radians(2.0)
SLOPE = math.tan(TRIM)
HULL = box_hull((LENGTH, BREADTH, DEPTH))
FOUND = hydrostatics(HULL, Attitude(DRAFT, 0.0, TRIM, LENGTH / 2), DENSITY)


def test_heights_are_above_the_keel() -> None:
    """z_B = T/2 + (L tan)²/24T; a metacentre is BM above B, square to the water: BM cos of it along z."""
    buoyancy = DRAFT / 2 + (LENGTH * SLOPE) ** 2 / (24 * DRAFT)
    assert FOUND.kb == pytest.approx(buoyancy, rel=1e-12)
    # I/V of a waterplane L/cos long
    transverse = BREADTH**2 / (12 * DRAFT) / math.cos(TRIM)
    longitudinal = LENGTH**2 / (12 * DRAFT) / math.cos(TRIM) ** 3
    assert FOUND.km_transverse == pytest.approx(buoyancy + transverse * math.cos(TRIM), rel=1e-12)
    assert FOUND.km_longitudinal == pytest.approx(buoyancy + longitudinal * math.cos(TRIM), rel=1e-12)


def test_with_the_centre_of_gravity_of_the_table_it_floats_so() -> None:
    """Its trim, its draft and GM; GM = (KM - KG)/cos, and it is the slope of the righting arm."""
    centre = FOUND.centre_of_gravity_at(KG)
    assert centre[2] == pytest.approx(KG, rel=1e-12)
    floating = float_free(HULL, FOUND.mass, centre, density=DENSITY)
    assert (floating.attitude.trim, floating.attitude.draft) == pytest.approx((TRIM, DRAFT), rel=1e-9)
    heights = FOUND.gm(centre)
    assert heights == pytest.approx(floating.gm, rel=1e-9)
    by_hand = [(km - KG) / math.cos(TRIM) for km in (FOUND.km_transverse, FOUND.km_longitudinal)]
    assert heights == pytest.approx(by_hand, rel=1e-12)
    step = math.radians(0.01)
    arm = righting_arms(HULL, FOUND.mass, centre, [step], density=DENSITY).arm[0]
    # GZ = GM cos(trim) phi for small heel about the vessel's own axis, which the trim has turned
    assert arm == pytest.approx(heights[0] * math.cos(TRIM) * step, rel=1e-4)
