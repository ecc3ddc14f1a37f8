"""An emergency stop in a step that never began, or that was over by then, was passed over in silence.

`emergency_stop: {at: 70 s}` of a lift of 60 s is refused, and one that a shorter run does not reach is told.
`{in_step: s}` with 70 s of waiting before it, and `{in_step: s, after: 100 s}`, ran without a stop and
without a word, and so did a step on a condition that is not met within the run.
"""

from __future__ import annotations

import pytest

import gantline
from crawler_lift import crawler_lift
from gantline.scenario import ScenarioError, parse_scenario

SLEW = "{step: s, slew: c1, speed: 0.2 rev/min, by: 20 deg}"


def lift(plan: str, stop: str) -> str:
    text = crawler_lift(57e3, plan, duration=60.0, more=f"emergency_stop: {stop}\n")
    return text.replace("0.02 m/s^2}", "0.02 m/s^2, emergency_acceleration: 1 m/s^2}")


def told(plan: str, stop: str, duration: float = 60.0) -> list[str]:
    recording = gantline.simulate(parse_scenario(lift(plan, stop)), duration=duration)
    return [one for one in recording.attributes["warnings"] if "before the emergency stop" in one]


@pytest.mark.parametrize(
    ("plan", "stop", "says"),
    [
        ("{step: wait, hold: 70 s}\n" + SLEW, "{in_step: s}", "in_step: 's' begins at 70 s at the earliest"),
        (SLEW, "{in_step: s, after: 61 s}", "after: 's' begins at 0 s at the earliest"),
    ],
    ids=["step too late", "after too long"],
)
def test_what_cannot_come_is_refused(plan: str, stop: str, says: str) -> None:
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(lift(plan, stop))
    assert f"emergency_stop.{says}, so that this is after the end of the lift at 60 s" in str(refused.value)


def test_what_only_the_run_knows_is_told_by_it() -> None:
    """A hoist load that no rope ever has: the step behind it does not begin."""
    hoist = "{step: up, hoist: c1.H, speed: 1 m/min, until: {hoist_load: {hook: c1.H, above: 9000 kN}}}\n"
    assert told(hoist + SLEW, "{in_step: s}") == [
        "the run ends before the emergency stop in 's': it is not seen"
    ]


@pytest.mark.parametrize(("duration", "is_told"), [(4.0, True), (6.0, False)], ids=["before", "after"])
def test_a_shorter_run_that_does_not_reach_it_is_told(duration: float, is_told: bool) -> None:
    late = "the run ends before the emergency stop in 's', 5 s after that begins: it is not seen"
    assert told(SLEW, "{in_step: s, after: 5 s}", duration) == [late] * is_told


def test_before_the_first_step_it_has_no_name() -> None:
    """The event bore the name of a step that never began."""
    plan = SLEW.replace("by:", "start_at: 10 s, by:")
    events = list(gantline.simulate(parse_scenario(lift(plan, "{at: 5 s}"))).events())
    assert events == [(5.0, "emergency_stop", "")]
