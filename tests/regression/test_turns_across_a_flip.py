"""Quaternions of a body that turns all the way round changed their sign from one sample to the next.

They were made of rotation matrices one by one, each with the sign that its largest part gave it. Between two
such samples the player went through no attitude at all, and drew noise.
"""

from __future__ import annotations

import json

import numpy as np

from gantline import _core
from mechanics import body, document, free


def test_a_body_that_turns_round_has_attitudes_that_follow_one_another() -> None:
    """Three turns about an oblique axis, half a radian a sample: neighbours are cos(0.25) alike."""
    spin = 10.0 * np.array([1.0, 2.0, 2.0]) / 3.0
    turning = free((0, 0, 0), angular_velocity=spin.tolist())
    system = document([body("ball", turning, 1.0, inertia=(1, 1, 1))])
    settings = json.dumps({"integrator": {"type": "adaptive"}, "duration": 2.0, "sample_interval": 0.05})
    run = _core.Simulation(json.dumps(system), settings)
    run.run()
    attitude = run.columns()["body_orientation"][:, 0]
    assert attitude[0] @ [1, 0, 0, 0] > 0.0
    alike = np.sum(attitude[1:] * attitude[:-1], axis=1)
    np.testing.assert_allclose(alike, np.cos(0.25), atol=1e-6)
