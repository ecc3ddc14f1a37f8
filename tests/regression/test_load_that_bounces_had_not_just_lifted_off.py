"""A load that came down as a sling was cut was told to be hoisted off faster.

`set_down_softly` of `equalizer_sling_cut` said "it had just lifted off; hoist it off faster" at 45.17 s: the
load had hung from 19.9 s on, a sling is cut at 40 s, and it bounces since it came down at 40.6 s.
"""

from __future__ import annotations

import pytest

import gantline
from of_recording import checks_of


def test_it_bounces_since_it_came_down() -> None:
    recording = gantline.simulate(gantline.load_scenario("equalizer_sling_cut"))
    [check] = checks_of(recording, "set_down_softly")
    events = [(time, kind) for time, kind, name in recording.events() if name == "block"]
    came_off, came_down = events[0][0], events[1][0]
    assert came_off < 20.0 and came_down == pytest.approx(40.6, abs=0.05)  # the story's digit
    assert f"it came down at {came_down:.2f} s, and bounces" in check.remark
