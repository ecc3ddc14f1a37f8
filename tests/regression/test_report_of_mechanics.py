"""The report of a pendulum: an empty player, and "stop if a hook load is off its reading by 10 %".

Bodies of `mechanics` without a `shape` were not drawn at all, and the first page had weights, reasons to
stop and signatures of a lift, whatever it was about.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from four_slings import LIFT
from gantline.assembly import assemble
from gantline.report.page import render_report
from gantline.scenario import parse_scenario

PENDULUM = """\
format: 1
lift: {title: a pendulum}
duration: 0.1 s
mechanics:
  bodies:
    frame: {joint: {type: fixed}}
    bob:
      joint: {type: hinge, axis: [0, 1, 0], position: 30 deg}
      mass: 7.85 t
      centre_of_gravity: [0 m, 0 m, -2 m]
"""


def test_a_body_without_a_shape_is_drawn_as_steel_of_its_mass() -> None:
    """7.85 t of steel are a cubic metre; what has no mass and no shape is not drawn."""
    bodies = {body["name"]: body["shape"] for body in assemble(parse_scenario(PENDULUM)).scene["bodies"]}
    assert bodies["frame"] is None
    assert bodies["bob"]["centre"] == [0.0, 0.0, -2.0]
    assert np.array(bodies["bob"]["size"]) == pytest.approx(np.ones(3), rel=1e-12)


@pytest.mark.parametrize(("text", "is_lift"), [(PENDULUM, False), (LIFT, True)])
@pytest.mark.usefixtures("player")
def test_only_a_lift_has_reasons_to_stop_it(text: str, is_lift: bool) -> None:
    recording = gantline.simulate(parse_scenario(text))
    html = render_report(recording)
    assert ("<h2>Stop if</h2>" in html) is is_lift
    assert ('class="signatures"' in html) is is_lift
