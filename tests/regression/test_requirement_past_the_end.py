"""A last hold of 60 s that required 1 deg of tilt, in a run that ended 50 s into it.

The load hung 1.6 deg askew. What the hold requires is looked at where it ends; the run did not come to that,
the requirement was `not checked`, and the verdict was GO: a hold that is under way had nothing left to do.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.checks import Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario

ASKEW = LIFT.replace(
    "centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}", "centre_of_gravity: {at: [0.3 m, 0 m, 1.5 m]}"
)
REQUIRES = ", require: {load_tilt: below 0.1 deg}"


def verdict(hold: str) -> tuple[str, list[str]]:
    """Verdict on a run of 70 s that is in its last step from about 20 s on, and what `plan_finished` says."""
    assert "hold: 20 s" in ASKEW
    # More than hook and lugs may carry, of which this lift has both: here that would hide the verdict.
    text = ASKEW.replace("hold: 20 s", hold).replace("capacity: 13.2 t", "capacity: 30 t")
    found = check_recording(gantline.simulate(parse_scenario(text.replace("46 t", "90 t"))))
    told = [one.remark for one in found if one.name == "plan_finished" and one.verdict is Verdict.WARNING]
    return verdict_of(found), told


def test_a_requirement_that_the_run_does_not_come_to_is_no_verdict() -> None:
    said, told = verdict(f"hold: 60 s{REQUIRES}")
    assert said.startswith("NO VERDICT: the run ends at 70 s in 'hold point'")
    assert told == ["the run ends at 70 s in 'hold point'"]


@pytest.mark.parametrize("hold", ["hold: 60 s", "hold: 20 s"])
def test_a_hold_that_requires_nothing_may_be_cut_short(hold: str) -> None:
    said, told = verdict(hold)
    assert said.startswith("GO")
    assert told == []


@pytest.mark.parametrize("hold", ["hold: until_end", "hold: 20 s"])
def test_one_that_ends_is_checked(hold: str) -> None:
    said, told = verdict(f"{hold}{REQUIRES}")
    assert said.startswith("NO-GO: 1 failed, load_tilt")
    assert told == []


def test_a_hold_that_is_over_as_the_run_ends_is_checked() -> None:
    """30 s and 40 s of a run of 70 s, in which no event is left to end the second."""
    begin, end = ASKEW.index("plan:"), ASKEW.index("rules:")
    plan = f"plan:\n  - {{step: one, hold: 30 s}}\n  - {{step: two, hold: 40 s{REQUIRES}}}\n"
    run = gantline.simulate(parse_scenario(ASKEW[:begin] + plan + ASKEW[end:]))
    (found,) = (one for one in check_recording(run) if one.step == "two")
    assert (found.verdict, found.time) == (Verdict.OK, 70.0)
