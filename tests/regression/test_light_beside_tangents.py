"""A light sheave in a lift that has a sheave with true tangents.

Before a step is looked at it is asked whether ropes have tangents at its end. That divided the rope over
light sheaves from where an earlier look had left it, and before the first look there was none: a panic.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline

LIFT = """\
format: 1
lift: {{title: two weights over a light sheave with losses}}
duration: 1 s
ropes: {{r: {{axial_stiffness: 1 MN, damping_time: 5 ms}}}}
mechanics:
  bodies:
    post: {{joint: {{type: fixed}}, mass: 1 kg}}
    B: {{at: [-0.5 m, 0 m, -4 m], joint: {{type: slider, axis: ["0", "0", "1"]}}, mass: 40 kg}}
    C: {{at: [0.5 m, 0 m, -4 m], joint: {{type: slider, axis: ["0", "0", "1"]}}, mass: 30 kg}}
    D: {{at: [4.5 m, 0 m, -4 m], joint: {{type: slider, axis: ["0", "0", "1"]}}, mass: 5 kg}}
    E: {{at: [5.5 m, 0 m, -4 m], joint: {{type: slider, axis: ["0", "0", "1"]}}, mass: 5 kg}}
  ropes:
    r:
      {{rope: r, length: 11.5708 m, route: [{{type: end, body: B}}, {{body: post, {sheave},
       efficiency: 0.9, rotating_mass: 0 kg}}, {{type: end, body: C}}]}}
    beside:
      {{rope: r, length: 11.5708 m, route: [{{type: end, body: D}},
       {{type: sheave, body: post, at: [5 m, 0 m, 1 m], axis: ["0", "1", "0"], diameter: 1 m}},
       {{type: end, body: E}}]}}
"""


SHEAVES = {
    "tangents": 'type: sheave, at: [0 m, 0 m, 1 m], axis: ["0", "1", "0"], diameter: 1 m',
    "half turn": "type: half_turn, enter: [-0.5 m, 0 m, 1 m], leave: [0.5 m, 0 m, 1 m], bulge: [0, 0, 1]",
}


@pytest.mark.parametrize("sheave", SHEAVES)
def test_it_runs_and_follows_the_closed_form(tmp_path: Path, sheave: str) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(LIFT.format(sheave=SHEAVES[sheave]), encoding="utf-8")
    recording = gantline.simulate(path)
    # T = 40 kg (g - a), 0.9 T = 30 kg (g + a).
    a = (0.9 * 40.0 - 30.0) / (0.9 * 40.0 + 30.0) * 9.81
    half, whole = np.searchsorted(recording.time, [0.5 - 1e-9, 1.0 - 1e-9])
    speed = recording.column("body_velocity", "C")[[half, whole], 2]
    # Ringing, 70 rad/s with a damping of 0.17, has gone by e^-6 and e^-12; the strain is 357 N/1 MN.
    assert (speed[1] - speed[0]) / 0.5 == pytest.approx(a, rel=3.6e-4)
    low, high = np.sort(recording["sheave_tension"].values[-1, 0])
    assert high / low == pytest.approx(1.0 / 0.9, rel=1e-5)
