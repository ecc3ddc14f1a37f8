"""A path with a key that its place does not have was told as a mistake in line 1 of the lift file.

`--sweep 'slings.S1.len=…'`, and `scenario.changed({"slings.S1.len": …})`, were answered with line 1.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import ScenarioError

LIFT = gantline.load_scenario("equalizer")
LINES = LIFT.text.splitlines()


@pytest.mark.parametrize(
    ("path", "value", "stands"),
    [
        ("slings.S1.len", "24 m", "S1: {"),  # in one line with its place
        ("cranes.test_hook.rated", "400 t", "type: fixed_hook"),  # the first line of its place
        ("load.weight.simulated", "300 t", "weight: {"),
    ],
)
def test_a_key_that_is_not_there_is_told_with_the_line_of_its_place(
    path: str, value: str, stands: str
) -> None:
    with pytest.raises(ScenarioError) as caught:
        LIFT.changed({path: value})
    [problem] = caught.value.problems
    assert problem.line is not None and problem.line > 1
    assert stands in LINES[problem.line - 1]
    assert path in str(caught.value)
