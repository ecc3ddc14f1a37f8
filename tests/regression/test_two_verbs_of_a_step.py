"""A step that hoists and lowers at once: "'lower' is not a key of a hoist step; known here: 'to', ...".

Who wants one hook up while another goes down writes it so; that steps may go side by side was not told.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, parse_scenario


def test_a_step_for_each_is_right() -> None:
    both = "{step: lift off, lower: crane, hoist: crane,"
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(LIFT.replace("{step: lift off, hoist: crane,", both), "lift.yaml")
    line = next(number for number, one in enumerate(LIFT.splitlines(), 1) if "lift off" in one)
    assert str(refused.value) == (
        f"lift.yaml:{line}: step 'lift off', plan[1]: a step does one thing; found 'hoist' and 'lower': "
        "a step for each is right, side by side by 'starts: with_previous'"
    )
