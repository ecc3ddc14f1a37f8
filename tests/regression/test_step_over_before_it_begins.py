"""A step that brakes, or stops in an emergency, at a time before it can begin moved nothing, without a word.

`{slew: c1, by: 90 deg}` takes 75 s at 1.2 deg/s. A step after it with `emergency_stop_at: 20 s` began and
ended at 87 s, and so did one with `brake_from`; only times that stand in the plan themselves were compared.
"""

from __future__ import annotations

import pytest

from crawler_lift import crawler_lift
from gantline.scenario import ScenarioError, parse_scenario

FIRST = "{step: first, slew: c1, speed: 0.2 rev/min, by: 90 deg}"


def lift(first: str, key: str, time: str) -> str:
    second = f"{{step: second, slew: c1, speed: 0.2 rev/min, {key}: {time}}}"
    return crawler_lift(57e3, f"{first}\n{second}", duration=200.0)


@pytest.mark.parametrize("key", ["brake_from", "emergency_stop_at"])
@pytest.mark.parametrize(
    ("first", "begin"), [(FIRST, 75), ("{step: wait, hold: 30 s}", 30)], ids=["way", "hold"]
)
def test_it_is_refused_where_that_is_certain(first: str, begin: int, key: str) -> None:
    """90 deg at 1.2 deg/s, or the hold; without ramps, so that it is no later than the run's own."""
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(lift(first, key, "20 s"))
    over = f"20 s is over before this step begins, at {begin} s at the earliest; it would move nothing"
    assert f"plan[2].{key}: {over}" in str(refused.value)


def test_a_time_that_may_come_is_in_order() -> None:
    """76 s are after the 75 s that the first step takes; a step beside the first begins with it, at 0 s."""
    after = parse_scenario(lift(FIRST, "brake_from", "76 s"))
    beside = lift(FIRST, "brake_from", "20 s").replace("step: second", "step: second, starts: with_previous")
    aside = parse_scenario(
        beside.replace(
            "second, starts: with_previous, slew: c1, speed: 0.2 rev/min",
            "second, starts: with_previous, luff: c1, speed: 3 deg/min",
        )
    )
    assert [getattr(scenario.plan[-1], "brake_from", None) for scenario in (after, aside)] == [76.0, 20.0]
