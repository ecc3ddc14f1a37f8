"""Two trolleys were sent to one place, and nothing said so.

After a bow section had been turned its plan took both trolleys to its stools,
`traverse: [upper, lower], to: 23 m`: the falls of both hooks then hung in each other. `hook_distance` was not
in the lift file, and without it neither `gantline check` nor a run looked at where hooks hang. Two hooks at
one place of a boom passed as well.
"""

from __future__ import annotations

import pytest

from boom_lift import boom_lift
from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from goliath_lift import goliath_lift
from lift_text import changed

#: Diameter of the sheaves of both hooks [m].
WIDTH = 1.0
END = "{step: end, hold: until_end}"


def _told(*plan: str, at: float = 20.0, across: float = 0.0, more: str = "") -> list[tuple[str, str]]:
    """What is said of a hook A at -20 m along the girder and of a hook B of a second trolley [m]."""
    two = (
        "      two:\n        mass: 200 t\n"
        f"        position: {at} m\n"
        "        traverse: {speed: 30 m/min, acceleration: 0.03 m/s^2, range: [-60 m, 60 m]}\n"
        f"        hooks: {{B: {{type: H, height: 40 m, across: {across} m}}}}\n"
    )
    text = goliath_lift("\n".join([*plan, END]), more=two)
    text = changed(text, ("    hook_distance: 12 m\n", more))
    doubts = assemble(parse_scenario(text)).doubts
    return [(one.path, one.sentence) for one in doubts if "hook_distance" in one.sentence]


def _traverse(what: str, to: float) -> str:
    return f"{{step: go, traverse: {what}, speed: 20 m/min, to: {to} m}}"


@pytest.mark.parametrize(("apart", "is_told"), [(0.0, True), (0.9, True), (1.1, False)])
def test_trolleys_sent_to_one_place(apart: float, is_told: bool) -> None:
    """Nearer than a diameter of their sheaves, hooks are in each other."""
    sentence = (
        f"where step 'go' ends gol.A and gol.B are {apart:.2f} m apart along the girder and 0.00 m across "
        "it: their falls are in each other; 'hook_distance' of the crane says how near they may come"
    )
    assert _told(_traverse("two", -20.0 + apart)) == ([("plan[1]", sentence)] if is_told else [])
    assert len(_told(_traverse("[one, two]", 10.0))) == 1


def test_at_the_start() -> None:
    """Told at the hook."""
    ((path, sentence),) = _told(at=-20.5)
    assert path == "cranes.gol.trolleys.one.hooks.A"
    assert sentence.startswith("at the start gol.B and gol.A are 0.50 m apart along the girder")


def test_hooks_that_pass_each_other() -> None:
    """In one plane they cannot; beside each other they can, as over a load that is turned over."""
    ((path, sentence),) = _told(_traverse("two", -40.0))
    assert path == "plan[1]"
    assert "gol.B has gone past gol.A, 0.00 m beside it: falls do not pass each other" in sentence
    assert _told(_traverse("two", -40.0), across=WIDTH) == []


def test_where_the_plan_looks_at_distances_itself() -> None:
    """With a `hook_distance` what is nearer is refused by that."""
    assert _told(_traverse("two", 10.0), more="    hook_distance: 0.5 m\n") == []


def test_two_hooks_at_one_place_of_a_boom() -> None:
    """Both at the middle of the head, where nothing tells them apart; 5 m apart they are two."""
    hooks = "H1: {type: H, height: 40 m}\nH2: {type: H, height: 50 m}"
    for text, is_told in ((hooks, True), (changed(hooks, ("50 m}", "50 m, across: 5 m}")), False)):
        doubts = assemble(parse_scenario(boom_lift(hooks=text))).doubts
        found = [(one.path, one.sentence) for one in doubts if "one place" in one.sentence]
        sentence = "fc.H1 and fc.H2 hang in one place of their boom: 'across' and 'along' tell hooks apart"
        assert found == ([("cranes.fc.hooks.H2", sentence)] if is_told else [])
