"""Messages about the plan: the name of the step stands before its place, which nobody has counted."""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from gantline.scenario.errors import Problem
from lift_text import BASE, spoiled


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("{step: hoist, hoist: hook", "{step: hoist, hoist: hoko", "step 'hoist', plan[1].hoist: 'hoko'"),
        # While the file is read as YAML; the name stands before what is wrong.
        ("{step: hoist, hoist: hook,", "{step: hoist, hoist: hook, hoist: hook,", "step 'hoist', plan[1]: '"),
        # One that has no name, or a wrong one, has its place alone.
        ("{step: hoist, hoist: hook", "{hoist: hoko", "plan[1]"),
        ("{step: hoist, hoist: hook", "{step: [a, b], hoist: hook", "plan[1].step: "),
        # What is no step has none.
        ("rated_capacity: 100 t", "rated_capacity: 100 m", "cranes.hook.rated_capacity: "),
    ],
)
def test_the_step_is_named_where_it_has_a_name(old: str, new: str, says: str) -> None:
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(spoiled(old, new), "lift.yaml")
    assert str(refused.value).splitlines()[0].partition(": ")[2].startswith(says)


def test_a_sentence_that_names_the_step_is_left_alone() -> None:
    twice = Problem(7, "plan[2].to", "step 'up' goes too far", "up")
    assert twice.of("lift.yaml") == "lift.yaml:7: plan[2].to: step 'up' goes too far"
    other = Problem(7, "plan[2].to", "step 'down' comes before", "up")
    assert other.of("lift.yaml") == "lift.yaml:7: step 'up', plan[2].to: step 'down' comes before"


def test_a_name_of_a_step_that_is_taken_is_said_at_its_place() -> None:
    name = BASE.partition("{step: hoist,")[2].partition("{step: ")[2].partition(",")[0]
    with pytest.raises(ScenarioError, match=r"plan\[2\].step: 'hoist' is the name of plan\[1\] already"):
        parse_scenario(spoiled(f"{{step: {name},", "{step: hoist,"), "lift.yaml")
