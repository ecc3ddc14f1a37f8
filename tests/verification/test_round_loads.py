"""Round loads: mass, buoyancy, how they lie, stand, roll, and keep clear, against closed forms."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import gantline
from gantline.assembly.loads import round_body
from gantline.assembly.loads.cells import lattices
from gantline.cad.mass_properties import MassProperties
from gantline.scenario.loads.cylinder import Cylinder, segment_area, segment_moment
from gantline.scenario.loads.in_water import InWater
from gantline.scenario.loads.load import Load
from hull_lift import G, shares_of_springs
from in_water import RHO, share
from round_lift import assembled, round_lift, simulated

D, R, L = 5.0, 2.5, 20.0
LYING, STANDING = {"diameter": "5 m", "length": "20 m"}, {"diameter": "5 m", "length": "20 m", "along": "z"}
MASS, WEIGHT = 200e3, 200e3 * G


def cylinder(**given: Any) -> Cylinder:
    return Cylinder.model_validate({"diameter": "5 m", "length": "20 m", **given})


def test_inertia_of_a_solid_cylinder_and_a_tube() -> None:
    """m r²/2 about the axis and m (3 r² + L²)/12 across; of a tube with r² + ρ² for r²."""
    axial, across = MASS * R**2 / 2, MASS * (3 * R**2 + L**2) / 12
    assert cylinder().inertia(MASS) == pytest.approx((axial, across, across), rel=1e-13)
    assert cylinder(along="z").inertia(MASS) == pytest.approx((across, across, axial), rel=1e-13)
    squares = R**2 + 2.4**2
    axial, across = MASS * squares / 2, MASS * (3 * squares + L**2) / 12
    assert cylinder(wall="100 mm").inertia(MASS) == pytest.approx((axial, across, across), rel=1e-12)


def test_inertia_of_a_cone() -> None:
    """A frustum has 3/10 m (a⁵ − b⁵)/(a³ − b³) about its axis; one that is next to pointed 3/80 m (4 r² + h²)
    across it, about its middle h/4 above its foot.
    """
    a, b = 2.5, 1.0
    found = cylinder(end_diameter="2 m", along="z").inertia(MASS)
    assert found[2] == pytest.approx(0.3 * MASS * (a**5 - b**5) / (a**3 - b**3), rel=1e-13)
    pointed = cylinder(end_diameter="1 mm", along="z")
    # What is left of the point is 1e-3/5 of the height.
    assert pointed.moments.middle == pytest.approx(L / 4, rel=1e-3)
    assert pointed.inertia(MASS)[0] == pytest.approx(3 / 80 * MASS * (4 * R**2 + L**2), rel=1e-3)


lengths = st.floats(0.5, 30.0)


@given(lengths, lengths, lengths, st.sampled_from("xz"), st.one_of(st.none(), st.floats(0.05, 0.9)))
def test_flat_sides_are_within_their_error(
    first: float, last: float, length: float, along: str, wall: float | None
) -> None:
    """Of any cone: corners of its hull are on its skin and its flat sides within (RL5) of that, all of it is
    in its box, and the mesh of a body of n sides has its mass properties to (π/n)², solid or hollow.
    """
    words = {"wall": f"{wall * min(first, last) / 2!r} m"} if wall is not None else {}
    given_ = cylinder(
        diameter=f"{first!r} m", end_diameter=f"{last!r} m", length=f"{length!r} m", along=along, **words
    )
    hull = round_body.hull(given_)
    assert max(abs(given_.depth(corner)) for corner in hull) < 1e-9 * max(first, last, length)
    for side in round_body.sides(given_)[2:]:
        # The middle of each end's edge of a strip is deepest within the circle.
        for corner, other in ((side[0], side[1]), (side[2], side[3])):
            _, *beside = given_.own((corner + other) / 2)
            # Strips are counted for the larger end; 400 of them miss 1e-4 of a radius of more than 6.5 m.
            assert given_.widest - math.hypot(*beside) * given_.widest / math.hypot(
                *given_.own(corner)[1:]
            ) == pytest.approx(0.0, abs=max(2e-4, 1e-4 * given_.widest))
    sizes = np.array(given_.sizes)
    low, high = hull.min(axis=0), hull.max(axis=0)
    assert (high - low) == pytest.approx(sizes, rel=1e-9)
    assert low[2] == pytest.approx(0.0, abs=1e-9)
    assert low[:2] + high[:2] == pytest.approx([0.0, 0.0], abs=1e-9)
    mesh = round_body.surface(given_)
    assert mesh.is_closed and mesh.is_consistent
    found, exact = MassProperties.of_closed_mesh(mesh, 1.0), given_.moments
    # n is 32 at least, and a wall of 5 % of the radius at least loses (π/n)² of both of its skins.
    assert found.mass == pytest.approx(exact.volume, rel=0.03)
    axis = "xyz".index(along)
    start = -length / 2 if along == "x" else 0.0
    assert found.centre[axis] == pytest.approx(start + exact.middle, abs=0.02 * length)
    assert np.diag(found.inertia) == pytest.approx(given_.inertia(found.mass), rel=0.03)


@pytest.mark.parametrize(
    ("radius", "slope"),
    [(0.1, 9.8), (0.2, 9.8), (1, 4.4), (2, 3.1), (5, 2.0), (20, 1.0), (32, 0.8), (50, 0.8)],
)
def test_slope_on_which_it_rolls_over_its_sides(radius: float, slope: float) -> None:
    """A body of n sides tips over an edge on a slope of tan(π/n), (RL5); the figures of the page.

    From its axis to the middle of a side of the hull that meets others, and from there to a corner.
    """
    given_ = cylinder(diameter=f"{2 * radius!r} m", length="8 m", along="x")
    rim = round_body.hull(given_)
    rim = rim[np.isclose(rim[:, 0], rim[0, 0])][:, 1:] - [0.0, radius]
    beside, middle = np.linalg.norm(rim[1] - rim[0]) / 2, np.linalg.norm(rim[1] + rim[0]) / 2
    assert beside / middle == pytest.approx(math.tan(math.pi / len(rim)), rel=1e-9)
    assert f"{100 * beside / middle:.1f}" == f"{slope:.1f}"


def test_segments_of_a_circle() -> None:
    """Half a circle has π r²/2 and π r⁴/8, a whole one π r² and π r⁴/4; a shallow one 4/3 d √(2 r d)."""
    assert segment_area(R, R) == pytest.approx(math.pi * R**2 / 2, rel=1e-14)
    assert segment_area(R, 2 * R) == segment_area(R, 99.0) == pytest.approx(math.pi * R**2, rel=1e-14)
    assert segment_moment(R, R) == pytest.approx(math.pi * R**4 / 8, rel=1e-14)
    assert segment_moment(R, D) == pytest.approx(math.pi * R**4 / 4, rel=1e-14)
    depth = 1e-3
    assert segment_area(R, depth) == pytest.approx(4 / 3 * depth * math.sqrt(2 * R * depth), rel=1e-3)
    assert segment_area(R, -1.0) == segment_moment(0.0, 1.0) == 0.0


def wet(words: dict[str, str], volume: float, level: float, tilt: float = 0.0) -> tuple[float, float]:
    """What of the cells of a load is wet [m³], and the moment of that about its bottom centre across [m⁴].

    Args:
        words: its shape.
        volume: that it displaces [m^3].
        level: of the water over its datum [m].
        tilt: by which it is turned about its own x, through the datum [rad].
    """
    load = Load.model_validate(
        {
            "name": "column",
            "shape": {"cylinder": words},
            "weight": {"calculated": "200 t"},
            "centre_of_gravity": {"at": ["0 m", "0 m", "1 m"]},
        }
    )
    in_water = InWater.model_validate(
        {
            "displaced_volume": f"{volume!r} m^3",
            "added_mass": ["1 t", "1 t", "1 t"],
            "drag_coefficients": ["0", "0", "0"],
        }
    )
    box = np.array([[-1e3, -1e3, 0.0], [1e3, 1e3, 1.0]])
    total, moment = 0.0, 0.0
    for one in lattices(in_water, load, box, np.zeros(3), RHO):
        for layer in range(one["layers"]):
            for x_sign in (-1, 1):
                for y_sign in (-1, 1):
                    x, y, z = one["at"]
                    place = np.array(
                        [x + x_sign * one["half"][0], y + y_sign * one["half"][1], z + layer * one["height"]]
                    )
                    up = place[1] * math.sin(tilt) + place[2] * math.cos(tilt)
                    across = place[1] * math.cos(tilt) - place[2] * math.sin(tilt)
                    own = float(share((level - up), one["height"])) * one["volume"]
                    total, moment = total + own, moment + own * across
    return total, moment


@pytest.mark.parametrize("depth", [0.5, 1.3, 2.5, 3.7, 4.6])
def test_a_lying_cylinder_displaces_segments(depth: float) -> None:
    """L A(d) of the segment (RL9) to 0.4 % of the whole, which sixteen layers get wet softly; turned by a
    small angle with its depth kept, what it displaces stays under its axis: KM is its radius, to the layers.
    """
    volume = math.pi * R**2 * L
    found, _ = wet(LYING, volume, depth)
    assert found == pytest.approx(L * segment_area(R, depth), abs=4e-3 * volume)
    tilt = 0.02
    # The axis comes to R cos φ above the datum and R sin φ beside it, the surface stays as far below it.
    level = R * math.cos(tilt) - (R - depth)
    total, moment = wet(LYING, volume, level, tilt)
    assert moment / total == pytest.approx(-R * math.sin(tilt), abs=0.015 * R * tilt)


def test_a_thin_tube_displaces_its_wall() -> None:
    """L (A(d) of the outer circle less A(d − t) of the bore), to 3 % of the wall."""
    wall, bore = 0.05, R - 0.05
    words = {**LYING, "wall": "50 mm"}
    volume = math.pi * (R**2 - bore**2) * L
    for depth in (0.6, 2.0, 3.1, 4.4):
        exact = L * (segment_area(R, depth) - segment_area(bore, depth - wall))
        assert wet(words, volume, depth)[0] == pytest.approx(exact, abs=0.03 * volume)
    # With plugs it has all of its inside.
    whole = math.pi * R**2 * L
    assert wet(words, whole, R)[0] == pytest.approx(whole / 2, rel=1e-9)


@pytest.mark.parametrize(("along", "draft"), [("z", 9.0), ("x", 2.0)])
def test_floats_at_its_draft(tmp_path: Path, along: str, draft: float) -> None:
    """Free in still water it comes to rest where ρ π r² T, or ρ L A(T), is its mass: upright or on its side,
    each with its centre of gravity so low that GM is positive.
    """
    area = math.pi * R**2 * draft if along == "z" else L * segment_area(R, draft)
    centre = (0.0, 0.0, 3.0 if along == "z" else 2.0)
    mass = RHO * area
    given_ = round_lift(
        {**LYING, "along": along},
        centre,
        load={
            "weight": {"calculated": f"{mass!r} kg"},
            "position": ["0 m", "0 m", f"{0.1 - draft!r} m"],
            "in_water": {
                "displaced_volume": f"{math.pi * R**2 * L!r} m^3",
                "added_mass": ["200 t", "200 t", "200 t"],
                "drag_coefficients": ["5", "5", "5"],
            },
        },
        ground=None,
        water={"level": "0 m"},
        duration="400 s",
    )
    recording = simulated(tmp_path, given_, sample_interval=10.0)
    bottom = recording.column("body_position", "column")[-1, 2] - centre[2]
    # Waves of its own heave are left of 0.1 m by square damping: they die as 1/t.
    assert bottom == pytest.approx(-draft, abs=0.02)
    assert recording.column("displaced_volume", "column.in_water")[-1] == pytest.approx(area, rel=5e-3)
    assert recording.column("load_tilt", "column")[-1] < 1e-3


def test_metacentric_height_of_an_upright_cylinder() -> None:
    """KM = T/2 + r²/4T (Bouguer), by the moment of what it displaces as it heels about its keel.

    The layer of height H that the surface is in counts in its middle, which is H²/8T of T/2 at most.
    """
    draft, volume, tilt = 8.0, math.pi * R**2 * L, 0.01
    upright = wet(STANDING, volume, draft)[0]
    assert upright == pytest.approx(math.pi * R**2 * draft, rel=1e-9)
    total, moment = wet(STANDING, volume, draft * math.cos(tilt), tilt)
    assert total == pytest.approx(upright, rel=1e-3)
    assert -moment / total / math.sin(tilt) == pytest.approx(
        draft / 2 + R**2 / (4 * draft), abs=(L / 16) ** 2 / (8 * draft) * 1.01
    )


@pytest.mark.parametrize("heading", [0.0, 0.3, 1.2])
def test_keeps_clear_of_a_wall(tmp_path: Path, heading: float) -> None:
    """From a wall's upright edge to a standing cylinder it is the distance of its axis less its radius, to 1
    mm and never smaller; from a flat roof to a lying one how far its lowest line is above.
    """
    x, y = 9.0 * math.cos(heading), 9.0 * math.sin(heading)
    building = {"type": "box", "x": [f"{x!r} m", "40 m"], "y": [f"{y!r} m", "40 m"], "z": ["0 m", "60 m"]}
    given_ = round_lift(
        STANDING,
        (0.0, 0.0, 10.0),
        load={"position": ["0 m", "0 m", "3 m"], "heading": f"{0.4 + heading!r} rad"},
        structures={"wall": building},
        watch=[{"between": ["column", "wall"], "smallest": "1 m"}],
        duration="0.1 s",
    )
    found = float(simulated(tmp_path, given_)["clearance"].values[0, 0])
    exact = math.hypot(x, y) - R
    assert exact - 1e-9 <= found <= exact + 1e-3
    given_ = round_lift(
        LYING,
        (0.0, 0.0, R),
        load={"position": ["0 m", "0 m", "64 m"], "heading": f"{heading!r} rad"},
        structures={"wall": {**building, "x": ["-5 m", "5 m"], "y": ["-5 m", "5 m"]}},
        watch=[{"between": ["column", "wall"], "smallest": "1 m"}],
        duration="0.1 s",
    )
    found = float(simulated(tmp_path, given_)["clearance"].values[0, 0])
    assert found == pytest.approx(4.0, abs=1e-3)


def test_rolls_to_and_fro_over_the_ground(tmp_path: Path) -> None:
    """With its centre of gravity e below its axis, and let go a little beside, it rolls with
    ω² = m g e/(I + m (r − e)²), I = m r²/2 for an even cylinder.
    """
    e, aside = 0.4, 0.02
    omega = math.sqrt(G * e / (R**2 / 2 + (R - e) ** 2))
    given_ = round_lift(
        LYING,
        (0.0, aside, R - e),
        load={"position": ["0 m", "0 m", f"{-WEIGHT / 4 / 200e6!r} m"]},
        duration=f"{6 * math.pi / omega!r} s",
    )
    recording = simulated(tmp_path, given_, sample_interval=0.1)
    # It begins at rest with its centre of gravity aside/e from below the axis.
    turned = math.atan2(aside, e)
    tilt = recording.column("load_tilt", "column")
    expected = np.abs(turned * (1.0 - np.cos(omega * recording.time)))
    # A swing of 0.05 rad is slower by its square over 16 and so, times 19 rad of three periods.
    assert tilt == pytest.approx(expected, abs=0.02 * turned)
    y = recording.column("body_position", "column")[:, 1]
    assert np.ptp(y) == pytest.approx(2 * turned * (R - e), rel=0.02)
    assert recording.attributes["energy_remainder"] < 1e-4


@pytest.mark.parametrize("aside", [0.0, 0.5, 1.7])
def test_stands_on_its_foot(tmp_path: Path, aside: float) -> None:
    """At rest on the ground it leans on its dome by (RL8), r φ′(σ) = e + h tan β: no more than 1 mrad, and
    carries all of its weight on the rim of its foot.
    """
    above = 8.0
    given_ = round_lift(
        STANDING,
        (0.6 * aside, 0.8 * aside, above),
        load={"stands_on": "ground"},
        start="rest",
        duration="5 s",
    )
    recording = simulated(tmp_path, given_)
    tilt = recording.column("load_tilt", "column")
    share_ = float(tilt[0]) / 1e-3
    assert R * (1.5 * share_ - 0.5 * share_**3) == pytest.approx(aside + above * float(tilt[0]), abs=1e-4)
    assert tilt == pytest.approx(np.full(len(tilt), tilt[0]), abs=1e-9)
    assert recording.column("contact_force", "column.rim_1") == pytest.approx(
        np.full(len(tilt), WEIGHT), rel=1e-6
    )
    assert recording.column("contact_force", "column.rim_2") == pytest.approx(np.zeros(len(tilt)))


def test_leans_over_as_its_centre_leaves_its_foot(tmp_path: Path) -> None:
    """It stands with its centre of gravity 8 m up and 9 mm within the edge of its foot, of which the dome of
    1 mrad takes 8 mm; 2 mm on it is refused, and let go it falls.
    """
    edge, words = R - 8.0 * 1e-3, {"stands_on": "ground"}
    given_ = round_lift(STANDING, (edge - 1e-3, 0.0, 8.0), load=words, start="rest", duration="20 s")
    assert simulated(tmp_path, given_).column("load_tilt", "column").max() < 1e-3
    with pytest.raises(gantline.ScenarioError, match=r"would tip over: .* well within the rim it stands on"):
        simulated(tmp_path, {**round_lift(STANDING, (edge + 1e-3, 0.0, 8.0), load=words), "start": "rest"})
    given_ = round_lift(STANDING, (edge + 1e-3, 0.0, 8.0), duration="20 s")
    assert simulated(tmp_path, given_).column("load_tilt", "column").max() > 1.0


def supports(heights: list[str], y: float, **words: Any) -> dict[str, Any]:
    places = {
        f"{row}{column}": {"at": [f"{x} m", f"{side * y} m"], "height": height}
        for (row, x, column, side), height in zip(
            (("a", -6, "l", -1), ("a", -6, "r", 1), ("b", 6, "l", -1), ("b", 6, "r", 1)), heights, strict=True
        )
    }
    return {
        "cradle": {
            "under": "column",
            "places": places,
            "stiffness": "100 MN/m",
            "damping": "1 MN s/m",
            "friction": 0.5,
            **words,
        }
    }


def test_lies_in_a_cradle(tmp_path: Path) -> None:
    """Tops at y = ±0.48 m cut to it are R − √(R² − y²) above its lowest line, to 0.2 mm, and share
    its weight by levers. Its sides rise by 11.07° there, less than what carries beside the middle of a top.
    """
    y, lowest, x = 0.48, 1.3, 1.0
    given_ = round_lift(
        LYING,
        (x, 0.0, R),
        load={"position": ["0 m", "0 m", f"{lowest} m"], "stands_on": "cradle"},
        supports=supports(["to_load"] * 4, y),
        start="rest",
    )
    rise = R - math.sqrt(R**2 - y**2)
    found = assembled(tmp_path, given_)
    assert [one.support.height for one in found.under_load] == pytest.approx([lowest + rise] * 4, abs=2e-4)
    recording = simulated(tmp_path, given_)
    forces = np.array([recording.column("contact_force", one.name)[-1] for one in recording.rig.supports])
    assert forces.sum() == pytest.approx(WEIGHT, rel=1e-6)
    # 0.2 mm of one side more than the other are 20 kN of a support.
    assert forces == pytest.approx(WEIGHT / 4 * (1 + x / 6 * np.array([-1, -1, 1, 1])), abs=20e3)


def test_stands_on_supports_under_its_end(tmp_path: Path) -> None:
    """On four tops under its foot, one 2 mm lower, it shares its weight as any level underside (SU3)."""
    low = [0.0, 0.0, 2e-3, 0.0]
    heights = [f"{1.5 - one!r} m" for one in low]
    places = np.array([(-1.5, -1.0), (-1.5, 1.0), (1.5, -1.0), (1.5, 1.0)])
    names = ("al", "ar", "bl", "br")
    group = supports(heights, 1.0)["cradle"]
    group["places"] = {
        name: {"at": [f"{x} m", f"{y} m"], "height": height}
        for name, (x, y), height in zip(names, places.tolist(), heights, strict=True)
    }
    given_ = round_lift(
        STANDING,
        (0.2, 0.1, 3.0),
        load={"position": ["0 m", "0 m", "1.5 m"], "stands_on": "cradle"},
        supports={"cradle": group},
        start="rest",
        duration="0.2 s",
    )
    recording = simulated(tmp_path, given_)
    forces = np.array([recording.column("contact_force", one.name)[0] for one in recording.rig.supports])
    expected = shares_of_springs(places, np.full(4, 100e6), np.array(low), WEIGHT, np.array([0.2, 0.1]))
    assert forces == pytest.approx(expected, abs=2e-3 * WEIGHT)


@pytest.mark.parametrize("turned", [0.0, 0.2])
def test_stands_on_a_platform_by_the_corners_of_its_end(tmp_path: Path, turned: float) -> None:
    """On another body an end has sixteen corners (RL5): towards the middle between two of them it stands with
    its centre of gravity within R cos(π/16), 2 % less than R, and falls beyond that, whatever its heading.
    """
    platform = {"type": "box", "x": ["-20 m", "20 m"], "y": ["-20 m", "20 m"], "z": ["0 m", "5 m"]}
    for aside, falls in ((0.9, False), (0.999, True)):
        given_ = round_lift(
            STANDING,
            (aside * R * math.cos(math.pi / 16), aside * R * math.sin(math.pi / 16), 2.0),
            load={"position": ["0 m", "0 m", "5 m"], "heading": f"{turned!r} rad"},
            structures={"platform": {**platform, "stiffness": "2000 MN/m", "damping": "100 MN s/m"}},
            duration="15 s",
        )
        recording = simulated(tmp_path, given_, sample_interval=0.1)
        assert (recording.column("load_tilt", "column").max() > 0.1) == falls
        if not falls:
            assert float(recording["contact_force"].values[-1].sum()) == pytest.approx(WEIGHT, rel=1e-3)


@pytest.mark.parametrize("heading", [0.0, 0.1])
def test_lies_on_a_platform_along_its_lowest_line(tmp_path: Path, heading: float) -> None:
    """A lying one that nothing pushes stays on a flat side, R (1 − cos π/n) lower than its circle at most."""
    platform = {"type": "box", "x": ["-20 m", "20 m"], "y": ["-20 m", "20 m"], "z": ["0 m", "5 m"]}
    given_ = round_lift(
        LYING,
        (0.0, 0.0, R),
        load={"position": ["0 m", "0 m", "5 m"], "heading": f"{heading!r} rad"},
        structures={"platform": {**platform, "stiffness": "500 MN/m", "damping": "20 MN s/m"}},
        duration="10 s",
    )
    recording = simulated(tmp_path, given_, sample_interval=0.5)
    height = recording.column("body_position", "column")[-1, 2] - 5.0
    # It sinks by its weight on two corners of 500 MN/m at most.
    assert R - 1e-3 - WEIGHT / 2 / 500e6 <= height <= R
    # Places of corners that lie side by side take turns, by 0.1 µm: 1 % of what four of them yield by.
    forces = recording["contact_force"].values[-10:].sum(axis=1)
    assert forces == pytest.approx(np.full(10, WEIGHT), rel=0.03)
