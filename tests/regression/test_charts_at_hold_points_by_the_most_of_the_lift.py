"""At a hold point the table said that 93.1 % of a chart was used while 44.1 % of it hung there.

A crawler crane raised one end of a column whose other end hung from ropes of `mechanics`, and had all of it
in the end. A crane that lifts alone is checked at a hold point with the most that hung still in it in the
whole lift, over what is rated at that hold point: nobody may count on less. That number alone stood in the
table, under 'used, as checked', beside a hoist load and a rated load of which it was twice the quotient; the
report and its first page had it too. What hangs there over what is rated there stands beside it now.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import hold_points, hook_readings
from gantline.cli.hold_points import hold_points as lines_of
from gantline.report.holds import HoldPoints, shares
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from girder_and_crawler import HOOK_BLOCK, LOAD, RATED, girder_lift

REST = """\
mechanics:
  ropes:
    stay: {rope: sling, length: 7.09 m, route: [{type: end, body: world, at: [0 m, 14 m, 15 m]},
      {type: end, body: girder, at: [0 m, 0 m, 2 m]}]}
plan:
  - {step: with the stay, hold: 20 s}
  - {step: without, hold: until_end, cut: [stay]}
"""

LIFT = girder_lift("A girder that hangs from a stay and a crane", 60, REST)


@pytest.fixture(scope="module")
def lift() -> Recording:
    return gantline.simulate(parse_scenario(LIFT))


def test_what_hangs_at_a_hold_point_stands_beside_what_is_checked_there(lift: Recording) -> None:
    with_the_stay, without = (hook_readings(lift, point.at)[0] for point in hold_points(lift))
    assert with_the_stay.used == pytest.approx((LOAD + HOOK_BLOCK) / RATED, rel=1e-3)
    assert with_the_stay.used_then == pytest.approx(with_the_stay.hoist_load / (RATED * 9.81))
    assert with_the_stay.used_then is not None and with_the_stay.used_then < 0.3
    assert with_the_stay.is_checked_for_more
    assert without.used_then == pytest.approx((LOAD + HOOK_BLOCK) / RATED, rel=1e-3)


def test_table_and_report_have_both(lift: Recording) -> None:
    first, _ = (hook_readings(lift, point.at)[0] for point in hold_points(lift))
    then = 100.0 * (first.used_then or 0.0)
    lines = lines_of(lift)
    row = next(line for line in lines if line.split()[:1] == ["crane.H"])
    assert row.split()[-4:] == [f"{then:.1f}", "%", "42.0", "%"]
    assert sum("as checked:" in line for line in lines) == 1
    content = HoldPoints().content(Subject(lift))
    assert content is not None
    (reported,) = content["points"][0]["rows"]
    assert (reported["used_then"], reported["used"]) == (f"{then:.1f}", "42.0")
    assert shares(Subject(lift)) == {
        "with the stay": f"chart {then:.0f} %, 42 % as checked",
        "without": "chart 42 %",
    }
