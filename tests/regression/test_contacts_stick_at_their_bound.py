"""Whether a load that had slid until its rope held it sticks there was said by rounding.

A box slides down a slope until friction and rope hold it: its contact carries all that it can. Of eighty such
boxes, all alike but for masses, friction and the direction of their ropes, 36 stuck in motions and
sensitivities and 44 slid. Where the lift was not followed any further, at its start, a box was held across
the way that it had slid by b/s, friction over that way, in place of the spring of its contact, as if it still
slid. Joints with dry friction that had given way at the start went on giving way.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.scenario import Scenario, parse_scenario
from gantline.statics import Statics

MASS, G, EA, LENGTH, CONTACT, ASIDE = 2000.0, 9.81, 2e6, 5.0, 1e7, math.radians(30.0)


def box(friction: float, above: float, heading: float) -> tuple[Scenario, list[float]]:
    """A box on a slope that falls towards `heading` [rad], its rope up the slope and `above` that [rad]; the
    rope's upper end.
    """
    x, y = math.cos(heading), math.sin(heading)
    rise = math.cos(ASIDE) * math.cos(above) - math.sin(ASIDE) * math.sin(above)
    height = math.sin(ASIDE) * math.cos(above) + math.cos(ASIDE) * math.sin(above)
    at = [float(LENGTH * part) for part in (-rise * x, -rise * y, height)]
    scenario = parse_scenario(f"""
format: 1
lift: {{title: A box on a slope}}
duration: 10 s
start: rest
ropes: {{line: {{axial_stiffness: {EA} N}}}}
mechanics:
  bodies: {{box: {{joint: {{type: point}}, mass: {MASS} kg}}}}
  ropes:
    line:
      rope: line
      length: {LENGTH} m
      route:
        - {{type: end, body: world, at: [{at[0]!r} m, {at[1]!r} m, {at[2]!r} m]}}
        - {{type: end, body: box}}
  contacts:
    foot:
      body: box
      plane:
        point: [0 m, 0 m, 0 m]
        normal: [{math.sin(ASIDE) * x!r}, {math.sin(ASIDE) * y!r}, {math.cos(ASIDE)!r}]
      stiffness: {CONTACT} N/m
      friction: {friction!r}
""")
    return scenario, at


@pytest.mark.parametrize("time", [0.0, 10.0])
def test_what_has_slid_sticks_along_its_way_and_across(time: float) -> None:
    """K = k 1 + k₁ d dᵀ + T/ℓ (1 − d dᵀ), contact and rope, k₁ = EA/L, d and ℓ direction and length of the
    rope where the box stands: ω² m is k + k₁ along d and k + T/ℓ across it twice, and dT/dm is
    g d_z k₁/(k + k₁).
    """
    numbers = np.random.default_rng(1)
    own = EA / LENGTH
    for place in range(12):
        friction, above = numbers.uniform(0.1, 0.45), numbers.uniform(0.0, 1.0)
        heading = numbers.uniform(0.0, 2 * math.pi) if place % 2 else 0.0
        scenario, top = box(friction, above, heading)
        statics = Statics(scenario)
        rest = statics.equilibrium(time, losses="held")
        rope = np.array(top) - rest.recording.column("body_position", "box")[-1]
        length = float(np.linalg.norm(rope))
        across = rest.tension("line") / length
        assert length > LENGTH + 1e-3, "it has slid until its rope held it"
        squares = [mode.square * MASS for mode in statics.modes(3)]
        assert squares == pytest.approx([CONTACT + across] * 2 + [CONTACT + own], rel=1e-9)
        (found,) = statics.sensitivities([("mass", "box")])
        assert found.of("line") == pytest.approx(G * rope[2] / length * own / (own + CONTACT), rel=1e-8)


@pytest.mark.parametrize("time", [0.0, 4.0])
def test_a_slider_that_gave_way_sticks_where_it_stands(time: float) -> None:
    """A weight on a rope, T = m g − F after it has slid; there it has no motion, its rope no more of it."""
    friction = 5e3
    statics = Statics(
        parse_scenario(f"""
format: 1
lift: {{title: A slider with dry friction}}
duration: 10 s
start: rest
ropes: {{line: {{axial_stiffness: {EA} N}}}}
mechanics:
  bodies: {{box: {{joint: {{type: slider, axis: [0, 0, 1], friction: {friction} N}}, mass: {MASS} kg}}}}
  ropes:
    line: {{rope: line, length: 5 m, route: [{{type: end, body: world, at: [0 m, 0 m, 5 m]}}, {{type: end, body: box}}]}}
""")  # noqa: E501
    )
    rest = statics.equilibrium(time, losses="held")
    assert rest.tension("line") == pytest.approx(MASS * G - friction, rel=1e-8)
    assert len(statics.linear_model().held) == 1
    (found,) = statics.sensitivities([("mass", "box")])
    assert found.of("line") == pytest.approx(0.0, abs=1e-6)
