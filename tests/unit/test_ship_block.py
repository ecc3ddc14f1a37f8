"""A ship block of given size and weight: what it weighs, what is written, and what cannot be."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gantline.cad import read
from gantline.cad.assumptions import Assumptions
from gantline.cad.errors import CadError
from gantline.cad.geometry import read_geometry
from gantline.cad.glb import write_glb
from gantline.cad.model import PartKind
from gantline.cad.ocx_writer import write_ocx
from gantline.cad.ship_block import ShipBlock, ShipBlockSizes, ship_block
from gantline.cad.structure import Bar, Hole, Plate, Profile

SPACE = "https://3docx.org/fileadmin//ocx_schema//V310//OCX_Schema.xsd"
GOLIATH = ShipBlockSizes(length=43, breadth=23, height=11, mass=300e3, centre_height=5.1)


@cache
def goliath() -> ShipBlock:
    return ship_block(GOLIATH)


def test_the_load_of_the_goliath_crane() -> None:
    """43 × 23 × 11 m, 300 t, centre of gravity 5.1 m high on the centre line: what it was asked for."""
    model = goliath().model
    whole = model.properties
    assert whole.mass == pytest.approx(300e3, rel=1e-12)
    assert whole.centre == pytest.approx([0, 0, 5.1], abs=1e-12)
    # Half a plate's thickness stands over at the sides, on deck and below.
    assert model.box == pytest.approx(np.array([[-21.5, -11.5, 0], [21.5, 11.5, 11]]), abs=5e-3)
    thicknesses = goliath().thicknesses
    assert min(thicknesses.values()) >= 0.005 and max(thicknesses.values()) <= 0.040
    kinds = {kind: len(parts) for kind, parts in model.kinds}
    assert kinds == {PartKind.PLATE: 192, PartKind.STIFFENER: 131, PartKind.PILLAR: 14}
    # A structure with its mass in the shell is harder to turn than a solid box, by its radius of gyration.
    solid = 300e3 / 12 * np.array([23**2 + 11**2, 43**2 + 11**2, 43**2 + 23**2])
    assert np.all(whole.inertia.diagonal() > solid)
    assert np.all(whole.inertia.diagonal() < 2 * solid)


def test_all_meshes_are_closed_and_weigh_what_they_shall() -> None:
    """Polygons stand for round holes and tubes; all else is exact."""
    for part in goliath().parts:
        assert part.properties is not None
        assert part.mesh.is_closed and part.mesh.is_consistent, part.name
        round_shape = part.kind is PartKind.PILLAR or part.name.startswith("FLOOR")
        volume = part.properties.mass / 7850
        assert part.mesh.volume == pytest.approx(volume, rel=0.03 if round_shape else 1e-9), part.name


def test_a_hole_with_round_ends_by_its_limits() -> None:
    """As wide as high it is a disc: π r⁴/4 both ways. Very wide, nearly a rectangle: w³ h/12."""
    disc = Hole(np.zeros(3), 0.6, 0.6)
    assert disc.area == pytest.approx(math.pi * 0.09)
    assert disc.moments() == pytest.approx((math.pi * 0.3**4 / 4,) * 2)
    slot = Hole(np.zeros(3), 1000.0, 0.6)
    assert slot.moments()[0] == pytest.approx(1000**3 * 0.6 / 12, rel=1e-3)


def test_the_moments_of_a_hole_are_those_of_fine_triangles() -> None:
    """∫ u² dA and ∫ v² dA of a slot 0.7 × 0.4 by strips: the midpoint rule with 200,000 of them, to 1e-8."""
    hole = Hole(np.zeros(3), 0.7, 0.4)
    u = (np.arange(200_000) + 0.5) / 200_000 * 0.7 - 0.35
    beyond = np.maximum(np.abs(u) - 0.15, 0.0)
    half = np.sqrt(np.maximum(0.04 - beyond**2, 0.0))
    step = 0.7 / 200_000
    assert hole.area == pytest.approx(float((2 * half).sum() * step), rel=1e-6)
    expected = (float((u**2 * 2 * half).sum() * step), float((2 / 3 * half**3).sum() * step))
    assert hole.moments() == pytest.approx(expected, rel=1e-6)


def test_a_plate_with_holes_is_its_mesh() -> None:
    """Against the polygons that are drawn, whose half circles of 8 chords lack 2.6 % of their area."""
    axes = np.array([[0, 4.0, 0], [0, 0, 1.2]])
    holes = tuple(Hole(np.array([3.0, 1.0 + 2 * k, 0.6]), 1.0, 0.5) for k in range(2))
    part = Plate("floor", np.array([3.0, 0, 0]), axes, 0.01, holes).part
    assert part.properties is not None
    assert part.properties.mass == pytest.approx(78.5 * (4.8 - 2 * (0.5 * 0.5 + math.pi * 0.25**2)))
    assert part.properties.centre == pytest.approx([3, 2, 0.6])
    assert part.mesh.is_closed and part.mesh.is_consistent
    assert part.mesh.volume * 7850 == pytest.approx(part.properties.mass, rel=5e-3)


@pytest.mark.parametrize(
    ("profile", "area"),
    [
        (Profile("FlatBar", 0.12, 0.008), 0.12 * 0.008),
        (Profile("LBar", 0.1, 0.075, 0.007, 0.01), 0.1 * 0.007 + 0.068 * 0.01),
        (Profile("Tube", 0.2, 0.2, 0.01), math.pi * (0.1**2 - 0.09**2)),
    ],
)
def test_profiles(profile: Profile, area: float) -> None:
    """Area times length times density; the other hand of the flange weighs the same."""
    ends = np.array([[0, 0, 0], [10.0, 0, 0]])
    for flange in (np.array([0, 1.0, 0]), np.array([0, -1.0, 0])):
        part = Bar("bar", PartKind.STIFFENER, profile, ends, np.array([0, 0, 1.0]), flange).part
        assert part.properties is not None
        assert part.properties.mass == pytest.approx(7850 * 10 * area)
        assert part.properties.centre[0] == pytest.approx(5)
        assert part.properties.centre[1] * flange[1] > 0 and part.properties.centre[2] > 0
        assert part.mesh.is_closed and part.mesh.is_consistent and part.mesh.volume > 0


def test_a_tube_as_a_bar_by_its_closed_form() -> None:
    ends = np.array([[0, 0, 0], [0, 0, 8.0]])
    profile = Profile("Tube", 0.2, 0.2, 0.01)
    part = Bar("p", PartKind.PILLAR, profile, ends, np.eye(3)[1], np.eye(3)[0], (-0.1, -0.1)).part
    assert part.properties is not None
    mass, square = part.properties.mass, 0.1**2 + 0.09**2
    assert part.properties.centre == pytest.approx([0, 0, 4])
    about = [mass * (square / 4 + 64 / 12)] * 2 + [mass * square / 2]
    assert part.properties.inertia == pytest.approx(np.diag(about), abs=1e-12)


@settings(max_examples=15)
@given(
    st.floats(12, 60), st.floats(8, 40), st.floats(5, 20), st.floats(100, 200), st.integers(0, 1)
)  # fmt: skip
def test_any_size_is_met_exactly_or_refused(
    length: float, breadth: float, height: float, areal: float, decks: int
) -> None:
    """Mass exact, centre on the middle line, plates as yards have them; or one sentence says why not."""
    mass = areal * 2 * (length * breadth + length * height)
    try:
        made = ship_block(ShipBlockSizes(length, breadth, height, mass, tween_decks=decks))
    except CadError as problem:
        assert "yards weld plates of 5 to 40 mm" in str(problem) or "tween decks do not go" in str(problem)
        return
    whole = made.model.properties
    assert whole.mass == pytest.approx(mass, rel=1e-12)
    assert whole.centre[:2] == pytest.approx([0, 0], abs=1e-9)
    assert 0.005 <= min(made.thicknesses.values()) <= max(made.thicknesses.values()) <= 0.040


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"mass": 100e3}, "yards weld plates of 5 to 40 mm. This structure weighs between 24"),
        ({"centre_height": 8.0}, "with the centre of gravity 8 m high needs"),
        ({"centre_height": 50.0}, "a height of the centre of gravity of 50 m is not between 0 and 11 m"),
        ({"length": 1.0}, "a length of 1 m is not between 3 and 120 m"),
        ({"double_bottom": 6.0}, "a double bottom of 6 m is not between 0.8 and 4.4 m"),
        ({"tween_decks": 9}, "9 tween decks do not go into a height of 11 m"),
        ({"mass": -1.0}, "not positive"),
        ({"mass": math.nan}, "not positive"),
    ],
)
def test_what_cannot_be_made_is_refused(changes: dict[str, float], says: str) -> None:
    values = {"length": 43, "breadth": 23, "height": 11, "mass": 300e3} | changes
    with pytest.raises(CadError) as caught:
        ship_block(ShipBlockSizes(**values))  # type: ignore[arg-type]
    assert says in str(caught.value)


def test_the_same_ship_block_gives_the_same_bytes() -> None:
    again = ship_block(GOLIATH)
    assert write_ocx(again) == write_ocx(goliath())
    assert write_glb(again.model) == write_glb(goliath().model)


def test_ocx_declares_the_weight_of_every_part() -> None:
    """Declared weights of plates, stiffeners and pillars add up, and ids are there once."""
    root = ElementTree.fromstring(write_ocx(goliath()))
    assert root.get("schemaVersion") == "3.1.0"
    parts = [part for kind in ("Plate", "Stiffener", "Pillar") for part in root.iter(f"{{{SPACE}}}{kind}")]
    found = [part.find(f"{{{SPACE}}}PhysicalProperties/{{{SPACE}}}DryWeight") for part in parts]
    weights = [float(weight.attrib["numericvalue"]) for weight in found if weight is not None]
    assert len(parts) == 337
    assert math.fsum(weights) == pytest.approx(300e3, rel=1e-12)
    ids = [node.get("id") for node in root.iter() if node.get("id")]
    assert len(ids) == len(set(ids))
    names = {ref.get("localRef") for ref in root.iter() if ref.get("localRef")}
    assert names <= set(ids)


def test_the_goliath_ship_block_by_the_reader_of_other_exporters(tmp_path: Path) -> None:
    """What we write is read by the reader of NAPA's and AVEVA's files: 300 t, 5.1 m high, to rounding."""
    made = goliath()
    path = tmp_path / "block.3docx"
    path.write_bytes(write_ocx(made))
    found = read(path, keep=False)
    assert len(found.parts) == len(made.parts) and found.doubts == ()
    assert not [part for part in found.parts if part.doubts]
    assert found.properties.mass == pytest.approx(300e3, rel=1e-9)
    assert found.properties.centre == pytest.approx([0, 0, 5.1], abs=1e-9)
    expected = made.model.properties.inertia
    assert found.properties.inertia == pytest.approx(expected, abs=1e-9 * float(expected.max()))
    assert found.compared().difference == pytest.approx(0, abs=1e-9)


def test_glb_stands_upright_and_weighs_the_same(tmp_path: Path) -> None:
    """Read back by our own reader: drawn polygons lack 0.03 % of the whole."""
    path = tmp_path / "block.glb"
    path.write_bytes(write_glb(goliath().model))
    model = read_geometry(path, Assumptions())
    assert model.box == pytest.approx(goliath().model.box, abs=1e-5)
    assert model.properties.mass == pytest.approx(300e3, rel=1e-3)
    assert model.properties.centre == pytest.approx([0, 0, 5.1], abs=5e-3)
    assert {part.name for part in model.parts} >= {"BOTTOM 1.1", "PILLAR 1.1 P"}
    assert not [part for part in model.parts if part.doubts]
