"""The input at the end of a report said `1 ropes`, and `paper False, geometric stiffness True` of the method.

The first of a lift with one rope, as the pulleys of section 4.1 of the paper; the second are words of Python.
"""

from __future__ import annotations

import gantline
from gantline.report import render_report
from gantline.scenario import parse_scenario

LIFT = """\
format: 1
lift: {title: A weight on a rope}
duration: 20 ms
simulation: {integrator: del, step: 1 ms, sample_interval: 10 ms}
ropes: {steel: {axial_stiffness: 1 MN, mass: none}}
mechanics:
  bodies:
    weight: {at: [0 m, 0 m, 0 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 1 kg}
  ropes:
    fall: {rope: steel, length: as_routed, route: [{type: end, body: weight},
      {type: end, body: world, at: [0 m, 0 m, 2 m]}]}
"""


def test_one_of_a_kind_and_settings_are_in_words() -> None:
    page = render_report(gantline.simulate(parse_scenario(LIFT)))
    assert "3 samples, 1 rope, 1 body" in page
    assert "paper no, geometric stiffness yes" in page
