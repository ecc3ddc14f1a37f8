"""A half turn could not be on the world, as ends, eyes and sheaves can.

`body: world` of a `half_turn` was answered by "'world' is not a body" and a list of bodies, and a fixed
body had to be invented to carry the sheave.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline

G = 9.81
LIFT = """\
format: 1
lift: {title: "Atwood's machine"}
duration: 1 s
ropes: {thin: {axial_stiffness: 1 GN, damping_time: 1 ms}}
mechanics:
  bodies:
    post: {joint: {type: fixed}}
    left: {at: [-0.5 m, 0 m, 10 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 3 kg}
    right: {at: [0.5 m, 0 m, 10 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 2 kg}
  ropes:
    over:
      rope: thin
      length: as_routed
      route:
        - {type: end, body: left}
        - {type: half_turn, body: BODY, enter: [-0.5 m, 0 m, 15 m], leave: [0.5 m, 0 m, 15 m], bulge: [0, 0, 1], rotating_mass: 1 kg}
        - {type: end, body: right}
"""  # noqa: E501


def test_it_is_as_on_a_fixed_body() -> None:
    """Atwood's machine with a sheave of rotating mass J: a = (m₁ - m₂) g/(m₁ + m₂ + J) = g/6."""
    end = {}
    for body in ("world", "post"):
        recording = gantline.simulate(gantline.parse_scenario(LIFT.replace("BODY", body)))
        end[body] = recording.column("body_velocity", "right")[-1]
    # The rope starts unstretched; its ringing, at first 2 mm/s, is damped out within milliseconds.
    assert end["world"][2] == pytest.approx(G / 6, rel=1e-5)
    assert np.allclose(end["world"], end["post"], rtol=0, atol=1e-12)
