"""What a step requires to be above a bound, in waves: of the whole waves before its end the least counts.

The largest counted there, as of what has to be below: a load that stood on its barge again in every trough,
with 40 % of its weight, hung by 100 % in the crests and met `load_transferred: above 99 %`; slings that fell
to 118 kN met `sling_tension: above 400 kN`. A column that tilted by 87 to 89 deg was `above 88 deg`.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from gantline.checks import Verdict, check_recording
from gantline.checks.check import Check
from sample_lift import WEIGHT, sample_recording, sample_rig

PERIOD, RISE = 8.0, 24.0  # of the waves; three of them [s]
MEAN, SWING = 588.6e3, 0.8  # tension of a sling [N], share by which it rises and falls


def required(key: str, side: str, limit: float, *, in_waves: bool = True) -> Check:
    """The check of a requirement at 38 s, of a lift of which all goes as sin(2 pi t/8 s); 38 s is a crest."""
    time = np.linspace(0.0, 40.0, 401)
    wave = -np.sin(2 * math.pi * time / PERIOD)
    rig: dict[str, Any] = sample_rig()
    rig["plan"][0]["require"] = {key: {side: limit}}
    rig["sea"] = {"components": [], "rise_time": RISE} if in_waves else None
    carried = np.maximum(-wave, 0.0) * 0.4 * WEIGHT
    recording = sample_recording(
        time,
        rig=rig,
        tension=MEAN * np.outer(1 + SWING * wave, np.ones(5)),
        contact=np.repeat(carried[:, None] / 4, 4, axis=1),
        tilt=np.radians(5.0 + wave),
        events=[(0.0, "step_begin", "hoist"), (38.0, "step_end", "hoist")],
    )
    return next(one for one in check_recording(recording) if one.step == "hoist")


@pytest.mark.parametrize(
    ("key", "limit", "least", "last"),
    [
        ("load_transferred", 0.99, 0.6, 1.0),
        ("sling_tension", 400e3, (1 - SWING) * MEAN, (1 + SWING) * MEAN),
        ("load_tilt", math.radians(5.0), math.radians(4.0), math.radians(6.0)),
    ],
)
def test_above_asks_for_the_least(key: str, limit: float, least: float, last: float) -> None:
    """In the troughs, of which the sample at 34 s and those 8 s before have the bottom."""
    found = required(key, "above", limit)
    assert found.verdict is Verdict.FAILED
    assert found.value == pytest.approx(least, rel=1e-9)
    assert found.time is not None and (found.time - 34.0) % PERIOD == pytest.approx(0.0, abs=1e-9)
    # Without waves its last sample counts.
    still = required(key, "above", limit, in_waves=False)
    assert still.verdict is Verdict.OK
    assert still.time == pytest.approx(38.0)
    assert still.value == pytest.approx(last, rel=1e-9)


@pytest.mark.parametrize(("limit", "verdict"), [(6.1, Verdict.OK), (5.9, Verdict.FAILED)])
def test_below_asks_for_the_largest(limit: float, verdict: Verdict) -> None:
    found = required("load_tilt", "below", math.radians(limit))
    assert found.verdict is verdict
    assert found.value == pytest.approx(math.radians(6.0), rel=1e-9)
