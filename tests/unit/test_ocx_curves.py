"""Curves, areas and triangles of OCX: what must hold of any of them."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from gantline.cad.ocx.curves import Arc, Curve, Line, Spline, chained, gauss, polyline
from gantline.cad.ocx.moments import Frame, Moments, clipped, enclosed, of_polygon
from gantline.cad.ocx.triangulate import prism, simplified, triangulated

Array = npt.NDArray[np.float64]

PLANE = Frame(np.zeros(3), np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]))
number = st.floats(-5, 5, allow_nan=False).map(lambda value: round(value, 3))
point = st.tuples(number, number, number).map(np.array)


@st.composite
def splines(draw: st.DrawFn) -> Spline:
    degree = draw(st.integers(1, 5))
    inner = draw(st.lists(st.sampled_from([0.2, 0.5, 0.5, 0.7]), max_size=4).map(sorted))
    assume(all(inner.count(knot) <= degree for knot in inner))
    knots = np.array([0.0] * (degree + 1) + inner + [1.0] * (degree + 1))
    count = len(knots) - degree - 1
    points = np.array(draw(st.lists(point, min_size=count, max_size=count)))
    weights = np.array(draw(st.lists(st.sampled_from([1.0, 1.0, 0.5, 2.0]), min_size=count, max_size=count)))
    return Spline.nurbs(degree, knots, points, weights)


@st.composite
def arcs(draw: st.DrawFn) -> Curve:
    centre, first, second = (draw(point) for _ in range(3))
    assume(np.linalg.norm(np.cross(first, second)) > 0.1)
    begin, sweep = draw(st.floats(-3, 3)), draw(st.floats(0.2, 6.2))
    return Arc(centre, first, second, begin, begin + sweep)


curves = st.one_of(
    splines(), arcs(), st.lists(point, min_size=2, max_size=5).map(lambda rows: Line(np.array(rows)))
)


def basis(knots: Array, degree: int, index: int, at: float) -> float:
    """Cox and de Boor's recursion, to hold polar forms against."""
    if degree == 0:
        last = knots[index + 1] == knots[-1] and at == knots[-1] and knots[index] < knots[index + 1]
        return 1.0 if knots[index] <= at < knots[index + 1] or last else 0.0
    total = 0.0
    for side, sign in ((index, 1.0), (index + 1, -1.0)):
        width = knots[side + degree] - knots[side]
        if width > 0:
            share = (at - knots[side]) / width
            total += (share if sign > 0 else 1.0 - share) * basis(knots, degree - 1, side, at)
    return total


@settings(max_examples=60)
@given(degree=st.integers(1, 4), inner=st.lists(st.floats(0.05, 0.95), max_size=3), data=st.data())
def test_a_nurbs_is_what_its_recursion_says(degree: int, inner: list[float], data: st.DataObject) -> None:
    inner = sorted({round(knot, 2) for knot in inner})
    knots = np.array([0.0] * (degree + 1) + inner + [1.0] * (degree + 1))
    count = len(knots) - degree - 1
    points = np.array(data.draw(st.lists(point, min_size=count, max_size=count)))
    weights = np.array(data.draw(st.lists(st.floats(0.3, 3.0), min_size=count, max_size=count)))
    spans = np.unique(knots)
    found = Spline.nurbs(degree, knots, points, weights).evaluate(np.array([0.0, 0.37, 1.0]))[0]
    for span, (begin, end) in enumerate(pairwise(spans)):
        for place, share in enumerate((0.0, 0.37, 1.0)):
            at = float(begin + share * (end - begin))
            parts = weights * [basis(knots, degree, index, at) for index in range(count)]
            assert found[span, place] == pytest.approx(parts @ points / parts.sum(), abs=1e-9)


@given(curves)
def test_derivatives_are_those_of_the_positions(curve: Curve) -> None:
    step = 1e-5
    at = np.array([0.31, 0.31 - step, 0.31 + step])
    points, first, second = curve.evaluate(at)
    size = 1.0 + float(np.abs(second).max())
    assert (points[:, 2] - points[:, 1]) / (2 * step) == pytest.approx(first[:, 0], abs=1e-5 * size)
    assert (first[:, 2] - first[:, 1]) / (2 * step) == pytest.approx(second[:, 0], abs=1e-3 * size)


@given(curves)
def test_backwards_is_the_same_curve(curve: Curve) -> None:
    back = curve.reversed()
    assert back.start == pytest.approx(curve.end, abs=1e-9) and back.end == pytest.approx(
        curve.start, abs=1e-9
    )
    assert back.length == pytest.approx(curve.length, rel=1e-9, abs=1e-9)
    forth = curve.evaluate(np.array([0.25]))[0][:, 0]
    assert back.evaluate(np.array([0.75]))[0][::-1, 0] == pytest.approx(forth, abs=1e-9)


@given(curve=curves, angle=st.floats(0, 6), shift=point)
def test_a_moved_curve_keeps_its_length(curve: Curve, angle: float, shift: Array) -> None:
    turn = np.array(
        [[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]]
    )
    moved = curve.moved(turn, shift)
    assert moved.length == pytest.approx(curve.length, rel=1e-9, abs=1e-9)
    at = np.array([0.4])
    assert moved.evaluate(at)[0] == pytest.approx(curve.evaluate(at)[0] @ turn.T + shift, abs=1e-9)


@given(arcs())
def test_chords_miss_an_arc_by_the_tolerance(curve: Curve) -> None:
    tolerance = 0.01
    chords = curve.polyline(tolerance)
    points = curve.evaluate(np.linspace(0, 1, 40))[0].reshape(-1, 3)
    for at in points:
        begin, way = chords[:-1], np.diff(chords, axis=0)
        share = np.clip(np.sum((at - begin) * way, axis=1) / np.sum(way**2, axis=1), 0, 1)
        assert np.linalg.norm(begin + share[:, None] * way - at, axis=1).min() <= 1.2 * tolerance


@given(one=point, other=point, third=point)
def test_an_arc_goes_through_its_three_points(one: Array, other: Array, third: Array) -> None:
    size = float(np.linalg.norm(np.cross(other - one, third - one)))
    assume(size > 0.05)
    arc = Arc.through(one, other, third)
    assert isinstance(arc, Arc)
    assert arc.start == pytest.approx(one, abs=1e-6) and arc.end == pytest.approx(third, abs=1e-6)
    radius = float(np.linalg.norm(arc.first))
    assert float(np.linalg.norm(other - arc.centre)) == pytest.approx(radius, rel=1e-6)
    angle = math.atan2(float((other - arc.centre) @ arc.second), float((other - arc.centre) @ arc.first))
    assert angle % (2 * math.pi) <= arc.end_angle + 1e-6, "the second point is on the way"


def test_three_points_in_a_row_make_a_line() -> None:
    row = [np.array([float(place), 0.0, 0.0]) for place in (0, 1, 3)]
    assert isinstance(Arc.through(*row), Line)


@given(count=st.integers(3, 9), shuffle=st.randoms(use_true_random=False))
def test_curves_in_any_order_are_one_path(count: int, shuffle: object) -> None:
    corners = [np.array([math.cos(t), math.sin(t), 0.0]) for t in np.arange(count) * 2 * math.pi / count]
    sides = [(corners[place], corners[(place + 1) % count]) for place in range(count)]
    shuffle.shuffle(sides)  # type: ignore[attr-defined]
    lines = [Line(np.stack([b, a] if place % 3 else [a, b])) for place, (a, b) in enumerate(sides)]
    path, gap = chained(lines, 1e-6)
    assert gap < 1e-9
    assert path[-1].end == pytest.approx(path[0].start, abs=1e-9)
    area = count / 2 * math.sin(2 * math.pi / count)
    assert abs(enclosed(path, PLANE).area) == pytest.approx(area, rel=1e-9)


# --- moments --------------------------------------------------------------------------------------


@st.composite
def stars(draw: st.DrawFn) -> Array:
    """A polygon that does not cross itself: corners at rising angles, anticlockwise."""
    count = draw(st.integers(3, 12))
    radii = np.array(draw(st.lists(st.floats(0.3, 3.0), min_size=count, max_size=count)))
    angles = (np.arange(count) + 0.3 * math.sin(count)) * 2 * math.pi / count
    middle = np.array(draw(st.tuples(number, number)))
    return np.asarray(middle + radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1))


def same(one: Moments, other: Moments, tolerance: float = 1e-8) -> None:
    assert one.area == pytest.approx(other.area, rel=tolerance, abs=tolerance)
    for name in ("first", "second", "third"):
        assert getattr(one, name) == pytest.approx(getattr(other, name), rel=tolerance, abs=100 * tolerance)


@given(polygon=stars(), shift=st.tuples(number, number))
def test_moments_of_a_moved_area(polygon: Array, shift: tuple[float, float]) -> None:
    moved = np.array(shift)
    same(of_polygon(polygon + moved), of_polygon(polygon).shifted(moved))


@given(stars())
def test_a_polygon_of_curves_is_a_polygon(polygon: Array) -> None:
    closed = np.concatenate([polygon, polygon[:1]])
    lines = [Line(np.concatenate([closed, np.zeros((len(closed), 1))], axis=1))]
    same(enclosed(lines, PLANE), of_polygon(polygon))


@given(polygon=stars(), hole=st.floats(0.02, 0.1))
def test_triangles_have_the_area_of_their_polygon(polygon: Array, hole: float) -> None:
    middle = polygon.mean(axis=0)
    angles = np.arange(6) * math.pi / 3
    opening = middle + hole * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    corners, triangles = triangulated(polygon)
    assert sum(of_polygon(each).area for each in corners[triangles]) == pytest.approx(
        of_polygon(polygon).area
    )
    inside = sum(of_polygon(clipped(opening, each)).area for each in corners[triangles])
    assume(inside == pytest.approx(of_polygon(opening).area, rel=1e-9))  # a star need not hold its middle
    corners, triangles = triangulated(polygon, [opening])
    areas = [of_polygon(each).area for each in corners[triangles]]
    assert min(areas) > -1e-12
    assert sum(areas) == pytest.approx(of_polygon(polygon).area - of_polygon(opening).area)
    assert len(triangles) == len(corners), "n + 2 (holes) − 2 triangles"


@given(polygon=stars(), triangle=st.lists(st.tuples(number, number), min_size=3, max_size=3).map(np.array))
def test_what_is_cut_and_what_is_left_is_the_whole(polygon: Array, triangle: Array) -> None:
    """A polygon cut along the triangles of a large square that a triangle is a part of."""
    area = of_polygon(triangle).area
    assume(abs(area) > 0.1)
    triangle = triangle if area > 0 else triangle[::-1]
    inside = of_polygon(clipped(polygon, triangle))
    assert -1e-9 <= inside.area <= min(abs(area), of_polygon(polygon).area) + 1e-9
    corners, parts = triangulated(polygon)
    same(inside, sum((of_polygon(clipped(each, triangle)) for each in corners[parts]), Moments.none()), 1e-6)


@given(polygon=stars(), depth=st.floats(0.01, 2.0))
def test_a_prism_is_closed_and_holds_its_volume(polygon: Array, depth: float) -> None:
    from gantline.cad.mesh import TriangleMesh

    corners, cap = triangulated(polygon)
    low = np.concatenate([corners, np.zeros((len(corners), 1))], axis=1)
    mesh = TriangleMesh(*prism([polygon], cap, np.stack([low, low + np.array([0.0, 0.0, depth])])))
    assert mesh.is_closed and mesh.is_consistent
    assert mesh.volume == pytest.approx(depth * of_polygon(polygon).area)


def test_simplified_outlines_keep_their_shape() -> None:
    angles = np.linspace(0, 2 * math.pi, 2000, endpoint=False)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    few = simplified(circle, 1e-3)
    assert 70 < len(few) < 140  # π/√(2 · 1e-3) would do, halving takes up to twice as many
    assert of_polygon(few).area == pytest.approx(math.pi, abs=2 * math.pi * 1e-3)
    square = np.array([[0, 0], [0.5, 0], [1, 0], [1, 1], [0.3, 1], [0, 1], [0, 0]], dtype=float)
    assert len(simplified(square, 1e-6)) == 4


def test_gauss_points_integrate_polynomials() -> None:
    """n points are exact to degree 2n − 1: ∫x⁷ = 1/8 with four."""
    at, share = gauss(4)
    assert share @ at**7 == pytest.approx(1 / 8, rel=1e-14)


def test_a_path_has_no_point_twice() -> None:
    path: list[Curve] = [Line(np.array([[0.0, 0, 0], [1, 0, 0]])), Line(np.array([[1.0, 0, 0], [1, 1, 0]]))]
    assert len(polyline(path, 1e-3)) == 3
