"""Lugs at ends of ropes of `mechanics`, written as slings write theirs.

`lug: module.L1` was told only the names that there are, `body: module.L1` that it may be `module`, which puts
the end at the centre of gravity, and `padeye: L1` what keys an end has. A misspelt body was refused twice: as
none, and for having no lugs.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from shown import ROOT, lift_on

LIFT = lift_on(ROOT / "docs" / "guides" / "mechanics_in_a_lift_file.md", "A module on a spreader bar")
END = "{type: end, body: module, lug: L1}"


@pytest.mark.parametrize(
    ("written", "says"),
    [
        ("body: module, lug: module.L1", "lug: 'module.L1' is not a lug of 'module'; did you mean 'L1'?"),
        (
            "body: module.L1",
            f"body: 'module.L1' is not a body; an end at that lug is written '{END}'",
        ),
        ("body: L1", f"body: 'L1' is not a body; an end at that lug is written '{END}'"),
        (
            "body: module, padeye: L1",
            "padeye: 'padeye' is not a key of an end of a rope; did you mean 'lug'?",
        ),
        ("body: modul, lug: L1", "body: 'modul' is not a body; did you mean 'module'?"),
    ],
)
def test_one_sentence_says_what_is_right(written: str, says: str) -> None:
    with pytest.raises(ScenarioError) as found:
        parse_scenario(LIFT.replace(END, f"{{type: end, {written}}}"))
    assert str(found.value).endswith(f"mechanics.ropes.down_1.route[2].{says}")
    assert len(found.value.problems) == 1


def test_tag_lines_are_at_a_place() -> None:
    """They have no lug: all their keys were listed."""
    line = "{lug: L1, to: [10 m, 5 m, 0 m], rope: sling, pull: 5 kN}"
    with pytest.raises(ScenarioError, match="'lug' is not a key of a tag line; did you mean 'at'"):
        parse_scenario(LIFT + f"tag_lines: {{a: {line}}}\n")
