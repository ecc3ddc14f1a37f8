"""`del` said that all was well where its velocity terms had not settled: after twelve rounds it just went on.

A free body turns fast, in steps that are long for that: a round leaves more than a tenth of the last error.
"""

from __future__ import annotations

import json

import pytest

from gantline import _core
from mechanics import body, document, free


@pytest.mark.parametrize(("step", "settles"), [(1e-4, True), (1.5e-2, False)])
def test_steps_that_do_not_settle_are_counted(step: float, settles: bool) -> None:
    """Steps of 0.1 ms settle; those of 15 ms, which turn it by 24 degrees each, do not."""
    top = body("top", free((0, 0, 0), angular_velocity=[20, 1, 20]), 1.0, inertia=(3, 2, 1))
    settings = {"integrator": {"type": "del", "step": step}, "duration": 0.06, "sample_interval": 0.01}
    run = _core.Simulation(json.dumps(document([top])), json.dumps(settings))
    run.run()
    assert (run.counters()["unconverged"] == 0) == settles
