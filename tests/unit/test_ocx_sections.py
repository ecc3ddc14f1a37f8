"""Cross-sections of OCX: areas by hand, bulb flats by their standard, where they stand on the trace."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.cad import CadError, Part
from gantline.cad.ocx.quantities import Quantities
from gantline.cad.ocx.reader import read_ocx
from gantline.cad.ocx.section import Section, read_section
from gantline.cad.ocx.xml import parse
from ocx_files import Writer

W = Writer()
LINE = W.line((0.0, 0.0, 0.0), (2.0, 0.0, 0.0))


def section(shape: str, **dimensions: float) -> Section:
    root = parse(W.file("", sections=W.section("it", shape, **dimensions)), "test")
    (element,) = (each for each in root.walk() if each.attributes.get("id") == "it")
    return read_section(element, Quantities(root, "test"))


def bar(
    shape: str,
    dimensions: dict[str, float],
    offset: tuple[float, float] | None = None,
    tag: str = "Stiffener",
) -> Part:
    """A bar along x with its web along z and its flange along y."""
    part = W.bar("S", LINE, "it", offset=offset, tag=tag)
    return read_ocx(W.file(part, sections=W.section("it", shape, **dimensions)), "test").parts[0]


FOUR = {"Height": 0.2, "Width": 0.1, "WebThickness": 0.01, "FlangeThickness": 0.012}
H, B, T, F = FOUR.values()

#: Shape, dimensions, area [m²], height of its centre [m] or None, by hand.
SHAPES: list[tuple[str, dict[str, float], float, float | None]] = [
    ("FlatBar", {"Height": 0.2, "Width": 0.01}, 0.002, 0.1),
    ("LBar", FOUR, B * F + (H - F) * T, (B * F * (H - F / 2) + T * (H - F) ** 2 / 2) / (B * F + (H - F) * T)),
    ("LBarOW", {**FOUR, "Overshoot": 0.02}, B * F + (H - F) * T + 0.02 * T, None),
    ("LBarOF", {**FOUR, "Overshoot": 0.02}, B * F + (H - F) * T, None),
    ("TBar", FOUR, B * F + H * T, (B * F * (H + F / 2) + T * H**2 / 2) / (B * F + H * T)),
    ("IBar", FOUR, 2 * B * F + (H - 2 * F) * T, H / 2),
    ("UBar", FOUR, 2 * B * F + (H - 2 * F) * T, H / 2),
    ("ZBar", FOUR, 2 * B * F + (H - 2 * F) * T, H / 2),
    ("RoundBar", {"Height": 0.1}, math.pi * 0.05**2, 0.05),
    # The segment of a half disc: sagitta r on a chord 2r.
    ("HalfRoundBar", {"Height": 0.1, "Width": 0.05}, math.pi * 0.05**2 / 2, 0.05),
    ("SquareBar", {"Height": 0.1}, 0.01, 0.05),
    # Regular polygons of n sides across flats a: n a² tan(π/n)/4.
    ("HexagonBar", {"Height": 0.1}, 6 * 0.1**2 * math.tan(math.pi / 6) / 4, None),
    ("OctagonBar", {"Height": 0.1}, 8 * 0.1**2 * math.tan(math.pi / 8) / 4, 0.05),
    ("Tube", {"Diameter": 0.2, "Thickness": 0.01}, math.pi * (0.1**2 - 0.09**2), 0.1),
    ("Tube", {"Diameter": 0.2, "Thickness": 0.1}, math.pi * 0.1**2, 0.1),
    ("RectangularTube", {"Height": 0.1, "Width": 0.2, "Thickness": 0.01}, 0.02 - 0.18 * 0.08, 0.05),
]


@pytest.mark.parametrize(("shape", "dimensions", "area", "height"), SHAPES)
def test_areas_and_centres(
    shape: str, dimensions: dict[str, float], area: float, height: float | None
) -> None:
    found = section(shape, **dimensions)
    assert found.moments.area == pytest.approx(area, rel=1e-12)
    if height is not None:
        assert found.moments.first[1] / area == pytest.approx(height, rel=1e-12)
    corners = np.concatenate(found.outlines(1e-5))
    assert corners.min(axis=0) == pytest.approx([0.0, 0.0], abs=1e-12), "from the corner of its box"
    assert corners.max(axis=0) == pytest.approx([found.width, found.height], rel=1e-4)
    if found.is_symmetrical:
        assert found.moments.first[0] / area == pytest.approx(found.width / 2, rel=1e-12)


#: Bulb flats of EN 10067: height, web, width of the bulb beyond the web, corner radius [mm], area [cm²].
BULBS = [
    (80, 5, 14, 4, 5.41),
    (100, 7, 15.5, 4.5, 8.74),
    (120, 8, 17, 5, 11.72),
    (140, 8, 19, 5.5, 13.83),
    (160, 9, 22, 6, 17.8),
    (180, 10, 25, 7, 22.46),
    (200, 10, 28, 8, 25.66),
    (220, 12, 31, 9, 33.4),
    (240, 12, 34, 10, 37.29),
    (260, 12, 37, 11, 41.31),
    (280, 12, 40, 12, 45.48),
    (300, 13, 43, 13, 52.79),
    (320, 13, 46, 14, 57.45),
    (340, 14, 49, 15, 65.61),
    (370, 15, 53.5, 16.5, 77.07),
    (400, 16, 58, 18, 89.43),
    (430, 17, 62.5, 19.5, 102.79),
]


@pytest.mark.parametrize(("height", "web", "bulb", "radius", "area"), BULBS)
def test_bulb_flats_have_the_area_of_their_standard(
    height: float, web: float, bulb: float, radius: float, area: float
) -> None:
    """Areas as tables of EN 10067 print them, to 0.01 cm², 0.12 % of the smallest."""
    mm = 1e-3
    given = section(
        "BulbFlat", Height=height * mm, WebThickness=web * mm, FlangeWidth=(web + bulb) * mm,
        BulbOuterRadius=radius * mm, BulbInnerRadius=radius * mm,
    )  # fmt: skip
    assert given.moments.area == pytest.approx(area * 1e-4, rel=1.2e-3)
    assert given.doubts == ()
    bare = section("BulbFlat", Height=height * mm, WebThickness=web * mm)
    assert bare.moments.area == pytest.approx(given.moments.area, rel=1e-12), "its table has the same"
    assert "width of the bulb taken from EN 10067" in bare.doubts[0]


def test_a_bulb_without_radii_is_a_web_and_a_triangle() -> None:
    """Sharp: the web h t, and below the top a triangle whose slope of 30° starts at the tip, c² tan 30°/2."""
    found = section(
        "BulbFlat", Height=0.2, WebThickness=0.01, FlangeWidth=0.04, BulbOuterRadius=0.0, BulbInnerRadius=0.0
    )
    assert found.moments.area == pytest.approx(
        0.2 * 0.01 + 0.03**2 * math.tan(math.radians(30)) / 2, rel=1e-12
    )


@pytest.mark.parametrize(
    ("shape", "dimensions", "said"),
    [
        ("FlatBar", {"Height": 0.2}, "FlatBar has no Width"),
        ("FlatBar", {"Height": 0.2, "Width": -0.01}, "has a Width of -0.01, which is not positive"),
        ("Tube", {"Diameter": 0.1, "Thickness": 0.06}, "has a wall that is thicker than its radius"),
        ("TBar", {**FOUR, "WebThickness": 0.2}, "has a web that is thicker than the section is wide"),
        ("BulbFlat", {"Height": 0.2, "WebThickness": 0.05, "FlangeWidth": 0.04}, "a bulb that is not wider"),
        (
            "BulbFlat",
            {"Height": 0.02, "WebThickness": 0.01, "FlangeWidth": 0.2},
            "has a bulb whose width, radii and height do not fit together",
        ),
        ("RectangularTube", {"Height": 0.1, "Width": 0.2, "Thickness": 0.06}, "thicker than half its width"),
    ],
)
def test_impossible_sections_are_refused(shape: str, dimensions: dict[str, float], said: str) -> None:
    with pytest.raises(CadError, match=said):
        section(shape, **dimensions)


def place(part: Part) -> tuple[float, float]:
    """Where the centre of gravity is across the bar: along flange and web [m]."""
    assert part.properties is not None
    return float(part.properties.centre[1]), float(part.properties.centre[2])


def test_a_section_stands_on_its_trace_by_the_corner_of_its_box() -> None:
    flat, tube = {"Height": 0.2, "Width": 0.01}, {"Diameter": 0.2, "Thickness": 0.01}
    assert place(bar("FlatBar", flat)) == pytest.approx((0.005, 0.1))
    assert place(bar("FlatBar", flat, (0.0, -0.1))) == pytest.approx((0.005, 0.0), abs=1e-12)
    assert place(bar("IBar", FOUR, (-0.05, 0.0))) == pytest.approx((0.0, 0.1), abs=1e-12)
    assert place(bar("Tube", tube, (-0.1, 0.0))) == pytest.approx((0.0, 0.1), abs=1e-12)


def test_a_section_without_offsets_stands_centred_if_it_is_symmetrical() -> None:
    tube = {"Diameter": 0.2, "Thickness": 0.01}
    assert place(bar("IBar", FOUR)) == pytest.approx((0.0, 0.1), abs=1e-12)
    assert place(bar("Tube", tube, tag="Pillar")) == pytest.approx((0.0, 0.0), abs=1e-12)


def test_a_section_by_its_area_alone_is_a_square_bar() -> None:
    table = '<ocx:SectionProperties><ocx:Area numericvalue="0.0025" unit="A"/></ocx:SectionProperties>'
    custom = W.section("it", "UserDefinedBarSection").replace("Section></", f"Section>{table}</", 1)
    part = read_ocx(W.file(W.bar("S", LINE, "it"), sections=custom), "test").parts[0]
    assert part.properties is not None and part.properties.mass == pytest.approx(7850 * 2 * 0.0025)
    assert "only its area is known" in part.doubts[0]


def test_a_section_by_its_shape_is_that_shape() -> None:
    outer = W.polygon([(1.0, 1.0, 0.0), (1.1, 1.0, 0.0), (1.1, 1.1, 0.0), (1.0, 1.1, 0.0)])
    inner = W.circle((1.05, 1.05, 0.0), (0.0, 0.0, 1.0), 0.06)
    shapes = f"<ocx:SectionOuterShape>{outer}</ocx:SectionOuterShape>"
    shapes += f"<ocx:SectionInnerShape>{inner}</ocx:SectionInnerShape>"
    custom = W.section("it", "UserDefinedBarSection").replace("Section></", f"Section>{shapes}</", 1)
    part = read_ocx(W.file(W.bar("S", LINE, "it"), sections=custom), "test").parts[0]
    assert part.properties is not None
    assert part.properties.mass == pytest.approx(7850 * 2 * (0.01 - math.pi * 0.03**2), rel=1e-12)
