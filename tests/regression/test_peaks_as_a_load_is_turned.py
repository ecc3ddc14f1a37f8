"""What a hook bears as a load is turned from one hold to another was held to its rating without contingency.

A beam of 20 t hangs from two hooks by lugs 3 m above its centre of gravity. Level, each bears half of it;
with the end at the hook E raised until the beam slopes by 35 deg E bears 71 %, and half again once it has
been let down. It hangs still level alone. So for E there were 11 t, half of the design weight, and the
simulated peak, 14.2 t of 14.5 t: a GO at 98 %. With the contingency of 1.1 it is 108 % as it slopes, which a
run that holds there told. So it was with its sling, its shackles and its lug, and with the charts of cranes.
"""

from __future__ import annotations

import pytest

from gantline.checks import Check, Outcome, Verdict, check_recording, outcome_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from turned_beam import CONTINGENCY, LIFT, RATED, USED, by_crawlers

HELD = LIFT.replace("  - {step: back", "  - {step: look, hold: 20 s}\n  - {step: back")
NAMES = ["hoist_load_of_rated_capacity", "lug_load_of_capacity", "shackle_dynamic_load_of_strength"]


@pytest.fixture(scope="module")
def checks() -> list[Check]:
    return check_recording(simulate(parse_scenario(LIFT)))


def _of(checks: list[Check], name: str) -> Check:
    (check,) = [one for one in checks if one.name == name]
    return check


@pytest.mark.parametrize("name", NAMES)
def test_the_design_weight_counts_as_it_is_turned(checks: list[Check], name: str) -> None:
    """Slings of 100 m lean by 0.5 deg as the hooks stay 10 m apart, which is 0.5 % of the share."""
    check = _of(checks, name)
    assert USED / CONTINGENCY < 1.0 < USED
    assert check.value == pytest.approx(USED, rel=1e-2)
    assert check.verdict is Verdict.FAILED
    assert "x 1.1 to the design weight" in check.formula and check.element.endswith(
        ("E", "E top", "E bottom")
    )
    assert outcome_of(checks) is Outcome.NO_GO


def test_a_hold_there_tells_the_same(checks: list[Check]) -> None:
    held = check_recording(simulate(parse_scenario(HELD)))
    for name in NAMES:
        assert _of(held, name).value == pytest.approx(_of(checks, name).value, rel=5e-3)


def test_the_chart_of_a_crane_too() -> None:
    """What hangs in the hook, all of it of the load and its shackles, times the contingency."""
    recording = simulate(parse_scenario(by_crawlers()))
    check = _of(check_recording(recording), "hoist_load_of_rating")
    most = float(recording.column("hook_load", "E.H").max())
    assert check.value == pytest.approx(most * CONTINGENCY / (RATED * 1e3 * recording.rig.gravity), rel=1e-3)
    assert check.verdict is Verdict.FAILED and "x 1.1 to the design weight" in check.formula
