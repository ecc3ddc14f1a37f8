"""A fender that touched was shown as the set-down of the load.

A module that hangs from the start on over a cargo barge stands on her at 119 s. Pictures showed it hanging at
0.00 s under "set-down": that was when the fenders between the barges first pressed.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.plot.moments import moments, stages
from gantline.results.recording import Recording
from sample_lift import sample_recording


def hung(events: list[tuple[float, str, str]], pressed: float) -> Recording:
    """A load that hangs at 0, 1 and 2 s and has this force under each corner at 3 and 4 s [N]."""
    contact = np.repeat([0.0, 0.0, 0.0, pressed, pressed], 4).reshape(5, 4)
    tension = np.repeat([5e5, 5e5, 6e5, 2e5, 2e5], 5).reshape(5, 5)
    return sample_recording(np.arange(5.0), tension=tension, contact=contact, events=events)


@pytest.mark.parametrize("shown", [moments, stages])
def test_a_fender_that_touches_sets_nothing_down(shown: object) -> None:
    events = [(0.0, "set_down", "fender.ps"), (2.6, "set_down", "block"), (2.8, "set_down", "fender.sb")]
    assert callable(shown)
    found = {one.name: one.time for one in shown(hung(events, 1e5))}
    assert found["set-down"] == 2.6


@pytest.mark.parametrize("shown", [moments, stages])
def test_nothing_is_set_down_where_only_fenders_touch(shown: object) -> None:
    assert callable(shown)
    assert "set-down" not in {one.name for one in shown(hung([(1.0, "set_down", "fender.ps")], 0.0))}
