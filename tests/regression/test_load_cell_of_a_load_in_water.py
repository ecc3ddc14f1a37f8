"""Stop if the load cell differs by more than 10 % from its reading: by its first page `splash_zone` stops.

The reading was that of the manifold in the air, 65.1 t. Once it is under water, as planned, its steel
displaces 7.6 m³ and the load cell reads 12 % less, for as long as it hangs there.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.scenario import load_scenario
from shown import ROOT

IN_AIR = 65.1  # static hoist load, as the table "Hooks" has it [t]
DISPLACED = 7.6  # of its steel, `in_water` of the lift file [m^3]
DENSITY = 1.025  # sea water [t/m^3]


def test_it_is_told_what_the_load_cell_reads_in_water() -> None:
    """Two hold points, (65.1 - 1.025 * 7.6) t to 0.5 %: means over 30 s and more of waves of 6.5 s."""
    lift = load_scenario(ROOT / "scenarios/splash_zone/scenario.yaml")
    told = stop_if(Subject(gantline.simulate(lift)))[0]
    table, in_water = told.split(", which is that in air; in water from ")
    assert table.endswith("differs by more than 10 % from its reading in the table “Hooks”")
    readings, steps = zip(*(one.split(" t in ") for one in in_water.split(", ")), strict=True)
    assert steps == ("“hold below”", "“hold”")
    for reading in readings:
        assert float(reading) == pytest.approx(IN_AIR - DENSITY * DISPLACED, rel=5e-3)


def test_nothing_is_told_of_water_where_none_bears_the_load() -> None:
    lift = load_scenario(ROOT / "scenarios/equalizer/scenario.yaml")
    assert "water" not in "".join(stop_if(Subject(gantline.simulate(lift))))
