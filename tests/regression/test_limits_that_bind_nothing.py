"""Limits and requirements that could not be passed, or were held against nothing, without a word.

- `hoist_load_of_rated_capacity: 95` was 9500 %, and ok: a share without its percent sign.
- A limit of 120 % of a rated capacity made a hook at 116 % of it ok.
- `smallest_sling_tension_when_clear` and `tension_spread_when_clear` of a load that never came clear, and
  what a step requires of something that the lift does not have, were `not checked`, and the lift a GO.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.scenario import ScenarioError, parse_scenario
from lift_text import BASE, spoiled
from sample_lift import WEIGHT, ringing_lift, sample_rig

G = 9.81


def one(name: str, step: str = "", **limits: Any) -> Check:
    found = check_recording(ringing_lift(rig=sample_rig(**limits)))
    return next(check for check in found if (check.name, check.step) == (name, step))


@pytest.mark.parametrize(
    ("key", "number"),
    [("hoist_load_of_rated_capacity", "95"), ("tension_spread_when_clear", "5"), ("wind_of_limit", "2.5")],
)
def test_a_share_without_its_percent_sign_is_refused(key: str, number: str) -> None:
    text = spoiled("load_tilt: 2 deg}", f"{key}: {number}}}", BASE)
    with pytest.raises(ScenarioError, match=f"limits.{key}: '{number}' is {100 * float(number):g} %"):
        parse_scenario(text)
    parse_scenario(text.replace(f"{key}: {number}", f"{key}: {number} %"))
    parse_scenario(text.replace(f"{key}: {number}", f"{key}: 1.1"))


def test_a_requirement_without_its_percent_sign_is_refused() -> None:
    step = "{step: look, hold: 1 s, require: {load_transferred: above 99}}"
    with pytest.raises(ScenarioError, match=r"require\.load_transferred: '99' is 9900 %"):
        parse_scenario(spoiled("plan:\n", f"plan:\n  - {step}\n", BASE))


def of_capacity(tonnes: float, **limits: Any) -> Check:
    """Of the sample lift, whose hook bears at most the sum of its slings."""
    rig = sample_rig(**limits)
    rig["ratings"] = [
        {
            "name": "test_hook",
            "level": "hook",
            "hooks": ["test_hook"],
            "rated_capacity": tonnes * 1e3 * G,
            "includes_hook_block": False,
        }
    ]
    found = check_recording(ringing_lift(rig=rig))
    return next(check for check in found if check.name == "hoist_load_of_rated_capacity")


def test_a_limit_beyond_all_of_a_rating_is_told_where_it_is_used() -> None:
    whole = of_capacity(1000.0)
    assert whole.value is not None and whole.verdict is Verdict.OK
    small = 1000.0 * whole.value / 1.16  # used by 116 %
    assert of_capacity(small).verdict is Verdict.FAILED
    assert of_capacity(small, hoist_load_of_rated_capacity=1.10).verdict is Verdict.FAILED
    found = of_capacity(small, hoist_load_of_rated_capacity=1.20)
    assert found.value == pytest.approx(1.16)
    assert found.verdict is Verdict.WARNING
    assert found.remark == "more than all of it, 100.0 %, which the limit allows"
    assert of_capacity(1000.0, hoist_load_of_rated_capacity=1.20).verdict is Verdict.OK


def never_clear(**limits: Any) -> list[Check]:
    """60 % of the load hang, and the rest stands to the end."""
    share = np.linspace(0.0, 0.6, 2001)
    return check_recording(
        ringing_lift(
            rig=sample_rig(**limits),
            tension=np.outer(share, np.full(5, WEIGHT / 5)),
            contact=np.repeat((1 - share)[:, None] * WEIGHT / 4, 4, axis=1),
        )
    )


@pytest.mark.parametrize("key", ["smallest_sling_tension_when_clear", "tension_spread_when_clear"])
def test_a_limit_of_what_hangs_clear_warns_where_nothing_does(key: str) -> None:
    checks = never_clear(**{key: 0.05})
    [found] = [check for check in checks if check.name == key]
    assert (found.verdict, found.value) == (Verdict.WARNING, None)
    assert found.remark == "the load never came clear of its supports"
    assert not verdict_of(checks).startswith("GO;")
    assert not [check for check in never_clear() if check.name == key]


def test_a_lift_that_has_nothing_of_the_kind_is_not_checked() -> None:
    """A preset has limits of equalizers for lifts without any."""
    assert one("heel", heel=0.1).verdict is Verdict.NOT_CHECKED


@pytest.mark.parametrize("key", ["heel", "side_lead", "moment_of_tipping_moment"])
def test_a_step_that_requires_what_the_lift_does_not_have_warns(key: str) -> None:
    rig = sample_rig()
    rig["plan"][0]["require"] = {key: {"below": 0.1}}
    checks = check_recording(ringing_lift(rig=rig))
    [found] = [check for check in checks if check.step]
    assert (found.verdict, found.remark) == (Verdict.WARNING, "nothing to check at the end of this step")
