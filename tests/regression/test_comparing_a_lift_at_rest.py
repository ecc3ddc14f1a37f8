"""`gantline compare` of a lift at rest with a run of it, and of runs that end between two samples.

A recording of `gantline statics -o` has two samples: where the lift starts, with no force in anything, and
the equilibrium. Both were compared: slings differed by all of their tension, the load by where it is given
from where it rests, and the second sample counted as energy from nowhere of a run that had "FAILED".
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.cli.comparison_table import comparison_table
from gantline.scenario import Scenario, parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from hooked_lift import hooked_lift
from mechanics import G

MASS = 45e3
HOOKS = {"A": (0.0, 0.0, 19.5)}
LUGS = {"1": (-3.0, 0.0, 4.0), "2": (3.0, 0.0, 4.0)}
SLINGS = {"S1": ("A", "1", 10.0), "S2": ("A", "2", 10.0)}


def lift(more: str = "") -> Scenario:
    text = hooked_lift(HOOKS, LUGS, SLINGS, mass=MASS, position=(0.0, 0.0, 6.0), more=more)
    return parse_scenario(text.replace("as_given", "rest"))


@pytest.mark.parametrize("at_rest_first", [True, False])
def test_a_run_is_compared_with_it_at_its_moment(at_rest_first: bool) -> None:
    """A run that starts at rest stays there: no difference but rounding, of tensions of m g/2 and more."""
    rest, run = Statics(lift()).equilibrium(5.0).recording, Simulation(lift()).run()
    found = gantline.compare(*((rest, run) if at_rest_first else (run, rest)))
    assert found.common is not None and found.common.times.tolist() == [5.0]
    for one in (*found.ropes, *found.hooks):
        assert one.deviation is not None and one.peak_a.value > MASS * G / 2
        assert abs(one.deviation.largest) < 1e-6 * MASS * G
    (load,) = found.loads
    assert load.position is not None and load.position.largest < 1e-6
    of_rest, of_run = found.stability if at_rest_first else reversed(found.stability)
    assert next(iter(of_rest.sentences())) == "at rest at 5 s"
    assert of_rest.is_sound and of_run.is_sound and of_rest.energy_gain is None
    assert "  Compared at 5 s alone, at rest." in comparison_table(found, (None, None))


def test_two_at_rest_at_other_times_have_none_in_common() -> None:
    statics = Statics(lift())
    rests = [statics.equilibrium(time).recording for time in (4.0, 6.0)]
    found = gantline.compare(*rests)
    assert found.common is None
    assert found.metrics["peak_sling_tension"].absolute == pytest.approx(0.0, abs=1e-3)


def test_a_run_ends_at_its_duration() -> None:
    """10 s with samples at 0, 3, 6, 9 and 10 s: they are compared to the end of both."""
    run = Simulation(lift("simulation: {sample_interval: 3 s}\n")).run()
    found = gantline.compare(Simulation(lift()).run(), run)
    assert [side.end for side in found.stability] == [10.0, 10.0]
    assert found.common is not None and np.allclose(found.common.times, [0.0, 3.0, 6.0, 9.0, 10.0])
    assert next(iter(found.stability[1].sentences())) == "ran to its end, 10 s"
