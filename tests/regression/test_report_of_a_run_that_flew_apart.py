"""The report of a run that flew apart had a scale bar that no length fitted, and bars of less than nothing.

An explicit method with too long a step does that. The scale bar ended at 50 m: of a side view of 500 km it
was a dot whose figure was cut off. Static forces were below zero, and so were the shares of capacities
that bars show, which browsers refuse.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gantline
from gantline.report import render_report
from gantline.report.sketch import scale_bar
from gantline.report.sketch_paper import WIDTH

EQUALIZER = Path(__file__).parents[2] / "scenarios" / "equalizer" / "scenario.yaml"


@pytest.mark.parametrize("scale", [1e-3, 0.01, 0.3, 7.0, 1e3, 1e7])
def test_a_scale_bar_is_seen(scale: float) -> None:
    """Of round lengths 1, 2 and 5 the largest within 0.3 of the width takes more than 0.3/2.5 of it."""
    assert 0.3 / 2.5 <= scale_bar(scale) / scale / WIDTH <= 0.3


def test_no_bar_is_shorter_than_nothing() -> None:
    """A step of 10 ms is too long for an explicit method."""
    simulation = gantline.Simulation(EQUALIZER, integrator="explicit", step=0.01)
    with pytest.raises(gantline.SimulationError):
        simulation.run()
    page = render_report(simulation.recording())
    widths = [float(width) for width in re.findall(r'class="bar-used" width="([^"]*)"', page)]
    assert widths and min(widths) == 0.0
