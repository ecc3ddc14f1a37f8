"""Openings that overlap, or that a panel and its plate both name, took from a plate twice.

A plate of 2 m by 2 m with a hole of 0.5 m, named by panel and plate, was 5 % too light and no word was said
where the file declares no area. A hole of one plate of a panel also cut the plates in other planes that it
is seen over.
"""

from __future__ import annotations

import math

import pytest

from gantline.cad.ocx.reader import read_ocx
from ocx_files import SQUARE, Writer

W = Writer()
HOLE = W.hole("round", "ParametricCircle", {"Diameter": 0.5})
ROUND = math.pi / 16
AREAL = 78.5  # kg/m², 10 mm of steel


def read(*openings: str, of_plate: str = "") -> tuple[float, tuple[str, ...]]:
    """Area of a plate [m²] whose panel, and itself, name openings; and its doubts."""
    cut = f"<ocx:CutBy>{''.join(openings)}</ocx:CutBy>"
    panel = W.panel("deck", W.plate("P1", W.polygon(SQUARE), more=of_plate), more=cut)
    (part,) = read_ocx(W.file(panel, holes=HOLE), "file").parts
    assert part.properties is not None
    return part.properties.mass / AREAL, part.doubts


def at(x: float, y: float, z: float = 0.0) -> str:
    return W.placed_hole("round", (x, y, z))


ONCE = at(1, 1)
INNER = f"<ocx:InnerContour>{W.circle((1, 1, 0), (0, 0, 1), 0.5)}</ocx:InnerContour>"


@pytest.mark.parametrize(
    ("openings", "of_plate"),
    [
        ((ONCE,), ""),
        ((ONCE, ONCE), ""),
        ((ONCE,), f"<ocx:CutBy>{ONCE}</ocx:CutBy>"),
        ((ONCE, INNER), ""),
        ((ONCE,), INNER),
    ],
)
def test_an_opening_takes_once(openings: tuple[str, ...], of_plate: str) -> None:
    """However often it is named."""
    area, doubts = read(*openings, of_plate=of_plate)
    assert area == pytest.approx(4 - ROUND, rel=1e-12)
    assert doubts == ()


def lens(apart: float) -> float:
    """What two circles of radius 0.25 m share whose centres are so far apart [m²]."""
    half = math.acos(apart / 0.5)
    return 2 * 0.0625 * (half - math.sin(2 * half) / 2)


@pytest.mark.parametrize("apart", [0.001, 0.1, 0.25, 0.45])
def test_what_two_openings_share_is_taken_once(apart: float) -> None:
    """Two circles less their lens; polygons within a millimetre of them stand for what they share."""
    area, doubts = read(at(1, 1), at(1 + apart, 1))
    # Chords miss arcs by 1 mm at most, by 2/3 of that on average, along a circle's perimeter; 0.6e-3 seen.
    assert area == pytest.approx(4 - 2 * ROUND + lens(apart), abs=0.5 * math.pi * 0.67e-3)
    assert "an opening runs over its edge or another opening" in doubts[0]


def test_openings_that_touch_take_both() -> None:
    """Side by side they share nothing, whatever the boxes around them do."""
    area, doubts = read(at(0.7, 0.7), at(1.1, 1.1), at(1.7, 0.7))
    assert area == pytest.approx(4 - 3 * ROUND, rel=1e-12)
    assert doubts == ()


@pytest.mark.parametrize(
    "opening", [at(1, 1, 1.0), W.placed_hole("round", (1, 1, 0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))]
)
def test_an_opening_in_another_plane_takes_nothing(opening: str) -> None:
    """A metre above the plate, or upright on it: it is that of another plate of the panel."""
    area, doubts = read(opening)
    assert area == pytest.approx(4.0, rel=1e-12)
    assert doubts == ()


def test_openings_without_end_are_refused() -> None:
    """Time to sort them out grows with each that overlaps the others: the declared weight counts."""
    around = [at(1 + x, 1 + y) for x in (-0.26, 0.26) for y in (-0.26, 0.26)]
    cut = f"<ocx:CutBy>{''.join([*around, at(1, 1)])}</ocx:CutBy>"
    plate = W.plate("P1", W.polygon(SQUARE), declared=290.0, centre=(1.0, 1.0, 0.0))
    (part,) = read_ocx(W.file(W.panel("deck", plate, more=cut), holes=HOLE), "file").parts
    assert part.properties is None and part.counted is not None and part.counted.mass == 290.0
    assert "one of its openings overlaps 4 others" in part.doubts[0]
