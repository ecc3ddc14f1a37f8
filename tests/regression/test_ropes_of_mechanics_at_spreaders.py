"""What `mechanics` hangs from a spreader of the yard.

`body: bar` in a route, where the lift file has a spreader `bar`, was answered by "'bar' is not a body" and
names of others: who looks at the spreader in the same file does not see what is meant. So it was of
compensators and extension sheaves, and of tag lines that are `held_by` one.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from spreader_lifts import one_bar

BALL = "    ball: {joint: {type: point, position: [0 m, 0 m, 5 m]}, mass: 1 t}\n"
PLANE = "{point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}"
ALONE = "'bar' is a spreader, which slings alone are made fast to; "
RIGHT = "for anything else make it a body of 'mechanics'"


def refused(text: str) -> str:
    with pytest.raises(ScenarioError) as problem:
        parse_scenario(one_bar() + text)
    return str(problem.value)


@pytest.mark.parametrize(
    ("path", "text"),
    [
        (
            "ropes.r.route[1].body",
            f"  bodies:\n{BALL}  ropes:\n    r: {{rope: sling, length: 4 m, route: "
            "[{type: end, body: bar}, {type: end, body: ball}]}\n",
        ),
        ("bodies.ball.parent", f"  bodies:\n{BALL.replace('joint', 'parent: bar, joint')}"),
        (
            "contacts.c.body",
            f"  contacts:\n    c: {{body: bar, at: [0 m, 0 m, 0 m], plane: {PLANE}, stiffness: 1 MN/m, "
            "damping: 10 kN s/m, friction: 0.3}\n",
        ),
    ],
)
def test_slings_alone_are_made_fast_to_it(path: str, text: str) -> None:
    assert f"mechanics.{path}: {ALONE}{RIGHT}" in refused(f"mechanics:\n{text}")


def test_it_holds_no_tag_line() -> None:
    line = "t: {at: [-5 m, 0 m, 1 m], to: [0 m, 0 m, 0 m], held_by: bar, rope: sling, pretension: 1 kN}"
    said = f"{ALONE}a vessel, a part of a crane, a hook or a body may hold a tag line"
    assert f"tag_lines.t.held_by: {said}" in refused(f"tag_lines:\n  {line}\n")


def test_of_other_names_the_known_ones_are_told() -> None:
    text = f"mechanics:\n  bodies:\n{BALL.replace('joint', 'parent: bare, joint')}"
    assert "mechanics.bodies.ball.parent: 'bare' is not a body; known here: 'hook'" in refused(text)
