"""`gantline ballast --tanks rowx` of sixteen tanks row1.1 to row4.4 was asked `did you mean 'row4.4'?`, the
last of sixteen words that are equally near. Its table, and that of `gantline statics --level`, had −51.7 t
beside -0.011 deg: two kinds of minus, of which one is no character of ASCII.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.cli.table import signed
from gantline.scenario.errors import closest, nearest
from gantline.study.ballast_question import QuestionError, tanks_that_may_change

TANKS = [f"row{row}.{tank}" for row in range(1, 5) for tank in range(1, 5)]


def test_none_of_many_is_meant() -> None:
    assert nearest("rowx", TANKS).startswith("known here: 'row1.1', 'row1.2', ")
    with pytest.raises(QuestionError, match=r"'rowx' is not a tank of barge; known here: 'row1\.1'"):
        tanks_that_may_change(gantline.load_scenario("floating_crane"), "barge", ["rowx"])


def test_one_that_is_nearer_is() -> None:
    assert closest("row11", TANKS) == "row1.1"
    assert closest("e1.6", ["e1.1", "e1.2", "hook"]) in ("e1.1", "e1.2")


def test_signs_of_changes_are_those_of_values() -> None:
    assert signed(-51.7e3, "t", 1) == "-51.7 t"
    assert signed(14.7e3, "t", 1) == "+14.7 t"
    assert signed(-1e-9, "mm", 1) == signed(1e-9, "mm", 1) == "0.0 mm"
