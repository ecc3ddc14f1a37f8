"""What a lift file asks for and nothing can be held against, and runs that broke off: these were GO.

A limit of 90 % for lugs was a warning where one of five lugs had no capacity, and without a word where none
had one: the less was known, the better the verdict. A rig without tilt stiffness warned where the lift has a
limit for tilt, and not where it has none. What a step required of a crane outside of its chart, or of one
that tips, was `not checked`, and of two cranes the other alone was looked at. And a run that failed, or was
stopped, in its last hold had nothing left to do.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.recording import Recording
from rated_lift import recording as rated
from sample_lift import ringing_lift, sample_rig

HELD = "held against its chart"


def one(of: Recording, name: str, step: str = "") -> Check:
    return next(check for check in check_recording(of) if (check.name, check.step) == (name, step))


def lugs_without(*names: str, **limits: Any) -> Recording:
    rig = sample_rig(**limits)
    for name in names:
        rig["loads"][0]["lugs"][name]["capacity"] = None
    return ringing_lift(rig=rig)


@pytest.mark.parametrize("names", [["L1"], ["L1", "L2", "L3", "L4", "L5"]])
def test_a_limit_that_nothing_can_be_held_against_warns(names: list[str]) -> None:
    run = lugs_without(*names, lug_load_of_capacity=0.95)
    found = one(run, "lug_load_of_capacity")
    assert found.verdict is Verdict.WARNING
    assert "lug capacity not known: block.L1" in found.remark
    assert verdict_of(check_recording(run)).startswith("GO WITH WARNINGS")


def test_what_nobody_asks_for_is_not_checked() -> None:
    """Factors of a rule that the lift file does not name; a capacity need not be asked for."""
    lift = lugs_without("L1", "L2", "L3", "L4", "L5")
    by_rule = one(lift, "rope_load_of_breaking_force")
    assert (by_rule.verdict, by_rule.limit) == (Verdict.NOT_CHECKED, 1.0)
    lugs = one(lift, "lug_load_of_capacity")
    assert (lugs.verdict, lugs.limit) == (Verdict.WARNING, 1.0)


def test_what_an_equilibrium_cannot_know_is_not_checked() -> None:
    """It has no peak, whatever the lift file asks for: a run of the same lift has."""
    run = ringing_lift(rig=sample_rig(sling_dynamic_factor=1.1))
    at_rest = Recording(run.variables, run.coordinates, {**run.attributes, "status": "at rest"})
    assert one(run, "sling_dynamic_factor").value is not None
    assert one(at_rest, "sling_dynamic_factor").verdict is Verdict.NOT_CHECKED


def test_what_there_is_to_know_of_a_value_warns_without_a_limit_too() -> None:
    run = ringing_lift(rig=sample_rig())
    limited = ringing_lift(rig=sample_rig(load_tilt=0.1))
    plain = one(run, "load_tilt")
    assert one(limited, "load_tilt").remark == plain.remark != ""
    assert plain.verdict is Verdict.WARNING and not plain.has_no_limit
    said = verdict_of(check_recording(run))
    assert said.startswith("GO WITH WARNINGS")
    without = [check for check in check_recording(run) if check.has_no_limit]
    assert said.endswith(f"{len(without)} without a limit")


def required(radius: list[float], cranes: tuple[str, ...]) -> Check:
    """A step that requires less than 90 % of the charts, with 100 t at each hook."""
    plan = [{"step": HELD, "kind": "hold", "require": {"hoist_load_of_rating": {"below": 0.9}}}]
    run = rated([radius, radius], [[100.0] * len(radius)] * 2, cranes=cranes, plan=plan)
    return one(run, "hoist_load_of_rating", HELD)


def test_what_a_step_requires_fails_outside_of_the_chart() -> None:
    found = required([18.5], ("c1",))
    assert found.verdict is Verdict.FAILED
    assert "18.50 m at 0.00 s is outside of the chart" in found.remark
    beside = required([14.0, 18.5], ("c1", "c2"))
    assert (beside.verdict, beside.element) == (Verdict.FAILED, "crane c2")


def test_slings_that_hang_slack_have_no_spread() -> None:
    """A step required `tension_spread: below 5 %` while all slings were slack, and had 0 %: ok."""
    rig = sample_rig()
    rig["plan"][0]["require"] = {"tension_spread": {"below": 0.05}}
    begun = [(0.0, "step_begin", "hoist"), (5.0, "step_end", "hoist"), (5.0, "step_begin", "hold")]
    found = {}
    for least in (0.0, 600e3):
        tension = np.full((2001, 5), 600e3)
        tension[:500] = least
        found[least] = one(ringing_lift(rig=rig, tension=tension, events=begun), "tension_spread", "hoist")
    assert (found[0.0].verdict, found[0.0].remark) == (Verdict.WARNING, "none of its slings carries: e1")
    assert (found[600e3].verdict, found[600e3].value) == (Verdict.OK, 0.0)


@pytest.mark.parametrize(("status", "words"), [("failed", "failed"), ("stopped", "was stopped")])
def test_a_run_that_broke_off_in_its_last_hold_is_no_verdict(status: str, words: str) -> None:
    whole = ringing_lift()
    assert verdict_of(check_recording(whole)).startswith("GO")
    part = Recording(whole.variables, whole.coordinates, {**whole.attributes, "status": status})
    assert verdict_of(check_recording(part)).startswith(f"NO VERDICT: the run {words} at 40 s")
