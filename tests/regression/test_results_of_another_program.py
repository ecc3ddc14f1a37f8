"""Whoever put a `Recording` together from what another program had found, to compare it, met `KeyError:
'settings'` in `compare`, "'numpy.ndarray' object has no attribute 'dims'" where an array stood in place of a
variable, and "'list' object has no attribute 'size'" of `CommonTime.of`, of which no page told.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import gantline
from gantline.results import Recording, Variable
from gantline.results.common_time import CommonTime
from sample_lift import ringing_lift

TIME = Variable(("time",), np.linspace(0.0, 1.0, 11), "s", "time")


def test_what_is_no_whole_recording_is_told() -> None:
    mine = Recording({"time": TIME}, {}, {"title": "mine"})
    told = "is no whole recording of a lift: attribute 'rig' is missing; CommonTime of gantline.results"
    with pytest.raises(ValueError, match=f"^B {told}"):
        gantline.compare(ringing_lift(), mine)
    with pytest.raises(ValueError, match=f"^A {told}"):
        gantline.compare(mine, ringing_lift())


def test_an_array_is_no_variable() -> None:
    arrays: Any = {"time": np.linspace(0.0, 1.0, 11)}
    with pytest.raises(
        TypeError, match=r"time: a variable is needed, not ndarray; gantline\.results\.Variable\("
    ):
        Recording(arrays, {}, {})


def test_series_of_lists_are_compared() -> None:
    """B - A of t² at 0, 1, 2 s and of t at 0, 2 s is 0 and 4 - 2 = 2 at the two times that both have."""
    common = CommonTime.of([0.0, 2.0], [0.0, 1.0, 2.0])
    assert common is not None
    off = common.deviation("m", common.difference([0, 2], [0, 1, 4]))
    assert (off.largest, off.time) == (2.0, 2.0)
    assert off.rms == pytest.approx(np.sqrt(2.0))  # trapezoid of 0 and 4 over 2 s, over 2 s


def test_rows_that_do_not_fit_are_told() -> None:
    with pytest.raises(ValueError, match="times_b: is no row of times"):
        CommonTime.of([0.0, 1.0], [1.0, 0.0])
    common = CommonTime.of([0.0, 1.0], [0.0, 1.0])
    assert common is not None
    with pytest.raises(ValueError, match=r"a series of shape \(3,\) has no value for each of 2 times"):
        common.difference([0.0, 1.0], [0.0, 1.0, 2.0])
