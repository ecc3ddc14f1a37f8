"""Checks of crawler cranes on recordings of given numbers."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.checks.crawlers import ground_pressure, tipping
from gantline.checks.measure import Found, Refused
from gantline.results.recording import Recording
from gantline.results.variable import FloatArray, Variable

CORNERS = [f"c1.{corner}" for corner in ("left.front", "left.back", "right.front", "right.back")]
EVERYWHERE = np.ones(3, dtype=np.bool_)


def recording(used: list[float], pressure: FloatArray) -> Recording:
    """Three seconds of a crane: what it uses against tipping [1], pressures under tracks, (3, 4) [Pa].

    On mats four times as wide as its tracks the ground has a quarter of that.
    """
    corners = ("time", "track_corner")
    variables = {
        "time": Variable(("time",), np.arange(3.0), "s", ""),
        "tipping_utilisation": Variable(("time", "crawler"), np.array(used)[:, None], "1", ""),
        "track_pressure": Variable(corners, pressure, "Pa", ""),
        "ground_pressure": Variable(corners, pressure / 4.0, "Pa", ""),
        "event_time": Variable(("event",), np.zeros(0), "s", ""),
        "event_kind": Variable(("event",), np.zeros(0, dtype=np.str_), "1", ""),
        "event_name": Variable(("event",), np.zeros(0, dtype=np.str_), "1", ""),
    }
    crane = {"name": "c1", "corners": CORNERS, "allowed_pressure": 150e3, "width": 1.5, "mats": 6.0}
    labels = {"crawler": ["c1"], "track_corner": CORNERS}
    return Recording(variables, labels, {"title": "", "rig": {"crawlers": [crane]}})


def test_a_crane_that_tips_is_refused() -> None:
    """At 1 nothing is left under one side: that is no share of a limit; just below it is."""
    level = np.zeros((3, 4))
    (refused,) = tipping(recording([0.5, 1.0, 0.7], level), EVERYWHERE)
    assert isinstance(refused, Refused)
    assert (refused.element, refused.reason) == (
        "c1",
        "it tips at 1.00 s: nothing is left under one side",
    )
    (found,) = tipping(recording([0.5, 0.99, 0.7], level), EVERYWHERE)
    assert isinstance(found, Found)
    assert (found.element, found.value, found.time) == ("c1", 0.99, 1.0)


def test_the_ground_bears_what_mats_leave() -> None:
    """380 kPa under the worst end of a track are 95 kPa on the ground, of 150 kPa."""
    pressure = np.array([[100e3] * 4, [100e3, 100e3, 380e3, 100e3], [200e3] * 4])
    values = {
        one.element: one.value
        for one in ground_pressure(recording([0.5] * 3, pressure), EVERYWHERE)
        if isinstance(one, Found)
    }
    assert values == pytest.approx(dict(zip(CORNERS, [50 / 150, 50 / 150, 95 / 150, 50 / 150], strict=True)))
