"""`gantline compare` of two lifts at two places had `1.0e+05 mm` between their loads, which is 100 m."""

from __future__ import annotations

import gantline
from gantline.cli.comparison_table import comparison_table
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift


def lift_at(x: float) -> gantline.Recording:
    hung = {"S1": ("A", "1", 10.0)}
    text = hooked_lift({"A": (x, 0.0, 20.0)}, {"1": (0.0, 0.0, 4.0)}, hung, position=(x, 0.0, 6.0))
    return gantline.simulate(parse_scenario(text.replace("start: as_given", "start: rest")))


def apart(way: float) -> str:
    """The row of the load in the table of two lifts that are `way` [m] apart, blanks single."""
    lines = list(comparison_table(gantline.compare(lift_at(0.0), lift_at(way)), (None, None)))
    head = next(index for index, line in enumerate(lines) if line.startswith("Motion of the load"))
    return " ".join(lines[head + 1].split())


def test_ways_from_a_hundred_metres_on_are_in_metres() -> None:
    assert apart(250.0).startswith("load 250 m 250 m ")
    assert apart(50.0).startswith("load 50,000 mm 50,000 mm ")
