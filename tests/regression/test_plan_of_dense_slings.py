"""Numbers of slings lay on each other and on lugs in the plan of the first page, where many slings are near.

A number stood under the dot of a hook that was a little beside its lug in the plan, too.

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
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from hooked_lift import hooked_lift
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


@pytest.mark.parametrize("aside", [0.0, 0.2, 0.3, 0.5])
def test_a_number_keeps_off_a_hook_beside_its_lug(aside: float) -> None:
    """One millimetre of the plan is 0.13 m: a number above its lug was under a hook 0.3 m aside of it."""
    hooks = {"A": (-3.0, aside, 14.0), "B": (3.0, -aside, 14.0)}
    lugs = {"1": (-3.0, 0.0, 4.0), "2": (3.0, 0.0, 4.0)}
    text = hooked_lift(hooks, lugs, {"S1": ("A", "1", 10.1), "S2": ("B", "2", 10.1)})
    _, plan = sketches(Subject(Simulation(parse_scenario(text)).run(until=0.1)))
    numbers = [text_box(mark.x, mark.y, mark.text) for mark in plan.marks if mark.style == "sk-number"]
    dots = [np.array([mark.x, mark.y]) for mark in plan.marks if mark.style in ("sk-hook", "sk-lug")]
    assert len(numbers) == 2 and all(hides_none(one, dots) for one in numbers)
