"""What rights a vessel beside another, with fenders that stick between them.

The equilibria where a run begins and ends held friction, and a vessel that fenders hold to its neighbour
heels with that: the cargo barge of `off_a_barge`, empty in the end, had a GM of 35.5 m, the crane barge
of 26.1 m. A limit `metacentric_height` of 25 m was kept by both in a run, while `gantline statics` had
24.6 and 21.6 m and failed.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.checks import Verdict
from gantline.scenario import load_scenario
from of_recording import checks_of

SCENARIO = Path(__file__).parents[2] / "scenarios" / "off_a_barge" / "scenario.yaml"
#: Cargo barge without its load: mass, height of its centre of gravity; sides of its waterplane [t, m].
MASS, CENTRE, LENGTH, BREADTH = 2820.0, (1000 * 2.2 + 1820 * 1.0) / 2820, 60.0, 24.0


def test_friction_of_fenders_is_no_stability() -> None:
    """GM = KB + BM - KG of the empty barge, to 1 % for how it is pressed on; the run has what statics has."""
    # The load has been off for 35 s by then, and is still hauled up.
    changes = {"limits.metacentric_height": "25 m", "duration": "110 s"}
    scenario = load_scenario(SCENARIO).changed(changes)
    run = gantline.simulate(scenario)
    draft = MASS / (1.025 * LENGTH * BREADTH)
    own = draft / 2 + BREADTH**2 / 12 / draft - CENTRE
    ended = {vessel.name: vessel.righting[-1] for vessel in run.rig.vessels}
    assert ended["cargo"][0] == pytest.approx(run.time[-1])
    assert ended["cargo"][1] == pytest.approx(own, rel=0.01)
    rest = gantline.Statics(scenario).equilibrium().recording
    for vessel in rest.rig.vessels:
        assert ended[vessel.name][1] == pytest.approx(vessel.righting[-1][1], rel=1e-3)
    for found in (run, rest):
        [check] = checks_of(found, "metacentric_height")
        assert check.verdict is Verdict.FAILED
