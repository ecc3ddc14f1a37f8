"""A long run that was restored to its start ended after one step: "1000 steps on end have led nowhere".

Whether a run gets on is asked every thousand steps, counted from the last time. That was not restored, so
it lay ahead.
"""

from __future__ import annotations

import json

import numpy as np
import pytest

from gantline import _core
from mechanics import body, document, free

SETTINGS = [{"type": "adaptive", "position_tolerance": 1e-9}, {"type": "del", "step": 1e-3}]


@pytest.mark.parametrize("integrator", SETTINGS, ids=lambda one: str(one["type"]))
def test_a_long_run_goes_again_from_its_start(integrator: dict[str, object]) -> None:
    """A top that tumbles, twice: the second run has the bytes of the first."""
    top = body("top", free((0, 0, 0), angular_velocity=[0.1, 40, 0]), 1.0, inertia=(3, 2, 1))
    system = document([top])
    settings = json.dumps({"integrator": integrator, "duration": 8.0, "sample_interval": 0.1})
    run = _core.Simulation(json.dumps(system), settings)
    start = run.save()
    assert run.run()["status"] == "done"
    assert run.counters()["steps"] > 1000
    once = run.columns()["body_position"]
    run.restore(start)
    assert run.run()["status"] == "done"
    assert np.array_equal(run.columns()["body_position"], once)
