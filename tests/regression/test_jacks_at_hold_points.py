"""Hold points of a lift in strand jacks had a table of hooks and none of what the jacks pull.

With a hook beside them there was not even that: one hook without a chart needs no table where it bears all.
"""

from __future__ import annotations

import pytest

from gantline.checks import hold_points, hook_readings
from gantline.cli.hold_points import hold_points as lines_of
from gantline.report.holds import GaugesAtHoldPoints, shares
from gantline.report.subject import Subject
from gantline.results import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from jacks_and_hook import BUNDLE, LIFT, LOAD
from lift_text import changed


@pytest.fixture(scope="module")
def held() -> Recording:
    """Two jacks and a hook that hold a section, 18 m to either side of its weight."""
    text = changed(LIFT, ("duration: 60 s", "duration: 2 s"), ("hold: until_end", "hold: 1 s"))
    return simulate(parse_scenario(text))


def test_the_report_has_what_jacks_pull(held: Recording) -> None:
    """A quarter of the load each, and at its upper end, on the tower, all of its bundle."""
    content = GaugesAtHoldPoints().content(Subject(held))
    assert content is not None
    [point] = content["points"]
    assert point["step"] == "hold"
    assert [name for name, _ in point["rows"]] == ["j1", "j2"]
    for _, pull in point["rows"]:
        assert float(pull) == pytest.approx(LOAD / 4 + BUNDLE, abs=0.051)


def test_the_run_has_hook_and_jacks(held: Recording) -> None:
    """Weights times 9.81 m/s^2; the sling weighs nothing."""
    lines = [line.split() for line in lines_of(held)]
    rows = {line[0]: line[1:] for line in lines if line[0] in ("H", "j1", "j2")}
    assert float(rows["H"][0].replace(",", "")) == pytest.approx(LOAD / 2 * 9.81, abs=0.5)
    for jack in ("j1", "j2"):
        assert float(rows[jack][0].replace(",", "")) == pytest.approx((LOAD / 4 + BUNDLE) * 9.81, abs=0.5)


def test_a_hook_beside_jacks_has_a_line_and_no_share_of_hooks(held: Recording) -> None:
    """`100 %` of all hooks is of half the load."""
    [point] = hold_points(held)
    [reading] = hook_readings(held, point.at)
    assert (reading.name, reading.share) == ("H", None)
    assert shares(Subject(held)) == {"hold": ""}
