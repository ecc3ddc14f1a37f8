"""Numbers of slings lay on each other and on lugs in the plan of the first page, where many slings are near.

Room was an ellipse about each number, but a text is as wide at its foot as in its middle: in the plan of
`floating_crane` "H1.1" lay on "H1.2", which hid three lugs and ended under the centre of gravity.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from gantline.report.sketch import sketches
from gantline.report.sketch_names import has_room, hides_none, text_box
from gantline.report.subject import Subject
from sample_lift import ringing_lift


def test_a_number_hides_no_lug() -> None:
    lugs = [np.array([x, 20.0]) for x in (10.0, 13.0, 16.0)]
    assert hides_none(text_box(10.0, 17.8, "H1.1"), lugs)
    assert not hides_none(text_box(10.0, 19.0, "H1.1"), lugs)
    assert hides_none(text_box(10.0, 19.0, "H1.1"), lugs[2:])


@pytest.mark.parametrize("down", [0.0, 2.6, 3.3])
def test_numbers_that_touch_have_no_room(down: float) -> None:
    """Two of four letters, 7 mm wide, with their middles 5 mm apart: within 3.4 mm of height they overlap."""
    first, second = text_box(20.0, 20.0, "H1.1"), text_box(25.0, 20.0 + down, "H1.2")
    assert not has_room(second, [first])


def test_the_plan_of_a_lift_with_dense_slings() -> None:
    """The numbers that are shown lie apart and leave all lugs in sight."""
    _, plan = sketches(Subject(ringing_lift()))
    numbers = [text_box(mark.x, mark.y, mark.text) for mark in plan.marks if mark.style == "sk-number"]
    lugs = [np.array([mark.x, mark.y]) for mark in plan.marks if mark.style == "sk-lug"]
    assert len(numbers) == 5
    assert all(has_room(one, [other]) for one, other in combinations(numbers, 2))
    assert all(hides_none(one, lugs) for one in numbers)
