"""A run ended in a traceback as it was over: its load was in a hinge, and a watched pair had come too close.

What hinges bear between samples was read from columns of the core, whose events are those of the core alone,
by the names of all events, `too_close` and `clear_again` among them, of which only the samples tell. There
were more names than times: an IndexError, and no recording of the whole run. The README of `monopile` tells
of such a lift, with the pins of its bucket on the axis of the pile.
"""

from __future__ import annotations

import numpy as np

import gantline
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from hinged_mast import FOOT, HEAD, RAISE, WEIGHT, mast

#: Beside the mast as it lies, 1 m from it, and nothing that it touches.
WALL = """\
mechanics:
  bodies:
    wall: {at: [0 m, -4 m, 6 m], joint: {type: fixed}, shape: {box: [4 m, 4 m, 12 m]}}
"""
WATCH = "watch: [{between: [mast, wall], smallest: 5 m}]\n"


def raised(more: str = "") -> Recording:
    text = mast(RAISE, more=more).replace("duration: 900 s", "duration: 120 s")
    return gantline.simulate(parse_scenario(text))


def test_what_a_hinge_bears_between_samples_is_known_beside_a_pair_that_is_too_close() -> None:
    """As without the watch, which no step sees: to the last bit.

    The foot has no less than the W (1 - 18/39) = 528 kN that it bears while the mast lies.
    """
    watched, alone = raised(WALL + WATCH), raised(WALL)
    assert [name for _, _, name in watched.events("too_close")] == ["mast - wall"]
    for name in ("hinge_peak_push", "hinge_peak_moment", "hinge_peak_time"):
        assert np.array_equal(watched[name].values, alone[name].values)
    largest = np.linalg.norm(watched["hinge_peak_push"].values, axis=-1).max()
    assert largest > WEIGHT * (1 - FOOT / HEAD) * (1 - 1e-6)
