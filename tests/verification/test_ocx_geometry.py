"""Mass, centre of gravity and inertia of OCX parts against closed forms, equation beside each number."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import pytest

from gantline.cad.mass_properties import MassProperties
from gantline.cad.model import Part
from gantline.cad.ocx.curves import Arc, Curve, Line
from gantline.cad.ocx.moments import Frame, enclosed
from gantline.cad.ocx.reader import read_ocx
from gantline.cad.ocx.section import Section
from gantline.cad.ocx.sweep import EndCut, Inclination, swept
from ocx_files import SQUARE, Writer

RHO = 7850.0
W = Writer()
Z = np.array([0.0, 0.0, 1.0])


def only(vessel: str, *, sections: str = "", holes: str = "") -> Part:
    """The one part of a file."""
    model = read_ocx(W.file(vessel, sections=sections, holes=holes), "test.3docx")
    (part,) = model.parts
    assert part.properties is not None, part.doubts
    return part


def body(part: Part) -> MassProperties:
    assert part.properties is not None
    return part.properties


# --- plates ---------------------------------------------------------------------------------------


def test_a_plate_is_a_box() -> None:
    """m (b² + c²)/12 about each axis of a box a × b × c, its own inertia across the thickness included."""
    part = only(W.plate("P", W.polygon(SQUARE), 0.02))
    mass = RHO * 2 * 2 * 0.02
    thin, thick = mass * (2**2 + 0.02**2) / 12, mass * (2**2 + 2**2) / 12
    assert body(part).mass == pytest.approx(mass, rel=1e-13)
    assert body(part).centre == pytest.approx([1.0, 1.0, 0.0], abs=1e-13)
    assert body(part).inertia == pytest.approx(np.diag([thin, thin, thick]), rel=1e-12, abs=1e-9)
    assert part.mesh.is_closed and part.mesh.is_consistent
    assert RHO * part.mesh.volume == pytest.approx(mass, rel=1e-12)


def test_a_disc_with_a_round_hole_is_a_ring() -> None:
    """Ring of radii R, r: A = π(R² − r²), I = m (R² + r²)/2 about its axis, half of it + m t²/12 across."""
    hole = W.hole("round", "ParametricCircle", {"Diameter": 0.6})
    cut = f"<ocx:PlateCutBy>{W.placed_hole('round', (5.0, 0.0, 1.0))}</ocx:PlateCutBy>"
    part = only(W.plate("P", W.circle((5.0, 0.0, 1.0), (0.0, 0.0, 1.0), 2.0), 0.01, more=cut), holes=hole)
    outer, inner, t = 1.0, 0.3, 0.01
    mass = RHO * t * math.pi * (outer**2 - inner**2)
    along, across = mass * (outer**2 + inner**2) / 2, mass * ((outer**2 + inner**2) / 4 + t**2 / 12)
    assert body(part).mass == pytest.approx(mass, rel=1e-13)
    assert body(part).centre == pytest.approx([5.0, 0.0, 1.0], abs=1e-12)
    assert body(part).inertia == pytest.approx(np.diag([across, across, along]), rel=1e-11, abs=1e-9)
    assert part.mesh.is_closed


def test_a_rational_nurbs_circle_is_a_circle() -> None:
    """Nine control points of degree 2 with weights √½ at the corners are a circle: A = π R²."""
    corner = math.sqrt(0.5)
    ring = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    points = [(1.5 * x, 1.5 * y, 0.0) for x, y in ring]
    knots = [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0]
    contour = W.nurbs(2, knots, points, [1.0, corner] * 4 + [1.0])
    assert body(only(W.plate("P", contour))).mass == pytest.approx(RHO * 0.01 * math.pi * 1.5**2, rel=1e-12)


def test_a_cubic_nurbs_is_integrated_exactly() -> None:
    """Below y = x − x³ from 0 to 1: A = 1/4, x̄ A = 2/15, ȳ A = 4/105, and I by hand.

    The curve is a polynomial of degree 3 in x: Bézier points (0, 0), (⅓, ⅓), (⅔, ⅔), (1, 0).
    """
    third = 1.0 / 3.0
    points = [(0.0, 0.0, 0.0), (third, third, 0.0), (2 * third, 2 * third, 0.0), (1.0, 0.0, 0.0)]
    arc = W.nurbs(3, [0.0] * 4 + [1.0] * 4, points, [1.0] * 4)
    part = only(W.plate("P", arc + W.line((1.0, 0.0, 0.0), (0.0, 0.0, 0.0)), 0.01))
    area, sheet = 0.25, RHO * 0.01
    first = np.array([2.0 / 15.0, 4.0 / 105.0])  # ∫x(x − x³) = ⅓ − ⅕;  ½∫(x − x³)² = ½(⅓ − ⅖ + 1/7)
    xx = 1.0 / 12.0  # ∫x²(x − x³) = ¼ − ⅙
    yy = (0.25 - 0.5 + 0.375 - 0.1) / 3.0  # ⅓∫(x − x³)³ = ⅓(¼ − 3/6 + 3/8 − 1/10)
    xy = 0.5 * (0.25 - 1.0 / 3.0 + 1.0 / 8.0)  # ½∫x(x − x³)² = ½(¼ − 2/6 + ⅛)
    centre = first / area
    assert body(part).mass == pytest.approx(sheet * area, rel=1e-13)
    assert body(part).centre[:2] == pytest.approx(centre, rel=1e-13)
    own = sheet * area * 0.01**2 / 12
    inertia = body(part).inertia
    assert inertia[0, 0] == pytest.approx(sheet * (yy - area * centre[1] ** 2) + own, rel=1e-11)
    assert inertia[1, 1] == pytest.approx(sheet * (xx - area * centre[0] ** 2) + own, rel=1e-11)
    assert inertia[0, 1] == pytest.approx(-sheet * (xy - area * centre[0] * centre[1]), rel=1e-11)


@pytest.mark.parametrize(
    ("shape", "size", "area"),
    [
        ("RectangularHole", {"Width": 0.6, "Height": 0.4}, 0.6 * 0.4 - (4 - math.pi) * 0.2**2),
        ("RectangularHole", {"Width": 0.6, "Height": 0.4, "FilletRadius": 0.0}, 0.6 * 0.4),
        ("RectangularHole", {"Width": 0.6, "Height": 0.4, "FilletRadius": 0.1}, 0.24 - (4 - math.pi) * 0.01),
        ("SymmetricalHole", {"Width": 0.6, "Height": 0.4}, 0.2 * 0.4 + math.pi * 0.2**2),
        ("SuperElliptical", {"Width": 0.6, "Height": 0.4}, math.pi * 0.3 * 0.2),
    ],
)
def test_holes_of_the_catalogue_have_their_areas(shape: str, size: dict[str, float], area: float) -> None:
    """Rounded rectangle b h − (4 − π) r², two half discs and a rectangle, ellipse π a b/4."""
    cut = f"<ocx:PlateCutBy>{W.placed_hole('hole', (1.0, 1.0, 0.0))}</ocx:PlateCutBy>"
    part = only(W.plate("P", W.polygon(SQUARE), more=cut), holes=W.hole("hole", shape, size))
    assert body(part).mass == pytest.approx(RHO * 0.01 * (4.0 - area), rel=1e-12)
    assert RHO * part.mesh.volume == pytest.approx(
        body(part).mass, rel=1e-3
    )  # the picture's tolerance is 1 mm


def test_a_super_ellipse_of_degree_4_has_its_area() -> None:
    """4 a b Γ(1 + 1/e)²/Γ(1 + 2/e) for half axes a, b; drawn with 720 chords it lacks some millionths."""
    hole = W.hole("hole", "SuperElliptical", {"Width": 0.6, "Height": 0.4}, ' exponent="4"')
    cut = f"<ocx:PlateCutBy>{W.placed_hole('hole', (1.0, 1.0, 0.0))}</ocx:PlateCutBy>"
    area = 4 * 0.3 * 0.2 * math.gamma(1.25) ** 2 / math.gamma(1.5)
    mass = body(only(W.plate("P", W.polygon(SQUARE), more=cut), holes=hole)).mass
    assert mass == pytest.approx(RHO * 0.01 * (4.0 - area), rel=1e-5)


def test_an_opening_over_the_edge_takes_what_it_covers() -> None:
    """A disc of radius r whose centre is on a straight edge takes half of itself, π r²/2."""
    cut = f"<ocx:PlateCutBy>{W.placed_hole('hole', (0.0, 1.0, 0.0))}</ocx:PlateCutBy>"
    hole = W.hole("hole", "ParametricCircle", {"Diameter": 0.6})
    part = only(W.plate("P", W.polygon(SQUARE), more=cut), holes=hole)
    # The opening is a polygon here, whose sides miss the circle by at most a millimetre.
    assert body(part).mass == pytest.approx(RHO * 0.01 * (4.0 - math.pi * 0.3**2 / 2), rel=3e-4)
    assert any("over its edge" in doubt for doubt in part.doubts)


def test_an_opening_beside_the_plate_takes_nothing() -> None:
    """A cut-out of a panel cuts the plates that it touches."""
    cut = f"<ocx:CutBy>{W.placed_hole('hole', (5.0, 5.0, 0.0))}</ocx:CutBy>"
    panel = W.panel("deck", W.plate("P", W.polygon(SQUARE)), more=cut)
    part = only(panel, holes=W.hole("hole", "ParametricCircle", {"Diameter": 0.6}))
    assert body(part).mass == pytest.approx(RHO * 0.04, rel=1e-13) and part.doubts == ()


# --- curved plates --------------------------------------------------------------------------------

_CYLINDER = (
    "<ocx:UnboundedGeometry>"
    "<ocx:Cylinder3D>{origin}{axis}{radius}{height}</ocx:Cylinder3D>"
    "</ocx:UnboundedGeometry>"
)


def test_a_bilge_plate_is_a_quarter_of_a_cylinder() -> None:
    """A = π/2 R L; centre of gravity at 2R/π from both planes of the quarter; facets settle to 1e-4."""
    radius, length, root = 1.5, 4.0, 1.5 * math.sqrt(0.5)
    contour = (
        W.arc((0.0, radius, 0.0), (0.0, root, root), (0.0, 0.0, radius))
        + W.line((0.0, 0.0, radius), (length, 0.0, radius))
        + W.arc((length, 0.0, radius), (length, root, root), (length, radius, 0.0))
        + W.line((length, radius, 0.0), (0.0, radius, 0.0))
    )
    surface = _CYLINDER.format(
        origin=W.point("Origin", (-1.0, 0.0, 0.0)),
        axis=W.direction("Axis", (1.0, 0.0, 0.0)),
        radius=W.length("Radius", radius),
        height=W.length("Height", 6.0),
    )
    part = only(W.plate("P", contour, 0.012, more=surface))
    assert part.doubts == ()
    assert body(part).mass == pytest.approx(RHO * 0.012 * math.pi / 2 * radius * length, rel=2e-4)
    assert body(part).centre == pytest.approx([2.0, 2 * radius / math.pi, 2 * radius / math.pi], abs=1e-3)


def test_a_dome_is_the_whole_of_its_surface() -> None:
    """A hemisphere ends where its flat contour runs: A = 2πR², centre of gravity at R/2."""
    radius = 0.8
    # A NURBS half circle turned once about z: five by nine control points, weights √½ and ½ between.
    profile = [((1.0, 0.0), 1.0), ((1.0, 1.0), math.sqrt(0.5)), ((0.0, 1.0), 1.0)]
    ring = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    points, weights = [], []
    for (out, up), own in profile:
        for number, (x, y) in enumerate(ring):
            points.append((radius * out * x, radius * out * y, radius * up))
            weights.append(own * (math.sqrt(0.5) if number % 2 else 1.0))
    controls = "".join(
        W.point("ControlPoint", at, f' weight="{weight!r}"')
        for at, weight in zip(points, weights, strict=True)
    )
    surface = (
        "<ocx:UnboundedGeometry><ocx:NURBSSurface>"
        '<ocx:U_NURBSproperties degree="2"/><ocx:UknotVector value="0 0 0 1 1 2 2 3 3 4 4 4"/>'
        '<ocx:V_NURBSproperties degree="2"/><ocx:VknotVector value="0 0 0 1 1 1"/>'
        f"<ocx:ControlPtList>{controls}</ocx:ControlPtList></ocx:NURBSSurface></ocx:UnboundedGeometry>"
    )
    part = only(W.plate("P", W.circle((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 2 * radius), more=surface))
    assert body(part).mass == pytest.approx(RHO * 0.01 * 2 * math.pi * radius**2, rel=3e-4)
    assert body(part).centre == pytest.approx([0.0, 0.0, radius / 2], abs=1e-3)


# --- bars -----------------------------------------------------------------------------------------


def flat_bar(width: float, height: float) -> Section:
    corners = np.array([[0, 0, 0], [width, 0, 0], [width, height, 0], [0, height, 0], [0, 0, 0]], dtype=float)
    return Section.of("flat", [[Line(corners)]], (width, height))


def round_bar(diameter: float) -> Section:
    circle = Arc.circle(np.array([diameter / 2, diameter / 2, 0.0]), Z, diameter)
    return Section.of("round", [[circle]], (diameter, diameter), True)


def bar(
    trace: Sequence[Curve],
    section: Section,
    offset: npt.ArrayLike = (0.0, 0.0),
    inclinations: Sequence[Inclination] = (),
    ends: tuple[EndCut | None, EndCut | None] = (None, None),
) -> tuple[MassProperties, float]:
    """Mass properties at a density of one, and the volume of the triangles."""
    stands = inclinations or [Inclination(Z, None, trace[0].start)]
    found = swept(trace, section, np.asarray(offset, dtype=float), stands, 1.0, 1e-4, ends)
    assert found.mesh.is_closed and found.mesh.is_consistent
    return found.properties, found.mesh.volume


def test_a_straight_bar_is_a_box() -> None:
    """m (b² + c²)/12 about each axis; the box stands on the trace line by its corner."""
    part = only(W.bar("S", W.line((0.0, 0.0, 0.0), (3.0, 0.0, 0.0))))
    mass = RHO * 3.0 * 0.2 * 0.01
    size = np.array([3.0, 0.01, 0.2])
    squares = size**2
    assert body(part).mass == pytest.approx(mass, rel=1e-13)
    assert body(part).centre == pytest.approx([1.5, 0.005, 0.1], abs=1e-13)
    assert np.diag(body(part).inertia) == pytest.approx(mass * (squares.sum() - squares) / 12, rel=1e-12)


def test_a_round_bar_bent_to_a_ring_is_a_torus() -> None:
    """V = 2π²Rr²; I = m (R² + ¾ r²) about the axis, m (½ R² + ⅝ r²) across: third moments of the section."""
    big, small = 0.5, 0.1
    ring = [Arc.circle(np.zeros(3), Z, 2 * big)]
    stands = [Inclination(Z, None, np.array([big, 0.0, 0.0]))]
    found, volume = bar(ring, round_bar(2 * small), (-small, -small), stands)
    mass = 2 * math.pi**2 * big * small**2
    across = mass * (big**2 / 2 + 5 * small**2 / 8)
    assert found.mass == pytest.approx(mass, rel=1e-12)
    assert found.inertia == pytest.approx(
        np.diag([across, across, mass * (big**2 + 0.75 * small**2)]), rel=1e-11, abs=1e-12
    )
    assert volume == pytest.approx(mass, rel=1e-2)


def test_a_face_bar_around_an_opening_follows_pappus() -> None:
    """A flat bar outside a circle of radius R: V = 2π (R + b/2) A, a thin short tube."""
    part = only(
        W.bar(
            "E",
            W.circle((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 1.0),
            at=(0.5, 0.0, 0.0),
            flange=(1.0, 0.0, 0.0),
            offset=(0.0, -0.1),
            tag="EdgeReinforcement",
        )
    )
    mass = RHO * math.pi * (0.51**2 - 0.5**2) * 0.2
    assert body(part).mass == pytest.approx(mass, rel=1e-12)
    assert body(part).centre == pytest.approx(np.zeros(3), abs=1e-12)
    assert body(part).inertia[2, 2] == pytest.approx(mass * (0.51**2 + 0.5**2) / 2, rel=1e-12)


def test_the_web_stays_upright_along_a_bent_trace() -> None:
    """A stiffener inside a bilge: its web points to the axis all along, V = A R(1 − h/2R) φ."""
    radius, angle = 2.0, math.pi / 2
    trace = [Arc(np.zeros(3), np.array([0.0, radius, 0.0]), np.array([0.0, 0.0, radius]), 0.0, angle)]
    inwards = Inclination(np.array([0.0, -1.0, 0.0]), np.array([1.0, 0.0, 0.0]), np.array([0.0, radius, 0.0]))
    found, _ = bar(trace, flat_bar(0.01, 0.3), (0.0, 0.0), [inwards])
    assert found.mass == pytest.approx(0.01 * angle / 2 * (radius**2 - (radius - 0.3) ** 2), rel=1e-12)
    assert found.centre[0] == pytest.approx(0.005, rel=1e-12)


def test_twist_keeps_the_volume_and_turns_the_section() -> None:
    """Over a quarter turn of a bar of height h the mean of its web is 2/π (1, 1); its centre is h/2 along."""
    trace = [Line(np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]))]
    stands = [
        Inclination(np.array([0.0, 0.0, 1.0]), None, np.array([0.0, 0.0, 0.0])),
        Inclination(np.array([0.0, 1.0, 0.0]), None, np.array([1.0, 0.0, 0.0])),
    ]
    thin = flat_bar(1e-6, 0.4)
    found, _ = bar(trace, thin, (0.0, 0.0), stands)
    assert found.mass == pytest.approx(0.4e-6, rel=1e-12)
    # The arc length up to a Gauss point, by which the twist goes, is known to a hundredth.
    assert found.centre == pytest.approx([0.5, 0.2 * 2 / math.pi, 0.2 * 2 / math.pi], rel=2e-3)


def test_a_sniped_end_is_cut_off() -> None:
    """The side loses c h and (h − n)²/(2 tan α), a triangle with its centre at n + ⅔(h − n)."""
    h, b, length, cutback, nose, angle = 0.2, 0.01, 2.0, 0.05, 0.02, math.radians(30)
    cut = EndCut(cutback, angle, nose)
    trace = [Line(np.array([[0.0, 0.0, 0.0], [length, 0.0, 0.0]]))]
    found, volume = bar(trace, flat_bar(b, h), (0.0, 0.0), (), (cut, None))
    reach = (h - nose) / math.tan(angle)
    pieces = [  # area, x, z of what is left: the whole, less the cutback, less the snipe
        (length * h, length / 2, h / 2),
        (-cutback * h, cutback / 2, h / 2),
        (-reach * (h - nose) / 2, cutback + reach / 3, nose + 2 * (h - nose) / 3),
    ]
    area = sum(piece for piece, _, _ in pieces)
    assert found.mass == pytest.approx(b * area, rel=1e-12)
    assert found.centre[0] == pytest.approx(sum(a * x for a, x, _ in pieces) / area, rel=1e-12)
    assert found.centre[2] == pytest.approx(sum(a * z for a, _, z in pieces) / area, rel=1e-12)
    # The triangles have no corner at the nose, so they cut from the foot to the top.
    assert volume == pytest.approx(found.mass, rel=2e-2)


def test_a_sniped_end_in_a_file() -> None:
    """End cuts of a file: cutback 50 mm at one end, a snipe of 45° from a nose of 20 mm at the other."""
    one = f"<ocx:EndCutEnd1>{W.length('CutbackDistance', 0.05)}</ocx:EndCutEnd1>"
    other = (
        f"<ocx:EndCutEnd2>{W.length('CutbackDistance', 0.0)}"
        f'<ocx:WebCutBackAngle numericvalue="45" unit="G"/>{W.length("WebNoseHeight", 0.02)}</ocx:EndCutEnd2>'
    )
    part = only(W.bar("S", W.line((0.0, 0.0, 0.0), (2.0, 0.0, 0.0)), more=one + other))
    assert body(part).mass == pytest.approx(RHO * 0.01 * (2.0 * 0.2 - 0.05 * 0.2 - 0.18**2 / 2), rel=1e-12)


def test_moments_of_a_half_disc() -> None:
    """ȳ = 4R/3π, ∫y² = πR⁴/8, ∫y³ = 4R⁵/15, ∫x²y = 2R⁵/15."""
    radius = 1.3
    frame = Frame(np.zeros(3), np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]))
    arc = Arc(np.zeros(3), np.array([radius, 0.0, 0.0]), np.array([0.0, radius, 0.0]), 0.0, math.pi)
    found = enclosed([arc], frame)
    assert found.area == pytest.approx(math.pi * radius**2 / 2, rel=1e-13)
    assert found.first[1] / found.area == pytest.approx(4 * radius / (3 * math.pi), rel=1e-13)
    assert found.second[1, 1] == pytest.approx(math.pi * radius**4 / 8, rel=1e-13)
    assert found.third[1, 1, 1] == pytest.approx(4 * radius**5 / 15, rel=1e-12)
    assert found.third[0, 0, 1] == pytest.approx(2 * radius**5 / 15, rel=1e-12)
