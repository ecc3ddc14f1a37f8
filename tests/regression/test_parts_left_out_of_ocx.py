"""What an OCX file holds and the sum did not, without a word.

Parts beside those that panels are composed of, of a second vessel, of kinds that are not known, and panels
whose weight says that parts are missing: half of a load's weight could be left out. Thicknesses and
densities a thousand times too small or too large passed as well.
"""

from __future__ import annotations

import pytest

from gantline.cad.doubts import doubts_of_parts, doubts_of_the_whole
from gantline.cad.ocx.reader import read_ocx
from ocx_files import SQUARE, Writer, sample

W = Writer()
PLATE = W.plate("P1", W.polygon(SQUARE))
OTHER = W.plate("P2", W.polygon([(x + 5, y, z) for x, y, z in SQUARE]))
LEFT_OUT = "may be parts, but are not where parts stand, so they weigh nothing here: "


def doubts(data: bytes) -> list[str]:
    model = read_ocx(data, "file")
    return [*doubts_of_the_whole(model), *doubts_of_parts(model)]


@pytest.mark.parametrize(
    ("more", "what"),
    [
        (f'<ocx:Panel id="d" name="d">{OTHER}</ocx:Panel>', "Plate 'P2'"),
        (f"<ocx:Unit>{OTHER}</ocx:Unit>", "Plate 'P2'"),
        (W.panel("d", '<ocx:Casting id="C1" name="C1"/>'), "Casting 'C1'"),
        (W.plate("P2", W.polygon(SQUARE), tag="DoublerPlate"), "DoublerPlate 'P2'"),
        (f'<ocx:Equipment id="E1">{W.declared(1000.0, (1, 1, 1))}</ocx:Equipment>', "Equipment 'E1'"),
    ],
)
def test_parts_in_other_places_are_told(more: str, what: str) -> None:
    assert f"{LEFT_OUT}{what} in line 1" in doubts(W.file(PLATE + more))


def test_parts_of_a_second_vessel_are_told() -> None:
    second = f'</ocx:Vessel><ocx:Vessel id="two" name="two">{OTHER}</ocx:Vessel>'
    data = W.file(PLATE).replace(b"</ocx:Vessel>", second.encode())
    assert f"{LEFT_OUT}Plate 'P2' in line 1" in doubts(data)


def test_a_panel_that_weighs_more_than_its_parts_is_told() -> None:
    """314 kg are there, 1000 kg are declared; within 1 % nothing is said."""
    (told,) = doubts(W.file(W.panel("deck", PLATE, more=W.declared(1000.0))))
    missing = "panels declare another weight than their parts, of which some may be missing"
    assert told == f"{missing}: panel 'deck' 1000 kg, its parts 314 kg"
    assert doubts(W.file(W.panel("deck", PLATE, more=W.declared(316.0)))) == []


def test_panels_in_panels_declare_all_or_their_own() -> None:
    """Schemas leave it open whether a panel's weight has that of panels within it."""
    within = W.panel("part", OTHER, more=W.declared(314.0))
    for mass in (314.0, 628.0):
        assert doubts(W.file(W.panel("deck", PLATE + within, more=W.declared(mass)))) == []


@pytest.mark.parametrize(("thickness", "shown"), [(10.0, "1e+04"), (0.2, "200"), (1e-5, "0.01")])
def test_a_thickness_of_no_plate_is_told(thickness: float, shown: str) -> None:
    """Metres for millimetres or the other way round, where no declared weight tells what is meant."""
    told = f"P1: its thickness of {shown} mm is no plate's"
    assert told in doubts(W.file(W.plate("P1", W.polygon(SQUARE), thickness)))


@pytest.mark.parametrize("density", [7.85, 7.85e6])
def test_a_density_of_nothing_is_told(density: float) -> None:
    """Tonnes where the file says kilograms."""
    (told,) = doubts(W.file(PLATE, density=density))
    assert told.startswith("P1: material A has a density of 7.85")


def test_a_declared_weight_without_a_place_does_not_count() -> None:
    """Which part weighs nothing then, and that it does, were said in sentences that contradict each other."""
    lost = f'<ocx:Plate id="U" name="U">{W.declared(5000.0)}</ocx:Plate>'
    found = doubts(W.file(PLATE + lost))
    assert "without weight: U" in found
    assert any("nor does it declare a weight and its place" in doubt for doubt in found)


def test_parts_in_one_place_are_told() -> None:
    """The same plate under two names weighs twice."""
    told = "counted twice, since others just like them are in the same place: Q"
    assert told in doubts(W.file(PLATE + W.plate("Q", W.polygon(SQUARE))))


def test_a_file_in_order_has_no_doubts() -> None:
    assert doubts(sample(W)) == []
