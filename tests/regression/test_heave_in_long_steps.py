"""A drive that compensates heave forgot its course in steps of `del` of more than 0.1 s.

Two glances fell into one step. The second dropped all that was asked for before the first, so that the
drive was nowhere as the step began, and the step took the way from there as its own: `onto_a_platform` by
steps of 0.25 s stopped at 43 s, since no rope was left at its hook.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.scenario import load_scenario
from gantline.simulation import Simulation


def test_several_glances_in_one_step() -> None:
    """What is added to the hoist is the same by steps of 0.25 s and of 0.05 s, but for what the longer ones
    see late: a quarter of a second of a heave of 0.3 m/s at most.
    """
    scenario = load_scenario("onto_a_platform")
    found = []
    for step in ("0.25 s", "0.05 s"):
        changes = {
            "simulation.integrator": "del",
            "simulation.step": step,
            "simulation.sample_interval": "1 s",
        }
        run = Simulation(scenario.changed(changes)).run(until=60.0)
        found.append(run["heave_compensation"].values[:, 0])
    assert np.ptp(found[1]) > 0.3
    assert found[0] == pytest.approx(found[1], abs=0.075)
