"""Names beside the dots of a sketch."""

from __future__ import annotations

import numpy as np

from gantline.report.sketch_names import names_beside


def test_dots_that_look_like_one_have_one_name() -> None:
    places = [np.array([20.0, 30.0]), np.array([20.5, 30.2]), np.array([60.0, 30.0])]
    assert [one[2] for one in names_beside(places, ["U1", "U2", "L"], 90.0)] == ["U1, U2", "L"]


def test_a_name_keeps_off_other_dots_names_and_the_end_of_the_paper() -> None:
    near = [np.array([40.0, 30.0]), np.array([46.0, 30.0])]
    first, second = names_beside(near, ["U1, U2", "L"], 90.0)
    assert first[3] == "end"  # to the right it would lie on the other dot
    assert first[0] < 40.0
    assert second[3] == "start"
    (last,) = names_beside([np.array([86.0, 30.0])], ["crane.hook"], 90.0)
    assert last[3] == "end"


def test_a_name_without_room_is_left_out() -> None:
    crowd = [np.array([x, y]) for x in np.arange(2.0, 90.0, 4.0) for y in np.arange(10.0, 60.0, 3.0)]
    assert len(names_beside(crowd, ["hook"] * len(crowd), 90.0)) < len(crowd)
