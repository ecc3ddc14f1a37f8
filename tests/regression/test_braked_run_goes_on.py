"""A run that went on from a state in which the brake of an emergency stop slips had other bytes.

What the brake held was kept beside the state. A run that went on took it for a brake that had just come in,
and found anew the accelerations that it had: tensions differed by millinewtons.
"""

from __future__ import annotations

import json

import numpy as np
import pytest

from gantline._core import Simulation
from mechanics import Json, body, document, drum, end, finished, flow, rope, slider

MASS, SPEED = 1e4, 0.5


def lowered() -> Json:
    """A load that is lowered; an emergency stop at 2 s throws in a brake that slips for a while."""
    load = body("load", slider(velocity=-SPEED), MASS, position=(0, 0, -30))
    winch = flow("drum", 500.0, drive="winch", capacity=2e5, velocity=SPEED)
    fall = rope("fall", 29.99, [drum(None, (0, 0, 0), "drum"), end("load")], 4e7, 0.005)
    move: Json = {"drive": "winch", "velocity": SPEED, "acceleration": 0.5}
    move["emergency"] = {"acceleration": 20.0, "brake": 1.05e5}
    plan = [
        {"name": "lower", "until": {"type": "duration", "duration": 2.0}, "moves": [move]},
        {"name": "rest", "until": {"type": "end_of_run"}},
    ]
    return document([load, winch], ropes=[fall], drives=[{"name": "winch"}], plan=plan)


@pytest.mark.parametrize("broken_off", [1.5, 2.0, 2.01, 2.3, 3.5])
def test_it_goes_on_with_the_same_bytes(broken_off: float) -> None:
    """Before the brake is in, as it comes in, while it slips, and once it holds: equal to the last bit."""
    settings = {"integrator": {"type": "adaptive"}, "duration": 4.0, "sample_interval": 0.05}
    texts = json.dumps(lowered()), json.dumps(settings)
    whole = Simulation(*texts)
    expected = finished(whole, whole.run())
    first, second = Simulation(*texts), Simulation(*texts)
    first.run(None, broken_off)
    second.restore(first.save())
    found = finished(second, second.run())
    assert expected.events("drum_slips")
    for name, values in expected.columns.items():
        assert np.array_equal(found.columns[name], values), name
