"""Loads from CAD on supports under their own underside: sloped, curved, and rolling."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gantline
from box_on_tops import STIFFNESS as STIFFNESS_OF_TOP
from box_on_tops import force, support, turn
from cad_loads import LEVEL, ROWS, assembled, cad_lift, convex, half_cylinder, prism
from gantline.assembly.loads.tops import Sides
from gantline.assembly.spatial import rotation_matrix
from gantline.cad.simplify import hull_sides
from hull_lift import G, shares_of_springs, simulated
from mechanics import adaptive, body, document, free

#: A side rises by 5°, less than the 11° up to which it bears in the middle of a top.
SLOPE = math.tan(math.radians(5.0))
WEDGE = prism([(-3.0, 0.0), (3.0, 6.0 * SLOPE), (3.0, 4.0), (-3.0, 4.0)], 16.0)
PLACES = np.array([(x, y) for x in ROWS for y in (-2.0, 2.0)])
#: Loads of 200 t, 490 kN or 4.9 mm on each of four supports.
WEIGHT, STIFFNESS = 200e3 * G, 100e6


def grid(*y: float, **words: Any) -> dict[str, Any]:
    return {"grid": {"x": [f"{x} m" for x in ROWS], "y": [f"{one} m" for one in y]}, **words}


def forces(recording: gantline.Recording) -> np.ndarray:
    """Force of every support at the start (support,) [N]."""
    names = [one.name for one in recording.rig.supports]
    return np.array([recording.column("contact_force", name)[0] for name in names])


def heavy(x: float, y: float, z: float) -> dict[str, Any]:
    return {"weight": {"calculated": "200 t"}, "centre_of_gravity": {"at": [f"{x} m", f"{y} m", f"{z} m"]}}


def test_supports_are_cut_to_a_sloped_underside(tmp_path: Path) -> None:
    """`to_load`: 1.5 m + (y + 3 m) tan 5°, the height of the underside over the middle of each top."""
    found = assembled(tmp_path, cad_lift(tmp_path, WEDGE, grid(-2.0, 2.0, height="to_load")))
    expected = LEVEL + (PLACES[:, 1] + 3.0) * SLOPE
    assert [one.support.height for one in found.under_load] == pytest.approx(expected, abs=1e-9)
    assert [pad["at"][2] for pad in found.document["supports"]] == pytest.approx(expected, abs=1e-9)
    assert [one.rise for one in found.under_load] == pytest.approx([SLOPE] * 4, abs=1e-9)


@pytest.mark.parametrize("lower", [(0, 0, 0, 0), (0, 3, 1, 0), (2, 0, 0, 12)])
def test_supports_share_the_weight_under_a_sloped_underside(tmp_path: Path, lower: tuple[int, ...]) -> None:
    """As under a level one (SU3): gaps in mm below the underside, not levels of tops, decide.

    As it sinks by z the load comes down on all alike, for their force is upright. It tilts by 12 mm in 12 m
    at most: what that moves of places, 4 m high, is 4 mm of 2 m.
    """
    heights = LEVEL + (PLACES[:, 1] + 3.0) * SLOPE - 1e-3 * np.array(lower)
    names = [f"{column}.{row}" for column in (1, 2) for row in (1, 2)]
    each = {name: {"height": f"{height:.9f} m"} for name, height in zip(names, heights, strict=True)}
    given = cad_lift(tmp_path, WEDGE, grid(-2.0, 2.0, height="1 m", each=each), **heavy(0.5, 0.4, 2.0))
    found = forces(simulated(tmp_path, {**given, "duration": "0.2 s"}))
    gaps = 1e-3 * np.array(lower, dtype=float)
    expected = shares_of_springs(PLACES, np.full(4, STIFFNESS), gaps, WEIGHT, np.array([0.5, 0.4]))
    assert found.sum() == pytest.approx(WEIGHT, rel=1e-9)
    assert found == pytest.approx(expected, abs=4e-3 * WEIGHT)


def test_a_half_cylinder_lies_on_two_rails_beside_its_keel(tmp_path: Path) -> None:
    """Rails at y = ±0.9 m under a radius of 5 m: R − √(R² − y²) above its lowest line, shares by levers.

    Its sides rise by 10.4° there and bear in the middle of the tops; strips are within 0.2 mm of the
    cylinder, 20 kN of a support.
    """
    radius, y = 5.0, 0.9
    given = cad_lift(
        tmp_path, half_cylinder(radius, 16.0), grid(-y, y, height="to_load"), **heavy(1.0, 0.1, 3.0)
    )
    under = assembled(tmp_path, given).under_load
    high = LEVEL + radius - math.sqrt(radius**2 - y**2)
    assert [one.support.height for one in under] == pytest.approx([high] * 4, abs=2e-4)
    found = forces(simulated(tmp_path, {**given, "duration": "0.2 s"}))
    places = np.array([(x, side) for x in ROWS for side in (-y, y)])
    expected = shares_of_springs(places, np.full(4, STIFFNESS), np.zeros(4), WEIGHT, np.array([1.0, 0.1]))
    assert found == pytest.approx(expected, abs=STIFFNESS * 2e-4)


def test_a_cylinder_rolls_on_tops_as_over_their_middle() -> None:
    """Two tops under the lowest line of a cylinder, sticking: it rolls, and turns over like a pendulum.

    While the side over the middle of a top is flatter than 11° the place stays there: the lowest line goes
    by −R θ along the top, what bears stays in its middle. With the centre of gravity h above the lowest line
    and R − h below the axis of the cylinder,

        V = m g (√(R² − (R θ)²) − (R − h) cos θ) = m g h (1 − R θ²/2 h + …), θ'' = m g h θ/(I + m h²).

    θ grows from 0.01 to 0.05 rad: squares of it are 0.3 %, and strips of 0.5° are 0.2 mm off the cylinder.
    """
    radius, above, mass, inertia, tilt = 5.0, 3.0, 20e3, 60e3, 0.01
    mesh = half_cylinder(radius, 16.0)
    sides = [(side - (0.0, 0.0, above)).tolist() for side in hull_sides(mesh, 1e-5).outlines]
    tops = [support(name, x, 0.0, friction=2.0, sides=sides) for name, x in (("aft", -6.0), ("fore", 6.0))]
    axis = np.array([0.0, -radius * tilt, math.sqrt(radius**2 - (radius * tilt) ** 2)])
    arm = (radius - above) * np.array([0.0, math.sin(tilt), -math.cos(tilt)])
    sunk = mass * 9.81 / (2 * tops[0]["stiffness"])
    joint = free(axis + arm - (0.0, 0.0, sunk), orientation=turn(0, tilt))
    load = body("box", joint, mass=mass, inertia=[inertia, 1e6, 1e6])
    done = adaptive(document([load], supports=tops), 1.5)
    found = 2.0 * np.arcsin(done.body("box", "body_orientation")[:, 1])
    rate = math.sqrt(mass * 9.81 * above / (inertia + mass * above**2))
    assert found == pytest.approx(tilt * np.cosh(rate * done.time), rel=0.01)
    assert done.energy_remainder < 1e-4


@pytest.mark.parametrize("seed", range(4))
def test_the_lift_file_and_the_core_see_a_load_bear_at_one_place(seed: int) -> None:
    """Pressed into a top by a few mm a body has k times that: its height by one is the depth of the other.

    Random convex bodies, turned any way, over random tops; those beside the body, or deeper than the half of
    a top, have nothing by either.
    """
    rng = np.random.default_rng(seed)
    cloud = convex(rng.normal(0.0, 1.0, (60, 3)) * rng.uniform(0.5, 3.0, 3))
    outlines = hull_sides(cloud, 0.0).outlines
    pressed = 0
    for _ in range(40):
        quaternion = rng.normal(size=4)
        quaternion /= np.linalg.norm(quaternion)
        angle = rng.uniform(0.0, 2 * np.pi)
        top = support(
            "top",
            *rng.uniform(-2.0, 2.0, 2).tolist(),
            half=rng.uniform(0.05, 0.5, 2).tolist(),
            along=[math.cos(angle), math.sin(angle), 0.0],
            sides=[side.tolist() for side in outlines],
        )
        turned = rotation_matrix(quaternion.tolist())
        bearing = Sides(tuple(side @ turned.T for side in outlines)).over(top)
        depth = rng.uniform(1e-3, 0.02)
        high = -depth - (0.0 if bearing is None else float(bearing.place[2]))
        load = body(
            "box", free((0.0, 0.0, high), orientation=quaternion.tolist()), mass=1e4, inertia=[1e4] * 3
        )
        done = adaptive(document([load], supports=[top]), 1e-3)
        assert force(done, "top")[0] == pytest.approx(0.0 if bearing is None else STIFFNESS_OF_TOP * depth)
        pressed += bearing is not None
    assert 10 < pressed < 40
