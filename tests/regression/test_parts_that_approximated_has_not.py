"""Equalizing rope and moving sheaves of an equalizer with `mechanism: approximated`, which has neither.

Its slings hang from the frame, and no rope runs over sheaves; `cut: e1.equalizing` was taken for a rope all
the same, and `gantline check` and `gantline run` ended in a traceback: an IndexError.
So did a rope of `mechanics` that ends at `e1.2` and a tag line held by it, in a KeyError; of a body whose
parent it is the core said that no such body stands before it.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from lift_text import changed, spoiled

APPROXIMATED = "    mechanism: approximated\n    adjusting_factor: 0.02\n"
HOLD = "  - {step: hold, hold: until_end}\n"
CUT = "  - {step: hold, hold: until_end, cut: e1.equalizing}\n"
KIND = f"equalizer_types:\n  old:\n{APPROXIMATED}equalizers:\n  e1:\n    type: old\n"


@pytest.mark.parametrize(
    ("old", "new"),
    [("    rope: thick\n", f"{APPROXIMATED}    rope: thick\n"), ("equalizers:\n  e1:\n", KIND)],
    ids=["its own word", "of its type"],
)
def test_it_is_refused(old: str, new: str) -> None:
    with pytest.raises(ScenarioError) as problem:
        parse_scenario(changed(spoiled(old, new), (HOLD, CUT)))
    said = "plan[2].cut: 'e1.equalizing' is not a rope; known here: 'sling.S1', 'sling.S2'"
    assert said in str(problem.value)


def test_of_sheaves_it_is_cut() -> None:
    document = assemble(parse_scenario(spoiled(HOLD, CUT))).document
    assert document["plan"][1]["cuts"] == ["e1.equalizing"]


BALL = "ball: {joint: {type: point, position: [0 m, 0 m, 9 m]}, mass: 1 t}"
ROUTE = "[{type: end, body: e1.2}, {type: end, body: ball}]"


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (
            f"mechanics:\n  bodies: {{{BALL}}}\n"
            f"  ropes: {{r: {{rope: sling, length: 9 m, route: {ROUTE}}}}}\n",
            "mechanics.ropes.r.route[1].body: 'e1.2' is not a body",
        ),
        (
            f"mechanics:\n  bodies: {{{BALL.replace('joint', 'parent: e1.2, joint')}}}\n",
            "mechanics.bodies.ball.parent: 'e1.2' is not a body",
        ),
        (
            "tag_lines: {t: {at: [0 m, 0 m, 1 m], to: [0, 0, 0], held_by: e1.2, rope: sling, pull: 1 kN}}\n",
            "tag_lines.t.held_by: 'e1.2' is not a vessel, a part of a crane or a body",
        ),
    ],
    ids=["rope", "body", "tag line"],
)
def test_nothing_is_made_fast_to_a_sheave_that_does_not_move(more: str, said: str) -> None:
    text = spoiled("    rope: thick\n", f"{APPROXIMATED}    rope: thick\n") + more
    with pytest.raises(ScenarioError) as problem:
        parse_scenario(text)
    assert said in str(problem.value)
