"""A run that was saved and taken up again ended some steps later than one that went through.

Whether a run gets on is asked every thousand steps, and when it was asked last was no part of a saved state:
a run that was taken up began to count anew. So one that stands still, its moving sheave between the fixed
ones, ended after 2031 steps instead of 2000, at another time and with another recording.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


def failed(run: gantline.Simulation) -> gantline.SimulationError:
    with pytest.raises(gantline.SimulationError, match="come to the next place") as caught:
        run.run()
    return caught.value


def test_a_sheave_that_comes_to_the_next_place() -> None:
    """The end of a run without a pause, and of one that went on from a state: time, state and tensions."""
    changes = {"slings.S4.cut_at": "19.7512 s", "equalizers.e1.hinge.friction": "5 kN m", "start": "rest"}
    lift = gantline.load_scenario(SCENARIOS / "equalizer").changed(changes)
    through = failed(gantline.Simulation(lift, duration=20.0))
    before = gantline.Simulation(lift, duration=20.0)
    before.run(until=10.0)
    after = gantline.Simulation(lift, duration=20.0)
    after.restore(before.save())
    resumed = failed(after)
    assert resumed.time == through.time
    assert resumed.state == through.state
    assert np.array_equal(resumed.recording["rope_tension"].values, through.recording["rope_tension"].values)
