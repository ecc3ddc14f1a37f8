"""What a plan does on purpose counted against it: an equalizer that is let down, a load that is turned.

The last sling of an equalizer whose slings are let go has all that is left: 400 % of tension spread, for
10 N, where 5 % are allowed. And a hook that takes over from another as a load is turned had a dynamic factor
of 1.215 in the middle of its turn, of a motion that adds 2 %: it was held against where it hung before.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.results.loads.hung_so import has_hung_so
from gantline.results.recording import Recording
from of_recording import check_of
from sample_lift import WEIGHT, ringing_lift, sample_rig

TIME = np.linspace(0.0, 40.0, 2001)


def let_down(share: float) -> Recording:
    """Five slings of 600 kN from 10 s on, 2 % apart; from 35 s on the third alone has a share of all that."""
    carrying = np.array([600e3, 606e3, 594e3, 600e3, 600e3])
    left = np.array([0.0, 0.0, share * carrying.sum(), 0.0, 0.0])
    tension = np.where((TIME >= 35.0)[:, None], left, (TIME >= 10.0)[:, None] * carrying)
    return ringing_lift(rig=sample_rig(tension_spread_when_clear=0.05), tension=tension)


def test_little_that_is_left_has_no_spread() -> None:
    """(606 − 594)/600 kN, as long as no more than a twentieth is left; with more it counts as it is, 5."""
    recording = let_down(0.04)
    found = check_of(recording, "tension_spread_when_clear")
    assert found.value == pytest.approx(0.02) and found.verdict is Verdict.OK
    assert recording.metrics()["peak_tension_spread_when_clear"] == pytest.approx(0.02)
    found = check_of(let_down(0.06), "tension_spread_when_clear")
    assert found.value == pytest.approx(5.0) and found.verdict is Verdict.FAILED


def turned(angle: float) -> Recording:
    """It hangs still from 20 s to 29 s; from 30 s on it is turned, with 30 % more, and set down at 38 s."""
    tension = np.where((TIME >= 30.0), 780e3, (TIME >= 10.0) * 600e3)[:, None] * np.ones(5)
    stands = ((TIME < 10.0) | (TIME >= 38.0))[:, None] * np.full(4, WEIGHT / 4)
    work = np.minimum(TIME, 20.0) * 50.0 + np.clip(TIME - 29.0, 0.0, 20.0) * 50.0
    return ringing_lift(
        rig=sample_rig(sling_dynamic_factor=1.2),
        tension=tension,
        contact=stands,
        tilt=np.where(TIME >= 30.0, angle, 0.0),
        energy={"drive_work": work, "gravity": work},
    )


def test_what_turning_moves_from_hook_to_hook_is_no_dynamics() -> None:
    """Turned by 8° it may be dynamics, 780/600; by 12° nothing tells."""
    found = check_of(turned(math.radians(8.0)), "sling_dynamic_factor")
    assert found.value == pytest.approx(1.3) and found.verdict is Verdict.FAILED
    recording = turned(math.radians(12.0))
    found = check_of(recording, "sling_dynamic_factor")
    assert (found.value, found.verdict) == (None, Verdict.WARNING)
    told = "whenever the load hung still, it was turned by more than 10 deg otherwise than at the peak"
    assert told in found.remark
    assert not has_hung_so(recording, 35.0) and has_hung_so(recording, 25.0)
