"""Atwood's machine with a sheave whose axis points the other way.

The rope then runs round the sheave from the other side and crosses itself: it lies on it by 203 degrees, not
180, and pulls nearly as it should. Nothing said so.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {{title: a sheave and its axis}}
duration: 0.1 s
ropes:
  thin: {{axial_stiffness: 1 MN, damping_time: 10 ms, diameter: 10 mm}}
mechanics:
  bodies:
    left: {{at: [{left}], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 2 kg}}
    right: {{at: [{right}], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 2 kg}}
  ropes:
    over:
      rope: thin
      length: as_routed
      route:
        - {{type: end, body: left}}
        - {{type: sheave, body: world, at: [0 m, 0 m, 5 m], axis: [0, {axis}, 0], diameter: 1 m}}
        - {{type: end, body: right}}
"""


def told(axis: int, left: str = "-0.5 m, 0 m, 0 m", right: str = "0.5 m, 0 m, 0 m") -> list[str]:
    recording = gantline.simulate(parse_scenario(LIFT.format(axis=axis, left=left, right=right)))
    warnings: list[str] = recording.attributes["warnings"]
    return [one for one in warnings if "crosses itself" in one]


def test_an_axis_the_other_way_round_is_told() -> None:
    """Each tangent leans by a = 2 atan(r/5 m): the wrap is 180 deg + 2 a, and they meet r/tan(a) away."""
    lean = 2 * math.atan(0.5 / 5.0)
    (said,) = told(-1)
    assert f"route[2] by {180 + 2 * math.degrees(lean):.0f} deg" in said
    away = float(said.split("crosses itself ")[1].split(" m from there")[0])
    assert away == pytest.approx(0.5 / math.tan(lean), abs=0.005 + 1e-9), "in three digits, 2.475 m"
    assert said.endswith("does 'axis' point the other way?")


@pytest.mark.parametrize(
    ("axis", "left", "right"),
    [
        (1, "-0.5 m, 0 m, 0 m", "0.5 m, 0 m, 0 m"),
        # More than half a turn, but too short to meet.
        (1, "-0.4 m, 0 m, 4 m", "0.4 m, 0 m, 4 m"),
        # Askew, so that one part passes the other by 50 mm.
        (-1, "-0.5 m, -0.05 m, 0 m", "0.5 m, 0.05 m, 0 m"),
    ],
)
def test_a_rope_that_does_not_cross_says_nothing(axis: int, left: str, right: str) -> None:
    assert told(axis, left, right) == []
