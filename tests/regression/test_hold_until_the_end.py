"""A step that holds until the end of the run, and what is asked of it.

It ends with the run, and no event said so: what it had to report was not reported, and what it required
was `not checked`, in the lift file that `gantline new` writes too. And one that waited in vain for a
condition counted as done, being a hold.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.checks import Verdict, check_recording, verdict_of
from gantline.checks.readings import hold_points
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario

AT_END = "hold: until_end, report: [hook_load], require: {load_tilt: below 0.1 deg}"


def run(hold: str, duration: str = "70 s") -> Recording:
    text = LIFT.replace("hold: 20 s", hold).replace("duration: 70 s", f"duration: {duration}")
    return gantline.simulate(parse_scenario(text.replace("at: [0 m, 0 m, 1.5 m]", "at: [0.3 m, 0 m, 1.5 m]")))


@pytest.fixture(scope="module")
def eccentric() -> Recording:
    """Its centre of gravity is not below the hook, so that it hangs askew."""
    return run(AT_END)


def test_what_the_last_hold_requires_is_checked_at_the_end_of_the_run(eccentric: Recording) -> None:
    (check,) = (one for one in check_recording(eccentric) if one.step == "hold point")
    assert check.value == eccentric.column("load_tilt", "module")[-1] > check.limit
    assert (check.verdict, check.time) == (Verdict.FAILED, 70.0)
    assert verdict_of(check_recording(eccentric)).startswith("NO-GO")


def test_what_it_has_to_report_is_read_there(eccentric: Recording) -> None:
    (point,) = hold_points(eccentric)
    assert (point.step.step, point.time) == ("hold point", 70.0)


def test_a_run_that_does_not_come_to_it_checks_nothing() -> None:
    short = run(AT_END, "10 s")
    (check,) = (one for one in check_recording(short) if one.step == "hold point")
    assert check.verdict is Verdict.NOT_CHECKED
    assert not list(hold_points(short))


def test_a_hold_that_waits_in_vain_is_not_done() -> None:
    waiting = run("hold: until_met, until: {supports: touched}")
    found = {one.name: one for one in check_recording(waiting)}
    assert found["plan_finished"].verdict is Verdict.WARNING
    assert "in 'hold point'" in found["plan_finished"].remark
