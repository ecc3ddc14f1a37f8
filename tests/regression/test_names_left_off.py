"""A name that is not there was answered with the first twelve that are, as if these were all.

Of the fifteen segments of `equalizer` those of three slings were missing from the list of what there is.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.results.recording import Recording
from gantline.results.variable import Variable


def asked(count: int, label: str) -> str:
    names = [f"sling.S{k}" for k in range(1, count + 1)]
    tension = Variable(("time", "rope"), np.zeros((1, count)), "N", "")
    recording = Recording(
        {"time": Variable(("time",), np.zeros(1), "s", ""), "t": tension}, {"rope": names}, {}
    )
    with pytest.raises(KeyError) as caught:
        recording.column("t", label)
    return str(caught.value.args[0])


def test_how_many_are_left_off_is_said() -> None:
    assert asked(15, "sling.X").endswith("sling.S11, sling.S12 and 3 more")


def test_all_are_told_where_they_are_few() -> None:
    assert asked(12, "sling.X").endswith("sling.S11, sling.S12")


def test_those_that_are_likely_come_first() -> None:
    assert asked(15, "S14") == "t has no 'S14'; it has sling.S14"
