"""A fixed hook without a hook block was lowered into its own load without a word.

Nothing is drawn of such a hook, so that nothing was held against the load: only hook blocks were. Its top is
at 2 m; the hook, at 6 m plus what lifting off takes, goes down by as much as the step says.
"""

from __future__ import annotations

import pytest

import gantline
from box_on_a_hook import box_on_a_hook
from gantline.checks import Check, Verdict
from gantline.scenario import parse_scenario
from of_recording import checks_of

PLAN = """\
  - {step: hold, hold: 6 s}
  - {step: down, lower: hook, speed: 12 m/min, by: BY m}"""
#: Top of the load, and what the hook reaches below its bearing [m].
TOP, REACH = 2.0, 0.1


def lowered(by: float) -> tuple[float, list[Check]]:
    """How high the hook ends [m], and what the run says of it."""
    text = box_on_a_hook(PLAN.replace("BY", repr(by)), duration=40.0, speed=12.0)
    recording = gantline.simulate(parse_scenario(text))
    found = checks_of(recording, "no_overlap")
    return float(recording.column("body_position", "hook")[-1, 2]), found


@pytest.mark.parametrize("by", [0.5, 3.5, 3.95])
def test_nothing_is_said_of_a_hook_above_it(by: float) -> None:
    height, found = lowered(by)
    assert height - REACH > TOP
    assert found == []


def test_a_hook_that_touches_it_is_a_warning() -> None:
    height, [check] = lowered(4.05)
    assert TOP < height < TOP + REACH
    assert (check.element, check.verdict) == ("box to hook", Verdict.WARNING)


@pytest.mark.parametrize("by", [4.2, 5.0])
def test_a_hook_within_it_fails(by: float) -> None:
    height, [check] = lowered(by)
    assert height < TOP
    assert (check.element, check.verdict) == ("box to hook", Verdict.FAILED)
    assert f"{min(TOP + REACH - height, TOP / 2):.2f} m deep" in check.remark or by == 5.0
