"""Braces, blanks and units in the wrong place were answered with quotes.

`S1 {from: hook, ...}` and `S1: from: hook, to: block.L1` had "a second ':' in one value; a text with a
colon is put into quotes", which makes a text of a sling. `[0.2, 0, 1.4] m` was told that "a quote is not
closed", and `{from hook, ...}` to leave the key `from hook` out.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.scenario.errors import ScenarioError
from lift_text import spoiled

S2 = "S2: {from: e1.2, to: block.L2, length: 13 m, rope: sling, tolerance: 0.25 %}"
WEIGHT = "weight: {calculated: 60 t, contingency: 1.05}"
HOIST = "- {step: hoist, hoist: hook, speed: 3 m/min, start_at: 0 s, brake_from: 10 s}"
AT = "at: [0 m, 0 m, 1.5 m]}"


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (S2, S2.replace(": {", " {"), "'S2' and its braces are parted by a ':' and a blank: write 'S2: {'"),
        (S2, S2.replace(": {", ":{"), "'S2' and its braces are parted by a ':' and a blank: write 'S2: {'"),
        (
            S2,
            S2.replace("{", "").replace("}", ""),
            "several keys in one line stand in braces, 'S2: {from: e1.2, ...}'; "
            "a text with a colon in quotes",
        ),
        (
            WEIGHT,
            "weight: calculated: 60 t, contingency: 1.05",
            "several keys in one line stand in braces, 'weight: {calculated: 60 t, ...}'; "
            "a text with a colon in quotes",
        ),
        (
            HOIST,
            HOIST.replace("{", "").replace("}", ""),
            "several keys in one line stand in braces, '- {step: hoist, ...}'; a text with a colon in quotes",
        ),
        (
            "title: A test lift",
            "title: Lift of: it",
            "a second ':' in one value; a text with a colon is put into quotes",
        ),
        (
            AT,
            "at: [0, 0, 1.5] m}",
            "'m' stands behind a list; each number in it has its own unit: [0 m, 0 m, 1.5 m]",
        ),
        (
            S2,
            S2.replace("from: ", "from "),
            "slings.S2.from e1.2: nothing is given here; write a value or leave the key out "
            "(is a ':' missing behind 'from'?)",
        ),
        (
            S2,
            S2.replace("to: ", "to "),
            "slings.S2.to block.L2: nothing is given here; write a value or leave the key out "
            "(several go into a list, [A, B]; a text with a comma in it stands in quotes; "
            "is a ':' missing behind 'to'?)",
        ),
    ],
)
def test_the_answer_names_what_is_missing(old: str, new: str, says: str) -> None:
    text = spoiled(old, new)
    with pytest.raises(ScenarioError) as found:
        parse_scenario(text)
    line = 1 + text[: text.index(new[:8])].count("\n")
    assert str(found.value) == f"scenario.yaml:{line}: {says}"


def test_a_unit_behind_a_list_on_a_line_of_its_own() -> None:
    with pytest.raises(ScenarioError, match=r"each number in it has its own unit: \[0 m, 0 m, 0 m\]"):
        parse_scenario(spoiled("position: [0 m, 0 m, 0 m]", "position: [0, 0, 0] m"))
