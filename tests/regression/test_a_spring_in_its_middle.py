"""A spring of a joint, both stops at one place, is as stiff in its middle as beside it.

Each of the two stops counts in an equilibrium where it pushes, and in the middle of the spring neither does:
a mast that stands plumb on a spring was "UNSTABLE: one motion leads away", with the ω² of a mast without one,
and what hangs plumb on one swung as if it had none. A microradian aside both were right.
"""

from __future__ import annotations

import math

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from mechanics import G

MASS, ARM, INERTIA, SPRING = 4000.0, 6.0, 48e3, 1e6
PLUMB = """
format: 1
lift: {title: On a spring}
duration: 2 s
start: rest
mechanics:
  bodies:
    mast:
      joint:
        type: hinge
        axis: [0, 1, 0]
        stops: {lower: 0 deg, upper: 0 deg, stiffness: 1 MN m/rad, damping: 20 kN m s, loaded: true}
      mass: 4 t
      centre_of_gravity: [0 m, 0 m, 6 m]
      inertia: {xx: 48 t m^2, yy: 48 t m^2, zz: 1 t m^2}
"""


@pytest.mark.parametrize(("side", "spring"), [(1, SPRING), (-1, SPRING), (1, 0.2e6)])
def test_plumb_on_its_spring(side: int, spring: float) -> None:
    """(I + m l²) ω² = k ∓ m g l, minus where it stands on its foot; ζ = d/(2 (I + m l²) ω) (MD2)."""
    text = PLUMB.replace("0 m, 6 m]", f"0 m, {side * ARM} m]").replace("1 MN m/", f"{spring} N m/")
    statics = Statics(parse_scenario(text))
    rest = statics.equilibrium()
    inertia = INERTIA + MASS * ARM**2
    square = (spring - side * MASS * G * ARM) / inertia
    assert rest.recording.column("joint_position", "mast")[-1] == 0.0
    assert (rest.unstable, rest.neutral) == (int(square < 0), 0)
    (mode,) = statics.modes(1)
    assert mode.square == pytest.approx(square, rel=1e-12)
    model = statics.linear_model()
    assert model.stiffness[0, 0] == pytest.approx(spring - side * MASS * G * ARM, rel=1e-12)
    assert model.damping[0, 0] == pytest.approx(20e3, rel=1e-12)
    if square > 0:
        assert mode.damping_ratio == pytest.approx(20e3 / (2 * inertia * math.sqrt(square)), rel=1e-12)
