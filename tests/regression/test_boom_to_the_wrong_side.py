"""Lower the hook, said the message, of a hook that hung 30 m beside its lug.

A crawler crane was written with its boom to the wrong side, `slew: -90 deg` for 90. Its slings of 8 m would
have had to be 31 m long, and the advice was to lower the hook or to take longer slings; neither brings a boom
round.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario


def message(hook: str) -> str:
    with pytest.raises(gantline.ScenarioError) as caught:
        assemble(parse_scenario(LIFT.replace("at: [0 m, 0 m, 11 m]", f"at: {hook}")))
    return str(caught.value)


def test_a_hook_that_is_too_far_aside_is_told_to_be() -> None:
    """12 m along x and 5 m along y from lug A at (-2.5, 1.5) m: 13 m sideways of a sling of 8.6 m."""
    said = message("[9.5 m, -3.5 m, 11 m]")
    assert "13.000 m of that sideways, which no height of the hook makes up; put crane, boom or load" in said
    assert "lower the hook" not in said


def test_one_that_is_too_high_is_lowered() -> None:
    said = message("[0 m, 0 m, 14 m]")
    assert said.endswith("lower the hook or make the sling longer")
    assert "sideways" not in said
