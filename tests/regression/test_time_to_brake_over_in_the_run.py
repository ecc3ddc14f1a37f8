"""Steps whose time to brake was over as they began, since a step before them took longer.

Where the lift file alone tells it for certain, such a step is refused. Where a step before it goes `to` a
place or waits for something, a traverse, travel, luff or slew with `brake_from` began and ended at once,
and no line said that the load was not taken where the plan has it. Of a hoist one said "what it waits for
held as it began", though it waits for nothing; the same was said of a hook that was to come `to` where it
is.
"""

from __future__ import annotations

import pytest

import gantline
from crawler_lift import crawler_lift
from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario

#: From 30 m, with 0.1 m/s by 0.02 m/s^2: 3 m in 3/0.1 + 0.1/0.02 = 35 s.
FIRST = "{step: first, hoist: c1.H, speed: 6 m/min, to: 33 m}"


def told(*steps: str) -> Check | None:
    lift = crawler_lift(57e3, "\n".join([FIRST, *steps]), duration=60.0)
    checks = check_recording(gantline.simulate(parse_scenario(lift)))
    return next((one for one in checks if one.name == "plan_moves"), None)


@pytest.mark.parametrize("key", ["brake_from", "emergency_stop_at"])
def test_one_that_slews_is_told(key: str) -> None:
    found = told(f"{{step: slew, slew: c1, speed: 0.2 rev/min, {key}: 20 s}}")
    assert found is not None
    assert found.verdict is Verdict.WARNING
    assert found.remark == f"its '{key}' was over as it began, and nothing moved: slew"


def test_each_is_told_why() -> None:
    found = told(
        "{step: more, hoist: c1.H, speed: 6 m/min, brake_from: 20 s}",
        "{step: there, lower: c1.H, speed: 6 m/min, to: 33 m}",
        "{step: loaded, lower: c1.H, speed: 6 m/min, until: {hoist_load: {hook: c1.H, above: 40 t}}}",
    )
    assert found is not None
    assert found.remark == (
        "its 'brake_from' was over as it began, and nothing moved: more; "
        "it was there as it began, and nothing moved: there; "
        "what it waits for held as it began, and nothing moved: loaded"
    )


def test_a_time_that_comes_is_in_order() -> None:
    """It begins at 35 s, and slews until it brakes from 40 s."""
    assert told("{step: slew, slew: c1, speed: 0.2 rev/min, brake_from: 40 s}") is None
