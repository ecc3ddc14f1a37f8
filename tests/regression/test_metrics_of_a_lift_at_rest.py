"""Metrics of a lift at rest that were those of where it starts, or of no moment at all.

A recording of an equilibrium has two samples, where the lift starts and where it rests, and the last alone
counts. Metrics took the largest of both: `floating_crane` at rest at its end had a trim of 1.35 deg and a
freeboard of 2.08 m, those of its start, for 0.01 deg and 3.09 m. They knew a moment of lift-off, the time
that was asked for, and a dynamic amplification factor of 1, so `gantline compare` of a run with a lift at
rest said that this came clear 28 s later.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from four_slings import LIFT
from gantline.cli.comparison_table import comparison_table
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario

WEIGHT = 40e3 * 9.81


@pytest.fixture(scope="module")
def rest() -> Recording:
    return gantline.Statics(parse_scenario(LIFT)).equilibrium().recording


def test_what_presses_at_the_start_is_no_peak_at_rest(rest: Recording) -> None:
    """Any variable that has more at the start than at rest, 0.1 and 0.02."""
    tilt = rest["load_tilt"]
    changed = {**rest.variables, "load_tilt": type(tilt)(tilt.dims, np.array([[0.1], [0.02]]), "rad", "tilt")}
    found = Recording(changed, rest.coordinates, rest.attributes).metrics()
    assert found["peak_load_tilt"] == 0.02


def test_vessels_at_rest_lie_as_they_lie_then() -> None:
    """Barge and cargo barge, whose drafts change as the load goes from one to the other."""
    found = gantline.Statics("off_a_barge").equilibrium().recording
    metrics = found.metrics()
    start, rest = found["vessel_freeboard"].values
    assert start.min() < rest.min() - 0.05 and metrics["least_freeboard"] == rest.min()
    assert metrics["peak_trim"] == max(abs(metrics[f"final_trim.{name}"]) for name in ("barge", "cargo"))


def test_nothing_lifts_off_at_rest(rest: Recording) -> None:
    """What is told from the start still is: the hook is as much higher as the plan has hoisted it."""
    metrics = rest.metrics()
    of_a_run = {"lift_off_time", "peak_sling_tension_time", "dynamic_amplification_factor"}
    assert not of_a_run & metrics.keys()
    assert metrics["static_hook_load"] == pytest.approx(metrics["peak_hook_load"])
    assert metrics["peak_hook_load"] > WEIGHT
    hoisted = np.diff(rest.column("joint_position", "crane"))[-1]
    assert metrics["final_joint_travel.crane"] == hoisted > 0.2


def test_a_run_and_a_lift_at_rest_have_no_lift_off_to_compare(rest: Recording) -> None:
    run = gantline.simulate(parse_scenario(LIFT))
    assert "lift_off_time" in run.metrics()
    lines = comparison_table(gantline.compare(run, rest), (None, None))
    for words in ("lift-off at", "dynamic amplification factor of a sling"):
        (line,) = (line for line in lines if line.strip().startswith(words))
        assert line.split()[-3:] == ["-", "-", "-"]
