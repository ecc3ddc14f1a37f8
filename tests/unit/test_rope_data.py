"""Rope classes: their factors against published figures, physics, and each other."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gantline.rope_data import GRADES, RopeClass, rope_class, rope_classes

CLASSES = list(rope_classes().values())
ANY_CLASS = st.sampled_from(CLASSES)
DIAMETER = st.floats(1e-3, 0.3)
GRADE = st.sampled_from([float(grade) * 1e6 for grade in GRADES])


@pytest.mark.parametrize("one", CLASSES, ids=lambda one: one.name)
def test_a_class_is_called_by_its_name_and_its_constructions(one: RopeClass) -> None:
    assert rope_class(one.name) is one
    assert all(rope_class(word) is one for word in one.designations)
    core = one.name.partition(" ")[2]
    assert all(word.endswith(f"-{core}") for word in one.designations)


def test_the_classes() -> None:
    assert len(CLASSES) == 24
    assert rope_class("6x36WS-IWRC") is rope_class("6x41WS-IWRC") is rope_classes()["6x36 IWRC"]
    assert rope_class("6x25F-FC") is rope_classes()["6x19 FC"]
    with pytest.raises(KeyError):
        rope_class("35(W)x7 IWRC")


def test_factors_of_6x36_with_a_core_of_steel() -> None:
    """W = 0.409, C = 0.460, K = 0.356 in the formulas with d in mm, and 100 kN/mm² over the metallic area."""
    rope = rope_class("6x36 IWRC")
    assert rope.mass_per_length(0.064) == pytest.approx(0.409 * 64**2 / 100, rel=1e-12)  # kg/m
    assert rope.metallic_area(0.064) == pytest.approx(0.460 * 64**2 * 1e-6, rel=1e-12)  # m²
    assert rope.axial_stiffness(0.064) == pytest.approx(0.460 * 64**2 * 100e3, rel=1e-12)  # N
    force = rope.minimum_breaking_force(0.064, 1960e6)
    assert force == pytest.approx(0.356 * 64**2 * 1960, rel=1e-12)  # K d² R / 1000 in kN
    assert rope.axial_stiffness(0.064, 115e9) == pytest.approx(1.15 * rope.axial_stiffness(0.064), rel=1e-12)


# API Spec 9A, table C.1, class 6x7 with a core of fibre: diameter [mm], mass [kg per 100 m], minimum breaking
# force in grades 1770 and 1960 [kN].
PUBLISHED = [
    (6, 12.4, 21.2, 23.4), (7, 16.9, 28.8, 31.9), (8, 22.1, 37.6, 41.6), (9, 27.9, 47.6, 52.7),
    (10, 34.5, 58.8, 65.1), (11, 41.7, 71.1, 78.7), (12, 49.7, 84.6, 93.7), (16, 88.3, 150, 167),
    (18, 112, 190, 211), (19, 125, 212, 235), (20, 138, 235, 260), (22, 167, 284, 315), (24, 199, 338, 375),
    (26, 233, 397, 440), (28, 270, 461, 510), (32, 353, 602, 666), (35, 423, 720, 797), (36, 447, 762, 843),
    (38, 498, 849, 940), (40, 552, 940, 1040),
]  # fmt: skip


@pytest.mark.parametrize(("diameter", "mass", "force_1770", "force_1960"), PUBLISHED)
def test_published_rows_of_6x7(diameter: float, mass: float, force_1770: float, force_1960: float) -> None:
    """To the rounding of three digits, half a unit of the last."""
    rope, d = rope_class("6x7 FC"), diameter * 1e-3
    assert 100 * rope.mass_per_length(d) == pytest.approx(mass, abs=half_a_unit(mass))
    forces = [rope.minimum_breaking_force(d, grade) / 1e3 for grade in (1770e6, 1960e6)]
    assert forces[0] == pytest.approx(force_1770, abs=half_a_unit(force_1770))
    assert forces[1] == pytest.approx(force_1960, abs=half_a_unit(force_1960))


def half_a_unit(number: float) -> float:
    """Half a unit of the third digit."""
    return 0.51 * 10.0 ** (math.floor(math.log10(number)) - 2)


@pytest.mark.parametrize(
    ("name", "mass", "force"),
    # Factors of a mooring program that knows ropes by their core alone: mass [kg per 100 m mm²] and minimum
    # breaking force [N/mm²]; github.com/ddjokic/Mooring-Line-Properties.
    [("6x19 FC", 0.36109, 584.175), ("6x19 IWRC", 0.39897, 633.358)],
)
def test_other_programs_have_the_same_mass_and_strength(name: str, mass: float, force: float) -> None:
    rope = rope_class(name)
    # Each program rounds its own table; they differ among each other by up to 1 %.
    assert rope.mass_factor == pytest.approx(mass, rel=0.01)
    assert rope.breaking_force_factor * 1770 == pytest.approx(force, rel=0.01)


@pytest.mark.parametrize("one", CLASSES, ids=lambda one: one.name)
def test_every_class_is_possible(one: RopeClass) -> None:
    """A slip in the data would break one of these."""
    # Metal covers less than the circle; ropes of round strands fill 40 to 60 % of it.
    assert 0.4 < one.area_factor / (math.pi / 4) < 0.62
    # Steel of 7850 kg/m³, longer than the rope by its lay, with grease and a core of fibre or without.
    assert 1.1 < one.mass_per_length(1.0) / one.metallic_area(1.0) / 7850 < 1.26
    # Laid strands hold less than their metallic area times the grade, but most of it.
    assert 0.7 < one.breaking_force_factor / one.area_factor < 0.91
    # EN 1993-1-11, table 3.1.
    assert one.modulus == (80e9 if one.name.endswith("FC") else 100e9)


def test_a_core_of_steel_makes_a_rope_heavier_fuller_and_not_weaker() -> None:
    classes = rope_classes()
    for name, fibre in classes.items():
        strands, _, core = name.partition(" ")
        others = [one for other, one in classes.items() if other.startswith(f"{strands} ")]
        for steel in others if core == "FC" else ():
            assert steel.mass_factor >= fibre.mass_factor
            assert steel.area_factor >= fibre.area_factor
            assert steel.breaking_force_factor >= fibre.breaking_force_factor


@given(ANY_CLASS, DIAMETER, st.floats(1.001, 5.0), GRADE)
def test_everything_is_positive_and_grows_with_the_square_of_the_diameter(
    one: RopeClass, diameter: float, larger: float, grade: float
) -> None:
    def figures(d: float) -> list[float]:
        return [
            one.mass_per_length(d),
            one.metallic_area(d),
            one.axial_stiffness(d),
            one.minimum_breaking_force(d, grade),
        ]

    thin, thick = figures(diameter), figures(diameter * larger)
    assert all(0 < less < more for less, more in zip(thin, thick, strict=True))
    assert thick == pytest.approx([larger**2 * figure for figure in thin], rel=1e-12)


@given(ANY_CLASS, DIAMETER, GRADE, st.floats(10e9, 200e9))
def test_the_diameter_comes_back(one: RopeClass, diameter: float, grade: float, modulus: float) -> None:
    back = [
        math.sqrt(one.mass_per_length(diameter) / one.mass_per_length(1.0)),
        math.sqrt(one.metallic_area(diameter) / one.area_factor),
        math.sqrt(one.axial_stiffness(diameter, modulus) / (modulus * one.area_factor)),
        math.sqrt(one.minimum_breaking_force(diameter, grade) / (grade * one.breaking_force_factor)),
    ]
    assert back == pytest.approx([diameter] * 4, rel=1e-12)
