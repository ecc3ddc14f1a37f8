"""What is said of hooks whose levels are to be compared and that are no two hooks."""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from hooked_lift import TWO_HOOKS_LUGS, hooked_lift

HOOKS = {"A": (-4.0, 0.0, 16.0), "B": (4.0, 0.0, 16.0)}
SLINGS = {name: (hook, name, 12.0) for hook, names in (("A", "12"), ("B", "34")) for name in names}


def lift(limit: str) -> str:
    more = f"limits: {{hook_level_difference: {limit}}}\n"
    return hooked_lift(HOOKS, TWO_HOOKS_LUGS, SLINGS, position=(0.0, 0.0, 0.0), more=more)


def test_what_travels_with_the_lift() -> None:
    """The limit as a length, as ever, and the hooks that it is of; none is all."""
    rig = assemble(parse_scenario(lift("{between: [A, B], largest: 50 mm}"))).rig
    assert (rig["limits"]["hook_level_difference"], rig["level_hooks"]) == (0.05, ["A", "B"])
    rig = assemble(parse_scenario(lift("50 mm"))).rig
    assert rig["limits"]["hook_level_difference"] == 0.05 and "level_hooks" not in rig


@pytest.mark.parametrize(
    ("limit", "said"),
    [
        ("{between: [A], largest: 1 m}", "found a list of 1; at least 2 are needed, such as [U1, U2]"),
        ("{between: [A, A], largest: 1 m}", "names a hook twice; hooks are compared with each other"),
        ("{between: [A, X], largest: 1 m}", ".between: 'X' is not a hook; known here: 'A', 'B'"),
        ("{between: [A, B]}", "'largest' is missing"),
        ("{between: [A, B], max: 1 m}", "'max' is not a key"),
        ("50", "'50' has no unit"),
    ],
)
def test_messages(limit: str, said: str) -> None:
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(lift(limit))
    assert "limits.hook_level_difference" in str(refused.value)
    assert said in str(refused.value)
