"""Python values that no lift file has ended in errors from the inside, or were taken as something else.

A dictionary that holds itself ran into Python's RecursionError, a path that is a number into `'int'
object has no attribute 'split'`; a set, which has no order, became a list, and bytes a list of the
numbers of their letters; and of statics, `modes("3")`, `equilibrium(time="3 s")` and `linear_model("1
Hz")` ended in Python's own words about `<` and real numbers.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gantline
from gantline import Statics, parse_scenario
from lift_text import weight_on_a_rope

LIFT = parse_scenario(weight_on_a_rope("100 kg"))


def _holds_itself() -> dict[str, Any]:
    whole: dict[str, Any] = {"format": 1}
    whole["lift"] = whole
    return whole


def test_what_holds_itself() -> None:
    """Text may be nested 32 deep; so may values."""
    with pytest.raises(gantline.ScenarioError, match="stand in one another 33 deep; does one hold itself"):
        parse_scenario(_holds_itself())


@pytest.mark.parametrize("value", [{0, 1, 2}, b"3 s", np.array(3.0)])
def test_what_is_no_value(value: object) -> None:
    with pytest.raises(gantline.ScenarioError, match="is no value of a lift file; a text such as"):
        LIFT.changed({"duration": value})


def test_a_path_is_a_text() -> None:
    with pytest.raises(TypeError, match=r"values: 3 is no path; a text such as 'load\.weight\.calculated'"):
        LIFT.changed({3: "3 s"})  # type: ignore[dict-item]


def test_what_statics_is_asked() -> None:
    statics = Statics(LIFT)
    for count in ("3", 2.5, -1):
        with pytest.raises(ValueError, match=r"count: .* is no whole number from 0 on"):
            statics.modes(count)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="time: '3 s' is no number of seconds; the lift lasts from 0 s to"):
        statics.equilibrium(time="3 s")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="frequency: '1 Hz' is no frequency above zero in radians"):
        statics.linear_model("1 Hz")  # type: ignore[arg-type]
    assert len(statics.modes(np.int64(1))) == 1  # type: ignore[arg-type]


def test_a_folder_is_no_recording(tmp_path: Path) -> None:
    """It was said of a folder that there is no such file, and of one to write to in the words of HDF5."""
    with pytest.raises(FileNotFoundError, match="is a folder without a recording"):
        gantline.open_recording(tmp_path)
    with pytest.raises(IsADirectoryError, match="Is a directory"):
        Statics(LIFT).equilibrium().recording.save(tmp_path)


def test_a_setting_that_is_not_right() -> None:
    """The error that `simulate` promises had no public name."""
    with pytest.raises(gantline.SettingError, match="duration: -1 is not a time above zero in seconds"):
        gantline.simulate(LIFT, duration=-1)
