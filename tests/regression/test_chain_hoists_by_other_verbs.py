"""Mistakes in the first lines that a user writes about a chain hoist were answered with what does not help.

`range: 1.5 m` was told that `[1.5 m, 1.5 m]` is right, which the next message refused. A step that said
`haul_in: sling.B` or `hoist: sling.B` was told of drums and hooks alone; the verbs are 'haul' and 'veer'.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from levelled import TWO

PLAN = "  - {step: level, haul: sling.B, speed: 1 m/min, by: 0.2 m}"


def message(plan: str = PLAN, hoist: str = "") -> str:
    """What a lift file is refused with."""
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(TWO.text(plan, duration=30.0, hoist=hoist))
    return str(refused.value)


def test_a_range_of_one_length() -> None:
    said = message(hoist=", range: 1.5 m")
    assert said.endswith("found '1.5 m'; a list of 2 is needed, such as [-0.5 m, 1.5 m]")
    parse_scenario(TWO.text(PLAN, duration=30.0, hoist=", range: [-0.5 m, 1.5 m]"))


@pytest.mark.parametrize("verb", ["haul_in", "pay_out", "hoist", "lower"])
@pytest.mark.parametrize("name", ["sling.B", "B"])
def test_a_verb_for_drums_or_hooks(verb: str, name: str) -> None:
    said = message(PLAN.replace("haul: sling.B", f"{verb}: {name}"))
    assert said.endswith(
        f"'{name}' is a sling; 'haul' shortens it by its chain hoist, and 'veer' lengthens it"
    )
    other = message(PLAN.replace("haul: sling.B", f"{verb}: A"))
    assert "'veer'" not in other
