"""A recording made by hand of a time and a tension alone was saved, and `open_recording` refused it as
damaged by another program; `metrics` of it ended with "no variable 'rope_peak_tension'" of a recording that
has none to offer.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.results import Recording, Variable
from sample_lift import ringing_lift


def part() -> Recording:
    tension = Variable(("time", "rope"), np.array([[1e3], [2e3]]), "N", "tension")
    time = Variable(("time",), np.array([0.0, 1.0]), "s", "time")
    return Recording({"time": time, "rope_tension": tension}, {"rope": ["a"]}, {"rig": {}})


def test_a_part_of_a_recording_is_not_saved(tmp_path: Path) -> None:
    said = "can be read again, and of this one attribute 'settings' is missing"
    with pytest.raises(ValueError, match=said):
        part().save(tmp_path / "part.nc")
    assert not list(tmp_path.iterdir())


def test_metrics_of_a_part_say_what_is_missing() -> None:
    whole = ringing_lift()
    some = {name: one for name, one in whole.variables.items() if name != "rope_peak_tension"}
    with pytest.raises(ValueError, match="of this one variable 'rope_peak_tension' is missing"):
        Recording(some, whole.coordinates, whole.attributes).metrics()


def test_one_made_of_another_is_saved(tmp_path: Path) -> None:
    whole = ringing_lift()
    other = Recording(whole.variables, whole.coordinates, {**whole.attributes, "title": "mine"})
    assert gantline.open_recording(other.save(tmp_path / "mine.nc")).title == "mine"
