"""A pin that could not be put in since its hinge turned was told in metres per second."""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest

from gantline._core import Simulation
from mechanics import Json, body, document, hinge, slider

#: Speed of the joint [rad/s or m/s].
SPEED = 0.25


@pytest.mark.parametrize(("joint", "unit"), [(hinge, "rad/s"), (slider, "m/s")])
def test_its_speed_has_its_unit(joint: Callable[..., Json], unit: str) -> None:
    """Without gravity the joint keeps its speed."""
    moving = joint([0, 1, 0], velocity=SPEED, pin=False)
    step: Json = {"name": "pin it", "pins": ["arm"], "until": {"type": "end_of_run"}, "start_at": 0.1}
    system = document([body("arm", moving, 10.0, inertia=[1, 1, 1])], plan=[step]) | {"gravity": [0, 0, 0]}
    settings = {"integrator": {"type": "adaptive"}, "duration": 1.0, "sample_interval": 0.1}
    status = Simulation(json.dumps(system), json.dumps(settings)).run()
    assert (
        status["cause"]
        == f"its pin cannot be put in while it moves by 0.250 {unit}; hold until it is at rest"
    )
