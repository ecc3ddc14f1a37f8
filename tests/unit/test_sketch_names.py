"""Names beside the dots of a sketch."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.report.sketch_names import (
    around_dot,
    has_room,
    names_beside,
    names_in_a_row,
    on_paper,
    text_box,
)


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


def test_a_name_rather_keeps_off_what_is_drawn_than_stands_beside_its_dot() -> None:
    """At the end of the paper a name would stand to the left, over a rope: it goes above or below its dot."""
    rope = [around_dot(np.array([70.0, y])) for y in np.arange(28.0, 33.0)]
    ((x, y, _, side),) = names_beside([np.array([80.0, 30.0])], ["c1.H, c2.H"], 90.0, rope)
    assert (x, side) == (90.0 - 17.5, "start") and abs(y - 30.0) >= 4.0
    ((x, y, _, side),) = names_beside([np.array([80.0, 30.0])], ["c1.H, c2.H"], 90.0)
    assert (x, y, side) == (77.5, 30.0, "end")
    whole = [(0.0, 92.0, y) for y in np.arange(0.0, 62.0, 3.0)]
    assert names_beside([np.array([80.0, 30.0])], ["c1.H, c2.H"], 90.0, whole)  # none is left out for that


@pytest.mark.parametrize(
    ("anchor", "box"), [("start", (10.0, 17.0)), ("middle", (6.5, 13.5)), ("end", (3.0, 10.0))]
)
def test_the_room_of_a_text(anchor: str, box: tuple[float, float]) -> None:
    found = text_box(10.0, 5.0, "U1.2", anchor)
    assert found == (*box, 5.0)
    assert not has_room(found, [around_dot(np.array([box[1], 5.0]))])
    assert has_room(found, [around_dot(np.array([box[1] + 1.3, 5.0])), around_dot(np.array([10.0, 9.0]))])


def hanging(*across: float, top: float = 15.0, bottom: float = 45.0) -> list[tuple[np.ndarray, np.ndarray]]:
    return [(np.array([x, top]), np.array([x, bottom])) for x in across]


def test_names_of_slings_near_each_other_stand_in_one_row_and_are_led_to_them() -> None:
    """Five slings 2 mm apart had their names upon each other."""
    names = ["S5", "S4", "S3", "S2", "S1"]
    row = names_in_a_row(hanging(42.0, 44.0, 46.0, 48.0, 50.0), names, 90.0, [])
    assert row is not None
    places, heights = [x for x, _, _ in row], {y for _, y, _ in row}
    assert len(heights) == 1 and places == sorted(places)
    # Two bold letters are 4.4 mm wide at most.
    assert min(np.diff(places)) >= 4.4
    assert np.mean(places) == pytest.approx(46.0)
    led = [float(place[0]) for _, _, place in row if place is not None]
    assert led == pytest.approx([42.0, 44.0, 46.0, 48.0, 50.0])


def test_names_of_slings_apart_stand_on_them() -> None:
    row = names_in_a_row(hanging(60.0, 20.0), ["S1", "S2"], 90.0, [])
    assert row is not None and [(x, led) for x, _, led in row] == [(60.0, None), (20.0, None)]


def test_a_row_keeps_off_what_is_taken() -> None:
    free = names_in_a_row(hanging(20.0, 60.0), ["S1", "S2"], 90.0, [])
    assert free is not None and free[0][1] == pytest.approx(30.0)
    kept = names_in_a_row(hanging(20.0, 60.0), ["S1", "S2"], 90.0, [(15.0, 25.0, 30.0)])
    assert kept is not None and abs(kept[0][1] - 30.0) >= 3.4


def test_lines_that_hide_each_other_and_a_crowd_have_no_row() -> None:
    assert names_in_a_row(hanging(20.0, 20.1), ["S1", "S2"], 90.0, []) is None
    crowd = hanging(*np.arange(10.0, 40.0, 2.0))
    assert names_in_a_row(crowd, [f"S{one}" for one in range(len(crowd))], 90.0, []) is None
    assert names_in_a_row(hanging(20.0, 60.0, bottom=20.0), ["S1", "S2"], 90.0, []) is None


def test_a_long_name_at_the_end_of_the_paper_is_kept_on_it() -> None:
    """`north_west.2` at a lug 9 mm from the left end was cut to `orth_west.2`."""
    half = 12 * 2.2 / 2  # of twelve bold letters of 2.2 mm
    assert on_paper(9.0, "north_west.2", 92.0) == pytest.approx(half)
    assert on_paper(88.0, "north_west.2", 92.0) == pytest.approx(92.0 - half)
    assert on_paper(46.0, "north_west.2", 92.0) == 46.0


def test_a_bold_text_takes_more() -> None:
    """Three letters of 2.2 mm are 6.6 mm wide, and not 5.25: numbers of lugs 6 mm apart lay on each other."""
    one, other = (text_box(x, 30.0, "S12", is_bold=True) for x in (40.0, 46.0))
    assert one == pytest.approx((36.7, 43.3, 30.0))
    assert not has_room(other, [one])
    assert has_room(text_box(46.0, 30.0, "S12"), [text_box(40.0, 30.0, "S12")])
