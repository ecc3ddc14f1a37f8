"""A misspelt key that a mapping cannot be without was told twice.

`duratoin: 20 s` was "'duration' is missing; a lift file needs it (is 'duratoin' a misspelt 'duration'?)" in
line 1 and "'duratoin' is not a key of a lift file; did you mean 'duration'?" in its own: two problems to look
for, and the first in a line that is right.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from lift_text import spoiled


def said(old: str, new: str) -> list[str]:
    with pytest.raises(ScenarioError) as error:
        parse_scenario(spoiled(old, new))
    return [f"{one.line}: {one.path}: {one.sentence}" for one in error.value.problems]


@pytest.mark.parametrize(
    ("old", "new", "answer"),
    [
        (
            "duration: 20 s",
            "duratoin: 20 s",
            "4: duratoin: 'duratoin' is not a key of a lift file; did you mean 'duration'?",
        ),
        (
            "speed: 3 m/min, start_at",
            "sped: 3 m/min, start_at",
            "43: plan[1].sped: 'sped' is not a key of a hoist step; did you mean 'speed'?",
        ),
        (  # by another word, not by its letters
            "  centre_of_gravity:",
            "  cog:",
            "17: load.cog: 'cog' is not a key of the load; did you mean 'centre_of_gravity'?",
        ),
    ],
)
def test_it_is_told_in_its_own_line(old: str, new: str, answer: str) -> None:
    assert said(old, new) == [answer]


def test_what_is_missing_beside_an_unknown_key_is_still_told() -> None:
    answers = said("weight: {calculated: 60 t, contingency: 1.05}", "weight: {contingecy: 1.05}")
    assert answers == [
        "16: load.weight: 'calculated' is missing; the weight of a load needs it (calculated or weighed "
        "weight, without margin)",
        "16: load.weight.contingecy: 'contingecy' is not a key of the weight of a load; did you mean "
        "'contingency'?",
    ]
