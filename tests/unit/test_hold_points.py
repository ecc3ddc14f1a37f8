"""What hangs in several hooks at hold points: numbers worked out by hand, in the table and the report."""

from __future__ import annotations

from typing import Any

import pytest

from gantline.checks import check_recording, hold_points, hook_readings
from gantline.cli.hold_points import hold_points as lines_of
from gantline.report.holds import HoldPoints, shares
from gantline.report.subject import Subject
from rated_lift import T, recording
from sample_lift import ringing_lift

HOLD = {"step": "look", "kind": "hold"}
FACTOR = {"several_cranes_factor": {"value": 1.2, "source": "example"}}


def tandem(**given: Any) -> Any:
    """150 t at 16 m (231 t rated) and 100 t at 14 m (283 t); hook blocks and falls of 9 t."""
    settings = {"cranes": ("c1", "c2"), "factors": FACTOR, "plan": [{**HOLD, "report": ["hook_load"]}]}
    return recording([[16.0, 14.0]] * 2, [[150.0, 100.0]] * 2, **{**settings, **given})


def readings(of: Any) -> Any:
    (point,) = hold_points(of)
    return hook_readings(of, point.at)


def test_each_hook_has_its_share_and_what_its_chart_allows_there() -> None:
    one, other = readings(tandem())
    assert (one.name, other.name) == ("H0", "H1")
    assert one.share == pytest.approx(141 / (141 + 91))
    assert (one.hook_load, one.hoist_load) == pytest.approx((141 * T, 150 * T))
    assert (one.height, other.height) == (30.0, 31.0)
    assert (one.radius, one.rated) == pytest.approx((16.0, 231 * T))
    assert (one.used, other.used) == pytest.approx((1.2 * 150 / 231, 1.2 * 100 / 283))
    assert other.share + one.share == pytest.approx(1.0)


def test_the_use_is_that_of_the_check_at_the_same_moment() -> None:
    """A requirement of the step is held against what the check comes to at its end, and there alone."""
    step = {**HOLD, "require": {"hoist_load_of_rating": {"below": 1.0}}}
    of = recording([[16.0], [18.0], [16.0]], [[150.0], [150.0], [100.0]], plan=[step])
    found = next(one for one in check_recording(of) if one.step == "look")
    assert [one.used for one in readings(of)] == [found.value]
    assert found.value == pytest.approx(150 / 231)


def test_a_crane_of_several_hooks_has_a_line_of_its_own() -> None:
    """180 t together, of 195 t where the farther hook is; alone 100 of 40 % of 283 t."""
    of = recording([[14.0, 18.0]] * 2, [[100.0, 80.0]] * 2, shares={"H0": 0.4, "H1": 0.5}, plan=[HOLD])
    found = {one.name: one for one in readings(of)}
    assert list(found) == ["H0", "H1", "crane c1"]
    assert found["H0"].used == pytest.approx(100 / (0.4 * 283))
    crane = found["crane c1"]
    assert (crane.share, crane.radius, crane.rated, crane.used) == pytest.approx(
        (1.0, 18.0, 195 * T, 180 / 195)
    )
    assert crane.height is None


def test_outside_of_its_chart_a_hook_uses_no_share_of_it() -> None:
    of = recording([[19.0]] * 2, [[100.0]] * 2, plan=[HOLD])
    (one,) = readings(of)
    assert one.is_outside and one.used is None
    assert "outside of the chart" in "\n".join(lines_of(of))


def test_empty_hooks_have_no_shares() -> None:
    empty = recording([[16.0, 14.0]] * 2, [[9.0, 9.0]] * 2, cranes=("c1", "c2"), plan=[HOLD])
    one, other = readings(empty)
    assert (one.share, other.share, one.used, other.used) == (None, None, None, None)


def test_steps_that_neither_hold_nor_report_are_passed_over() -> None:
    hoist = {"step": "up", "kind": "hoist"}
    asked = {"step": "more", "kind": "hoist", "report": ["hook_load"]}
    found = hold_points(tandem(plan=[hoist, asked]))
    assert [(one.step.step, one.time) for one in found] == [("more", 1.0)]


def test_the_run_table_has_a_line_for_each_hook() -> None:
    text = [" ".join(line.split()) for line in lines_of(tandem())]
    assert text[0] == "At the end of 'look', 0.00 s"
    assert text[1] == "Hook hook load of all hooks hoist load level radius rated there used then as checked"
    first = f"H0 {141 * 9.81:.1f} kN 60.8 % {150 * 9.81:.1f} kN 30.00 m 16.00 m {231 * 9.81:.1f} kN"
    assert text[2] == f"{first} 64.9 % 77.9 %"
    assert text[4].startswith("(as checked: with the design weight and the factors of the rules")
    assert len(text) == 6  # what `report` asks for stands in the table
    level = tandem(plan=[{**HOLD, "report": ["hook_height"]}])
    assert not any("hook height" in line for line in lines_of(level))


def test_the_report_has_a_section_and_a_few_words_on_its_first_page() -> None:
    subject = Subject(tandem())
    content = HoldPoints().content(subject)
    assert content is not None
    (point,) = content["points"]
    assert point["rows"][0] == {
        "name": "H0",
        "share": "60.8",
        "hook_load": "141.0",
        "hoist_load": "150.0",
        "height": "30.00",
        "radius": "16.00",
        "rated": "231.0",
        "used_then": "64.9",  # 150/231
        "used": "77.9",  # 1.2 x 150/231
    }
    assert shares(subject) == {"look": "hooks 61 / 39 %, chart 65 %, 78 % as checked"}


def test_one_hook_without_a_chart_needs_no_table() -> None:
    subject = Subject(ringing_lift())
    assert HoldPoints().content(subject) is None
