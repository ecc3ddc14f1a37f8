"""Natural motions were asked for before any equilibrium: `Statics(lift).modes()` was an IndexError.

They are those about the equilibrium at the end of the lift then, as `Statics(lift).equilibrium()` finds it.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from spreader_lifts import one_bar


def test_modes_without_an_equilibrium_before() -> None:
    scenario = parse_scenario(one_bar())
    asked = Statics(scenario)
    asked.equilibrium()
    periods = [mode.period for mode in asked.modes(4)]
    assert [mode.period for mode in Statics(scenario).modes(4)] == pytest.approx(periods, nan_ok=True)


def test_a_step_off_without_an_equilibrium_before() -> None:
    """This one is stable."""
    assert Statics(parse_scenario(one_bar())).step_off() is None
