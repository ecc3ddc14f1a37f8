"""What wind and current push with is no slope of an energy: tangents at rest are not symmetric there."""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline

SPEED, DENSITY, AREA, COEFFICIENT = 20.0, 1.225, 100.0, 1.2
DRAG = 0.5 * DENSITY * COEFFICIENT * AREA  # c of (WC1) [N s²/m²]
MASS, ASIDE, BELOW, GRAVITY = 4000.0, 0.8, 2.0, 9.81
EXTENSIBLE, LENGTH, UPRIGHT = 2e6, 10.0, 5e6

#: A carriage on a rope, a spring that bears what moves up and down on it, and a vane that hangs on that. The
#: vane's area is on its hinge, so wind does not turn it, and turns with it: it hangs aslant, since its centre
#: of gravity is aside.
VANE = f"""
format: 1
lift: {{title: A vane that hangs aslant}}
duration: 20 s
start: rest
wind: {{speed: {SPEED} m/s, direction: 0 deg}}
ropes:
  line: {{axial_stiffness: {EXTENSIBLE} N}}
mechanics:
  bodies:
    carriage: {{joint: {{type: slider, axis: [1, 0, 0]}}, mass: 500 kg}}
    lift:
      parent: carriage
      joint:
        {{type: slider, axis: [0, 0, 1], stops: {{lower: 0 mm, upper: 1e-9 m, stiffness: {UPRIGHT} N/m}}}}
      mass: 300 kg
    vane:
      parent: lift
      joint: {{type: hinge, axis: [0, 1, 0]}}
      mass: {MASS} kg
      centre_of_gravity: [{ASIDE} m, 0 m, {-BELOW} m]
      wind_areas: {{face: {{area: {AREA} m^2, coefficient: {COEFFICIENT}, along: x}}}}
  ropes:
    stay:
      rope: line
      length: {LENGTH} m
      route: [{{type: end, body: world, at: [{-LENGTH} m, 0 m, 0 m]}}, {{type: end, body: carriage}}]
"""


def test_a_vane_that_hangs_aslant() -> None:
    """The plumb through its centre of gravity is at tan θ = a/b of the vane; its area, turned by θ, is pushed
    along by c u² cos² θ = T. So dT/da = −c u² sin 2θ dθ/da with dθ/da = b/(a² + b²), while a pull on the
    carriage turns nothing: of ∂²V/∂x∂θ and ∂²V/∂θ∂x, which a potential would have alike, one is c u² sin 2θ
    and one is zero. With x' the axis of the area and e the wind's, D = c u x' (cos θ e + x')ᵀ along x and z.
    """
    statics = gantline.Statics(gantline.parse_scenario(VANE))
    rest = statics.equilibrium()
    angle, push = math.atan2(ASIDE, BELOW), DRAG * SPEED**2
    assert rest.tension("stay") == pytest.approx(push * math.cos(angle) ** 2, rel=1e-9)
    (aside,) = statics.sensitivities([("centre_x", "vane")])
    turn = BELOW / (ASIDE**2 + BELOW**2)
    assert aside.of("stay") == pytest.approx(-push * math.sin(2 * angle) * turn, rel=1e-6)
    assert aside.of_body("vane")[4] == pytest.approx(turn, rel=1e-6)

    model = statics.linear_model()
    assert model.coordinates == ("carriage", "lift", "vane")
    stiffness, damping = model.stiffness, model.damping
    assert stiffness[0, 0] == pytest.approx(EXTENSIBLE / LENGTH, rel=1e-9)
    assert stiffness[0, 2] == pytest.approx(push * math.sin(2 * angle), rel=1e-9)
    assert stiffness[1, 2] == pytest.approx(push * math.cos(2 * angle), rel=1e-9)
    assert stiffness[2, :2] == pytest.approx([0.0, 0.0], abs=1e-9 * push)
    assert stiffness[2, 2] == pytest.approx(MASS * GRAVITY * math.hypot(ASIDE, BELOW), rel=1e-9)
    axis, along = np.array([math.cos(angle), -math.sin(angle)]), np.array([1.0, 0.0])
    assert damping[:2, :2] == pytest.approx(
        DRAG * SPEED * np.outer(axis, math.cos(angle) * along + axis), rel=1e-9
    )


BARGE = """
format: 1
lift: {title: A barge on lines in wind and current}
duration: 10 s
wind: {speed: 12 m/s, direction: 50 deg}
current: {speed: 1 m/s, direction: 200 deg}
ropes:
  chain: {axial_stiffness: 90 MN, mass: 40 kg/m, damping_time: 50 ms}
  fibre: {axial_stiffness: 20 MN, damping_time: 100 ms, mass: none}
vessels:
  barge:
    draft: 3 m
    hull: {box: [60 m, 20 m, 6 m]}
    masses: {all: {mass: 3690 t, at: [30.4 m, 0.1 m, 3 m]}}
    radii_of_gyration: [6 m, 17 m, 18 m]
    wind_areas:
      side: {area: 300 m^2, coefficient: 1.2, along: y, at: [35 m, 0 m, 8 m]}
      front: {area: 100 m^2, coefficient: 1.2, along: x, at: [35 m, 0 m, 8 m]}
    current_areas: {side: {area: 180 m^2, coefficient: 1.0, along: y, at: [28 m, 0 m, 1.5 m]}}
mooring_lines:
  one: {vessel: barge, fairlead: [60 m, 8 m, 6 m], to: [260 m, 90 m, -25 m], length: 222 m, rope: chain,
        sea_bed: -25 m}
  two: {vessel: barge, fairlead: [60 m, -8 m, 6 m], to: [230 m, -120 m, -25 m], length: 209 m, rope: chain,
        sea_bed: -25 m}
  aft: {vessel: barge, fairlead: [0 m, 0 m, 6 m], to: [-180 m, 20 m, -25 m], length: 187 m, rope: chain,
        sea_bed: -25 m}
  spring: {vessel: barge, type: spring, fairlead: [0 m, 10 m, 6 m], to: [-30 m, 70 m, 3 m], length: 66 m,
           rope: fibre}
"""


@pytest.mark.parametrize(
    ("kind", "name", "path", "given", "step"),
    [
        ("mass", "barge", "vessels.barge.masses.all.mass", 3690e3, 500.0),
        ("centre_x", "barge", "vessels.barge.masses.all.at.x", 30.4, 2e-3),
        ("centre_y", "barge", "vessels.barge.masses.all.at.y", 0.1, 2e-3),
        ("length", "mooring.spring", "mooring_lines.spring.length", 66.0, 2e-3),
    ],
)
def test_a_barge_in_wind_and_current(kind: str, name: str, path: str, given: float, step: float) -> None:
    """Tensions, place and attitude of a moored barge over its mass, its centre of gravity and a line, against
    differences of fourth order of equilibria. By the symmetric half of the tangent some were off by
    two thirds.
    """
    lift, unit = gantline.parse_scenario(BARGE), "kg" if kind == "mass" else "m"
    lines = ["mooring.one", "mooring.two", "mooring.aft", "mooring.spring"]

    def values(shift: float) -> np.ndarray:
        rest = gantline.Statics(lift.changed({path: f"{given + shift} {unit}"})).equilibrium()
        place = rest.recording.column("body_position", "barge")[-1]
        return np.array([*(rest.tension(line) for line in lines), *place])

    at = {k: values(k * step) for k in (-2, -1, 1, 2)}
    wanted = (8 * (at[1] - at[-1]) - (at[2] - at[-2])) / (12 * step)
    statics = gantline.Statics(lift)
    statics.equilibrium()
    (found,) = statics.sensitivities([(kind, name)])
    assert [found.of(line) for line in lines] == pytest.approx(wanted[:4], rel=1e-6, abs=1e-6 / step)
    if not kind.startswith("centre"):  # the shift itself is not part of a motion
        assert found.of_body("barge")[:3] == pytest.approx(wanted[4:], rel=1e-6, abs=1e-9 / step)
