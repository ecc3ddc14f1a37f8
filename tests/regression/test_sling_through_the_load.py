"""A sling that runs through what it lifts.

A lug whose height was mistyped stood on the bottom of the load; the sling ran up through 3 m of the load,
nothing in a simulation held it off, and the lift was GO. Who knew could `watch` slings and load; who
mistypes does not know. A load whose height was mistyped reached over the hook from which it hung.
"""

from __future__ import annotations

import math

import pytest

import gantline
from four_slings import LIFT
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.scenario import parse_scenario

LUG, SLING = "A: {at: [-2.5 m,  1.5 m, 3 m]", "module.A, length: 8.6 m"
ACROSS = math.hypot(2.5, 1.5)
WATCHED = "watch:\n  - {between: [slings, module], smallest: 0.1 m, from_ends: 4 m}\nplan:"


def with_lug_at(height: float) -> str:
    """The lift with one lug at another height; its sling is as slack as 8.6 m are to a lug 8 m below."""
    slack = 8.6 - math.hypot(ACROSS, 8.0)
    length = math.hypot(ACROSS, 11.0 - height) + slack
    lowered = LIFT.replace(LUG, f"A: {{at: [-2.5 m,  1.5 m, {height} m]")
    return lowered.replace(SLING, f"module.A, length: {length!r} m").replace("13.2 t", "40 t")


def checked(text: str) -> list[Check]:
    return check_recording(gantline.simulate(parse_scenario(text.replace("46 t", "90 t"))))


def told(checks: list[Check]) -> Check | None:
    return next((one for one in checks if one.name == "sling_outside_load"), None)


def test_a_sling_from_the_bottom_through_the_top_is_told() -> None:
    checks = checked(with_lug_at(0.0))
    found = told(checks)
    assert found is not None and (found.verdict, found.element) == (Verdict.WARNING, "A")
    # It leaves the top 3 m above its lug, along a sling that hangs 11 m and a little over 2.9 m askew.
    assert f"up to {3.0 * math.hypot(ACROSS, 11.0) / 11.0:.1f}" in found.remark
    assert verdict_of(checks).startswith("GO WITH WARNINGS")


@pytest.mark.parametrize("height", [3.0, 2.2], ids=["on top", "in a recess"])
def test_a_sling_from_the_top_is_not(height: float) -> None:
    assert told(checked(with_lug_at(height))) is None


def test_slings_from_inside_of_the_load_are_told() -> None:
    """A box of 30 m in place of 3: nothing goes through its skin, hook and slings are all inside."""
    found = told(checked(LIFT.replace("box: [6 m, 4 m, 3 m]", "box: [6 m, 4 m, 30 m]")))
    assert found is not None and found.remark == "A, B, C and 1 more hung from within or below 'module'"


def test_whoever_watches_slings_and_load_has_said_what_may_be() -> None:
    checks = checked(with_lug_at(0.0).replace("plan:", WATCHED))
    assert told(checks) is None
    assert next(one for one in checks if one.name == "clearance_margin").verdict is Verdict.OK
