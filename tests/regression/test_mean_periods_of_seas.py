"""A sea by Hs and Tz, as charts and forecasts have it: "known here: 'height', 'period', 'peak_period', …".

Which of them a mean period of zero crossings is, or how the peak period follows from it, nothing said, and
`period` is that of waves that are all alike.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from gantline.scenario import parse_scenario
from lift_text import AFLOAT


def ratio(enhancement: float) -> float:
    """Peak period over the mean period of zero crossings of a JONSWAP spectrum."""
    w = np.linspace(0.2, 40.0, 400_001)
    peak = np.exp(-((w - 1.0) ** 2) / (2 * np.where(w <= 1.0, 0.07, 0.09) ** 2))
    spectrum = w**-5 * np.exp(-1.25 * w**-4) * enhancement**peak
    return float(np.sqrt((w**2 * spectrum).sum() / spectrum.sum()))


@pytest.mark.parametrize("key", ["zero_crossing_period", "tz", "mean_period"])
def test_the_peak_period_is_told(key: str) -> None:
    sea = f"waves: {{sea: {{significant_height: 1.5 m, {key}: 5 s, direction: 0 deg}}}}\n"
    with pytest.raises(gantline.ScenarioError) as caught:
        parse_scenario(AFLOAT.replace("vessels:\n", f"{sea}vessels:\n"))
    said = str(caught.value)
    assert f"which is {ratio(3.3):.2f} times its mean period of zero crossings" in said
    assert f"and {ratio(1.0):.2f} times for 1" in said
