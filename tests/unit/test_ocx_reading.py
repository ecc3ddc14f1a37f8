"""OCX files read: encodings, units, namespaces, references, and what is said of files that are not right."""

from __future__ import annotations

import gzip
import math
import re
import time
import tracemalloc
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gantline.cad import CadError, CadModel, PartKind
from gantline.cad.ocx import geometry, xml
from gantline.cad.ocx.reader import read_ocx
from ocx_files import NEW, OLD, SQUARE, Writer, sample

W = Writer()
MM = Writer(unit="mm")
PLATE = W.plate("P", W.polygon(SQUARE), declared=314.0, centre=(1.0, 1.0, 0.0))


def read(data: bytes) -> CadModel:
    return read_ocx(data, "small.3docx")


def message(data: bytes) -> str:
    with pytest.raises(CadError) as caught:
        read(data)
    text = str(caught.value)
    assert "\n" not in text and text.startswith("small.3docx")
    return text


# --- what is read ---------------------------------------------------------------------------------


def test_every_kind_of_part_is_read() -> None:
    model = read(sample(W))
    assert [(part.name, part.kind, part.group) for part in model.parts] == [
        ("P1", PartKind.PLATE, "deck"),
        ("B1", PartKind.BRACKET, "deck"),
        ("S1", PartKind.STIFFENER, "deck"),
        ("E1", PartKind.EDGE_REINFORCEMENT, "deck"),
        ("C1", PartKind.PILLAR, ""),
    ]
    assert [part.size for part in model.parts] == ["10 mm", "10 mm", "flat", "flat", "tube"]
    assert {part.material for part in model.parts} == {"A"}
    assert model.name == "small" and model.form == "OCX 3.1.0, by hand"
    assert [doubt for part in model.parts for doubt in part.doubts] == [] == list(model.doubts)


@pytest.mark.parametrize("unit", ["m", "mm"])
@pytest.mark.parametrize("nested", [False, True])
@pytest.mark.parametrize("namespace", [OLD, NEW])
def test_all_encodings_give_the_same_model(unit: str, nested: bool, namespace: str) -> None:
    reference = read(sample(W)).properties
    model = read(sample(Writer(unit=unit, nested=nested, namespace=namespace, version="2.8.5")))
    assert model.unit == f"{unit}, as the file says"
    assert model.properties.mass == pytest.approx(reference.mass, rel=1e-12)
    assert model.properties.centre == pytest.approx(reference.centre, rel=1e-12)
    assert model.properties.inertia == pytest.approx(reference.inertia, rel=1e-11)


def test_declared_weights_stand_beside_computed_ones() -> None:
    model = read(sample(W))
    plate = model.of_kind(PartKind.PLATE)[0]
    assert plate.declared is not None and plate.declared.centre is not None
    assert plate.declared.mass == 282.4 and plate.declared.centre.tolist() == [1.0, 1.0, 0.0]
    both = model.compared()
    assert both.declared == pytest.approx(282.4 + 9.8 + 31.4)
    assert both.worst is not None and both.worst.name == "P1"
    assert model.compared(PartKind.PILLAR).worst is None


@pytest.mark.parametrize("turned", range(8))
def test_a_contour_is_read_in_any_order_and_direction(turned: int) -> None:
    """Some exporters write the edges of a contour as they come."""
    sides = [(0, 1), (1, 2), (2, 3), (3, 0)]
    order = [sides[(3 * place + turned) % 4] for place in range(4)]
    lines = [(b, a) if (turned >> place) & 1 else (a, b) for place, (a, b) in enumerate(order)]
    contour = "".join(W.line(SQUARE[a], SQUARE[b]) for a, b in lines)
    part = read(W.file(W.plate("P", contour))).parts[0]
    assert part.properties is not None and part.doubts == ()
    assert part.properties.mass == pytest.approx(314.0)


def test_a_gap_in_a_contour_is_told() -> None:
    contour = "".join(W.line(SQUARE[a], SQUARE[b]) for a, b in [(0, 1), (1, 2), (2, 3)])
    part = read(W.file(W.plate("P", contour))).parts[0]
    assert part.properties is not None and part.properties.mass == pytest.approx(314.0)
    assert part.doubts == ("its contour is open by 2 m, closed by a straight line",)


def test_the_wrong_area_is_told() -> None:
    net = '<ocx:NetArea numericvalue="3.5" unit="A"/>'
    part = read(W.file(W.plate("P", W.polygon(SQUARE), more=net))).parts[0]
    assert part.doubts == ("its area is 4 m², declared are 3.5 m²",)


def test_a_thickness_that_is_no_plates_is_told() -> None:
    """Declared weight and area say 10 mm, the thickness says 200: one exporter wrote such a plate."""
    net = '<ocx:NetArea numericvalue="4" unit="A"/>'
    part = read(W.file(W.plate("P", W.polygon(SQUARE), 0.2, declared=314.0, more=net))).parts[0]
    assert part.properties is not None and part.properties.mass == pytest.approx(314.0)
    assert "its thickness of 200 mm is no plate's: 10 mm are taken" in part.doubts[0]
    without = read(W.file(W.plate("P", W.polygon(SQUARE), 0.2))).parts[0]
    assert without.properties is not None and without.properties.mass == pytest.approx(6280.0)


def test_a_part_that_cannot_be_read_counts_with_its_declared_weight() -> None:
    broken = W.bar("S", W.line((0.0, 0.0, 0.0), (2.0, 0.0, 0.0)), "nowhere", declared=31.4)
    model = read(W.file(PLATE + broken))
    bar = model.parts[1]
    assert bar.properties is None and bar.counted is None  # nothing says where its weight acts
    assert "refers to 'nowhere', which the file does not have" in bar.doubts[0]
    assert model.without_weight == (bar,)


def test_a_curved_plate_without_surface_is_told() -> None:
    corners = [(0.0, 0.0, 0.0), (2.0, 0.0, 0.3), (2.0, 2.0, 0.0), (0.0, 2.0, 0.3)]
    part = read(W.file(W.plate("P", W.polygon(corners)))).parts[0]
    assert part.doubts == ("it is curved, and its surface is not read: taken as flat",)


def test_an_unknown_version_is_told() -> None:
    model = read(Writer(version="4.0.0").file(PLATE))
    assert model.doubts == ("schema version '4.0.0' is not one of 2.8 to 3.1: it is read as if it were",)


def test_a_unit_whose_power_contradicts_its_symbol_is_what_the_symbol_says() -> None:
    """As one exporter writes millimetres: symbol mm, root unit mm to the power −3."""
    data = MM.file(MM.plate("P", MM.polygon(SQUARE))).replace(
        b'prefix="m" powerNumerator="1"', b'prefix="m" powerNumerator="-3"'
    )
    assert read(data).box[1] == pytest.approx([2.0, 2.0, 0.005])


def test_a_unit_without_symbol_is_what_its_roots_say() -> None:
    data = MM.file(MM.plate("P", MM.polygon(SQUARE))).replace(b'<UnitSymbol type="mm"/>', b"")
    assert read(data).box[1] == pytest.approx([2.0, 2.0, 0.005])


# --- what is not right ----------------------------------------------------------------------------


def replaced(old: str, new: str) -> bytes:
    data = W.file(PLATE)
    assert old.encode() in data
    return data.replace(old.encode(), new.encode())


BROKEN: dict[str, tuple[Callable[[], bytes], str]] = {
    "empty": (lambda: b"", r"ends in the middle, at line 1"),
    "truncated": (lambda: W.file(PLATE)[:900], r"ends in the middle, at line 1; is it complete\?"),
    "zip": (lambda: b"PK\x03\x04" + W.file(PLATE), r"is packed by zip; unpack it"),
    "gzip": (lambda: gzip.compress(W.file(PLATE)), r"is packed by gzip; unpack it"),
    "no XML": (lambda: b"ISO-10303-21;", r"line 1: is not well-formed XML \(invalid token\)"),
    "tags crossed": (
        lambda: replaced("</ocx:Plate>", "</ocx:Panel>"),
        r"not well-formed XML \(mismatched tag\)",
    ),
    "other XML": (lambda: b"<html/>", r"is no OCX: its first element is 'html', not 'ocxXML'"),
    "no namespace": (lambda: b"<ocxXML/>", r"its namespace is none, not that of schema 2.8 to 3.1"),
    "namespace": (
        lambda: replaced(NEW, "https://example.org/ocx"),
        r"its namespace is 'https://example.org/ocx'",
    ),
    "encoding": (
        lambda: W.file(PLATE).replace(b"UTF-8", b"KLINGON"),
        r"(encoding cannot be read|not well-formed XML \(unknown encoding\))",
    ),
    "no vessel": (lambda: W.file(PLATE).replace(b"ocx:Vessel", b"ocx:Boat"), r"has no Vessel"),
    "no parts": (lambda: W.file(""), r"has no plates, stiffeners, brackets or pillars"),
    "document type": (
        lambda: W.file(PLATE).replace(b"<ocx:ocxXML", b"<!DOCTYPE ocxXML><ocx:ocxXML", 1),
        r"has a document type declaration",
    ),
    "no unit": (lambda: W.file(W.plate("P", W.polygon(SQUARE))).replace(b'unit="L"', b""), r"has no unit"),
    "unknown unit": (
        lambda: W.file(W.plate("P", W.polygon(SQUARE))).replace(b'unit="L"', b'unit="Q"'),
        r"Thickness has the unit 'Q', which the file's table of units does not explain",
    ),
    "unit of a mass": (
        lambda: W.file(W.plate("P", W.polygon(SQUARE))).replace(b'unit="L"', b'unit="M"'),
        r"Thickness has the unit 'M' of a mass, not of a length",
    ),
    "no number": (
        lambda: W.file(W.plate("P", W.polygon(SQUARE))).replace(b'"2.0 2.0 0.0"', b'"2.0 two 0.0"'),
        r"has a coordinates that is no list of numbers",
    ),
    "two numbers": (
        lambda: W.file(W.plate("P", W.polygon(SQUARE))).replace(b'"2.0 2.0 0.0"', b'"2.0 2.0"'),
        r"has 2 numbers as coordinates, not 3",
    ),
    "not a number": (
        lambda: W.file(W.plate("P", W.polygon(SQUARE))).replace(b'"2.0 2.0 0.0"', b'"2.0 nan 0.0"'),
        r"has a number beyond all bounds as coordinates",
    ),
    "no thickness": (
        lambda: W.file(W.plate("P", W.polygon(SQUARE), 0.0)),
        r"has a Thickness of 0, which is not positive",
    ),
    "no area": (
        lambda: W.file(W.plate("P", W.polygon([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 0.0, 0.0)]))),
        r"OuterContour encloses no area",
    ),
    "no contour": (lambda: W.file(W.plate("P", "")), r"OuterContour has no curve"),
    "no material": (
        lambda: W.file(W.plate("P", W.polygon(SQUARE)).replace('"steel"', '"oak"')),
        r"refers to 'oak'",
    ),
    "not a section": (
        lambda: W.file(W.bar("S", W.line((0.0, 0.0, 0.0), (2.0, 0.0, 0.0)), "S")),
        r"SectionRef refers to 'S', which is a Stiffener, not BarSection",
    ),
    "not a shape": (
        lambda: W.file(
            W.bar("S", W.line((0.0, 0.0, 0.0), (2.0, 0.0, 0.0)), "odd"),
            sections=W.section("odd", "StarBar", Height=1.0),
        ),
        r"BarSection 'odd' has no shape that is known, but StarBar",
    ),
    "flange too thick": (
        lambda: W.file(
            W.bar("S", W.line((0.0, 0.0, 0.0), (2.0, 0.0, 0.0)), "odd"),
            sections=W.section("odd", "IBar", Height=0.1, Width=0.1, WebThickness=0.01, FlangeThickness=0.06),
        ),
        r"has flanges that are thicker than the section is high",
    ),
    "web along the trace": (
        lambda: W.file(W.bar("S", W.line((0.0, 0.0, 0.0), (2.0, 0.0, 0.0)), web=(1.0, 0.0, 0.0))),
        r"Stiffener 'S' has a web that runs along its trace line",
    ),
    "too few knots": (
        lambda: W.file(W.plate("P", W.nurbs(3, [0.0, 0.0, 1.0, 1.0], SQUARE, [1.0] * 4))),
        r"NURBS3D has 4 knots, not 8 as 4 points of degree 3 need",
    ),
    "knots that fall": (
        lambda: W.file(W.plate("P", W.nurbs(1, [0.0, 0.0, 2.0, 1.0, 3.0, 3.0], SQUARE, [1.0] * 4))),
        r"has knots that do not rise",
    ),
    "weight below zero": (
        lambda: W.file(W.plate("P", W.nurbs(3, [0.0] * 4 + [1.0] * 4, SQUARE, [1.0, -1.0, 1.0, 1.0]))),
        r"has a control point whose weight is not positive",
    ),
    "declares less than nothing": (
        lambda: W.file(W.plate("P", W.polygon(SQUARE), declared=-1.0)),
        r"Plate 'P' declares a weight of -1 kg",
    ),
    "the same name twice": (
        lambda: W.file(
            W.bar("S", W.line((0.0, 0.0, 0.0), (2.0, 0.0, 0.0))),
            sections=W.section("flat", "FlatBar", Height=1.0),
        ),
        r"refers to 'flat', which the file has more than once",
    ),
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_file_is_one_clear_sentence(name: str) -> None:
    make, said = BROKEN[name]
    assert re.search(said, message(make()))


# --- bounds ---------------------------------------------------------------------------------------


def bounded(make: Callable[[], bytes], said: str) -> None:
    """The file is refused within ten seconds of work and 200 MB over its own size."""
    data = make()
    tracemalloc.start()
    began = time.process_time()
    try:
        assert re.search(said, message(data))
        assert time.process_time() - began < 10.0
        assert tracemalloc.get_traced_memory()[1] < 200e6
    finally:
        tracemalloc.stop()


def test_entities_are_not_expanded() -> None:
    """The billion laughs: ten entities, each ten of the one before."""
    levels = ["<!ENTITY a0 'ha'>"] + [f"<!ENTITY a{n} '{f'&a{n - 1};' * 10}'>" for n in range(1, 10)]
    head = f"<?xml version='1.0'?><!DOCTYPE ocxXML [{''.join(levels)}]>"
    bounded(lambda: f"{head}<ocxXML xmlns='{NEW}'>&a9;</ocxXML>".encode(), "has a document type declaration")


def test_files_outside_are_not_opened() -> None:
    head = "<?xml version='1.0'?><!DOCTYPE ocxXML [<!ENTITY x SYSTEM 'file:///etc/hostname'>]>"
    bounded(lambda: f"{head}<ocxXML xmlns='{NEW}'>&x;</ocxXML>".encode(), "has a document type declaration")


def test_very_many_parts_are_too_many() -> None:
    bounded(lambda: W.file("<ocx:Plate/>" * 100_001), "has more than 100000 parts")


def test_elements_within_elements_without_end_are_too_deep() -> None:
    bounded(lambda: W.file("<ocx:Panel>" * 100_000), "elements are nested more than 64 deep")


def test_depth_counts_where_nothing_is_read() -> None:
    bounded(lambda: W.file("<ocx:DesignView>" + "<ocx:a>" * 100_000), "elements are nested more than 64 deep")


def test_too_many_elements_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(xml, "MOST_ELEMENTS", 1000)
    bounded(lambda: W.file("<ocx:Panel/>" * 2000), "has more than 1000 elements")


def test_too_many_bytes_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(xml, "MOST_BYTES", 1000)
    assert "at most 1000 are read" in message(sample(W))


def test_a_contour_of_very_many_lines_in_disorder_is_read_in_time() -> None:
    """A circle of 8000 chords, shuffled: A = n r² sin(2π/n)/2."""
    count = 8000
    angles = np.arange(count + 1) * 2 * math.pi / count
    ring = [(math.cos(angle), math.sin(angle), 0.0) for angle in angles[:-1]]
    ring.append(ring[0])
    order = np.random.default_rng(1).permutation(count)
    data = W.file(W.plate("P", "".join(W.line(ring[place], ring[place + 1]) for place in order)))
    began = time.process_time()
    part = read(data).parts[0]
    assert time.process_time() - began < 30.0
    assert part.properties is not None and part.doubts == ()
    area = count * math.sin(2 * math.pi / count) / 2
    assert part.properties.mass == pytest.approx(78.5 * area, rel=1e-12)


def test_bounds_of_contours_and_curves(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(geometry, "MOST_CURVES", 3)
    assert "OuterContour has 4 curves; at most 3 are read" in message(W.file(W.plate("P", W.polygon(SQUARE))))
    monkeypatch.setattr(geometry, "MOST_CONTROLS", 3)
    curve = W.nurbs(3, [0.0] * 4 + [1.0] * 4, SQUARE, [1.0] * 4)
    assert "NURBS3D has 4 control points; at most 3 are read" in message(W.file(W.plate("P", curve)))


def test_references_in_a_circle_lead_nowhere() -> None:
    """A hole, a section and a surface that refer to themselves and to one another."""
    circle = (
        '<ocx:Hole2D id="a"><ocx:Contour><ocx:HoleRef localRef="b"/></ocx:Contour></ocx:Hole2D>'
        '<ocx:Hole2D id="b"><ocx:Contour><ocx:HoleRef localRef="a"/></ocx:Contour></ocx:Hole2D>'
    )
    cut = f"<ocx:PlateCutBy>{W.placed_hole('a', (1.0, 1.0, 0.0))}</ocx:PlateCutBy>"
    bounded(lambda: W.file(W.plate("P", W.polygon(SQUARE), more=cut), holes=circle), "Contour has no curve")
    edge = '<ocx:EdgeCurveRef localRef="E"/>'
    bar = W.bar("E", "", tag="EdgeReinforcement").replace("<ocx:TraceLine></ocx:TraceLine>", edge)
    bounded(lambda: W.file(bar), "refers to 'E', which is a EdgeReinforcement, not one of")


def test_panels_within_panels_are_read() -> None:
    inner = W.panel("inner", W.plate("P", W.polygon(SQUARE)))
    model = read(W.file(W.panel("outer", inner)))
    assert [(part.name, part.group) for part in model.parts] == [("P", "inner")]


# --- whatever a file may be -----------------------------------------------------------------------

SAMPLES = [sample(W), sample(Writer(unit="mm", nested=True, namespace=OLD))]


@settings(max_examples=150)
@given(
    which=st.sampled_from(SAMPLES),
    cuts=st.lists(
        st.tuples(st.floats(0, 1), st.integers(0, 30), st.binary(max_size=6)), min_size=1, max_size=4
    ),
)
def test_a_mutilated_file_is_read_or_refused_in_a_sentence(
    which: bytes, cuts: list[tuple[float, int, bytes]]
) -> None:
    data = which
    for place, length, instead in cuts:
        at = int(place * len(data))
        data = data[:at] + instead + data[at + length :]
    _read_or_refuse(data)


@settings(max_examples=150)
@given(
    which=st.sampled_from(SAMPLES),
    place=st.integers(0, 10_000),
    value=st.sampled_from(["0", "-1", "1e300", "nan", "inf", "", "1e-300", "2", "two", "1 2 3", "1e11"]),
)
def test_any_number_may_be_any_other(which: bytes, place: int, value: str) -> None:
    numbers = list(re.finditer(rb'(?<=")[-+0-9.e ]+(?=")', which))
    chosen = numbers[place % len(numbers)]
    _read_or_refuse(which[: chosen.start()] + value.encode() + which[chosen.end() :])


@settings(max_examples=100)
@given(which=st.sampled_from(SAMPLES), first=st.integers(0, 10_000), second=st.integers(0, 10_000))
def test_any_element_may_be_called_like_any_other(which: bytes, first: int, second: int) -> None:
    names = sorted(set(re.findall(rb"<(ocx:\w+)", which)))
    one, other = names[first % len(names)], names[second % len(names)]
    _read_or_refuse(re.sub(rb"(</?)" + one + rb"(?=[ />])", rb"\1" + other, which))


def _read_or_refuse(data: bytes) -> None:
    try:
        model = read(data)
    except CadError as problem:
        assert "\n" not in str(problem)
        return
    for part in model.parts:
        if part.properties is not None:
            assert np.isfinite(part.properties.inertia).all() and part.properties.mass > 0
