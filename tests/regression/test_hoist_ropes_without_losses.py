"""A hoist rope over sheaves of which nobody said what they take was held against its strength with its mean.

As it hoists, the line at the drum has the most: of 8 parts over sheaves that take 2 % each 9.4 % more than
the mean, of 20 parts 23 %. Without `sheave_efficiency` a reeving loses nothing, and nothing told of it.
"""

from __future__ import annotations

import functools

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording

#: Of the hoist of scenario `revolving_crane`; what a sheave leaves of the tension.
PARTS, LEAVES = 8, 0.98
LOSSES = " sheave_efficiency: 0.98,"
ROPE = "hoist.rc.H1.1"


@functools.cache
def _factor(limit: float, losses: str) -> Check:
    """The check of the factor on breaking force, in which the hoist rope is the weakest of all."""
    text = gantline.load_scenario("revolving_crane").text
    assert text.count(LOSSES) == text.count("rope: hoist_32, from") == 1
    changes = {
        "limits.rope_factor_on_breaking_force": f"{limit}",
        "limits.sling_factor_on_breaking_force": "1",
        "ropes.hoist_32.grade": "1770",
        "ropes.sling_40.diameter": "80 mm",
        "ropes.moor_40.grade": "2160",
    }
    lift = gantline.parse_scenario(text.replace(LOSSES, losses)).changed(changes)
    found = check_recording(gantline.Statics(lift).equilibrium(560.0).recording)
    return next(one for one in found if one.name == "rope_factor_on_breaking_force")


def test_a_factor_that_losses_take_past_its_limit_is_told() -> None:
    """T_drum/T_mean = n (1 - η)/(η (1 - η^n)): each part has η of the next, all bear the hook."""
    without = _factor(1.0, "")
    assert without.value is not None and without.element == ROPE
    more = PARTS * (1.0 - LEAVES) / (LEAVES * (1.0 - LEAVES**PARTS))
    assert more == pytest.approx(1.0940, abs=1e-4)
    near = _factor(round(without.value / more * 1.02, 3), "")
    assert near.verdict is Verdict.WARNING
    assert f"it comes to {without.value / more:.2f}: 'sheave_efficiency' says it" in near.remark


def test_one_that_they_leave_within_it_is_not() -> None:
    within = _factor(2.0, "")
    assert within.verdict is Verdict.OK and not within.remark


def test_sheaves_that_are_known_are_as_they_are() -> None:
    without = _factor(1.0, "")
    assert without.value is not None
    known = _factor(round(without.value * 0.99, 3), LOSSES)
    assert known.verdict is Verdict.OK and "efficiency" not in known.remark
