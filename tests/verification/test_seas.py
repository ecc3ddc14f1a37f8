"""Heights of waves up to which a lift keeps its limits, against a closed form."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from column_in_waves import column, least_tension
from gantline.checks import Outcome
from gantline.scenario import parse_scenario
from gantline.study import run_seas

LIMIT = 715e3
PERIODS = (30.0, 40.0)


def limit_height(period: float) -> float:
    """Height in which a column that hangs in long waves is as light as may be [m]."""
    return float(brentq(lambda height: least_tension(height, period) - LIMIT, 0.0, 6.0, xtol=1e-9))


@pytest.mark.parametrize("period", PERIODS)
def test_the_height_at_which_a_column_gets_too_light(period: float) -> None:
    """A column half in the water on one sling, in long regular waves: hydrostatics with Airy's pressure.

    On its sling, of 13 MN/m, it follows the tenth of the tension that comes and goes a share (ω/ω₀)² too far:
    3.3e-4 of that in 30 s, 4e-5 of all. The limit is crossed within 1e-3 of the height, 67 N of 715 kN.
    """
    most = limit_height(period)
    heights = [0.5 * most, 0.999 * most, 1.001 * most, 1.5 * most]
    lift = parse_scenario(column(least=f"{LIMIT} N"))
    found = run_seas(lift, heights=heights, periods=[period])
    low, under, over, high = found.seas
    assert [sea.outcome for sea in found.seas] == [Outcome.GO, Outcome.GO, Outcome.NO_GO, None]
    assert found.allowed_height(lift.waves["swell"].direction, period) == heights[1]  # type: ignore[index]
    for sea in (low, under, over):
        assert sea.worst is not None and sea.worst.governing is not None
        check = sea.worst.governing
        assert check.name == "smallest_sling_tension_when_clear"
        assert check.value == pytest.approx(least_tension(sea.height, period), rel=5e-5)
    assert high.records == () and not high.is_too_steep
    assert np.isfinite(high.highest)
