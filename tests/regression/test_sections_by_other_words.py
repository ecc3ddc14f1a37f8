"""Sections that a newcomer calls by another name were taken for others that are merely written alike.

Another word for `ropes` was asked "did you mean 'waves'?", and `crane` beside `cranes` "did you mean
'cases'?": of the keys that were left over, and not of all, the one written most alike was named. Of
`lifting_points` of a load, `hook` and `lug` of a sling, `criteria`, `sea` and `title` nothing was said
but what is known there.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.scenario.errors import ScenarioError
from lift_text import spoiled

#: A piece of a lift, what stands in its place, and the key that is meant.
# <!-- words: off -->
OTHER_WORDS = [
    ("\nropes:\n", "\nwires:\n", "ropes"),
    ("\nropes:\n", "\ncables:\n", "ropes"),
    ("\nropes:\n", "\nwire_ropes:\n", "ropes"),
    ("\nplan:\n", "\nsequence:\n", "plan"),
    ("\nlimits:", "\ncriteria:", "limits"),
    ("  lugs:\n", "  padeyes:\n", "lugs"),
    ("  lugs:\n", "  lifting_points:\n", "lugs"),
    ("{from: e1.1, to: block.L1", "{hook: e1.1, to: block.L1", "from"),
    ("to: block.L1", "lug: block.L1", "to"),
    ("{calculated: 60 t", "{mass: 60 t", "calculated"),
    ("\nplan:\n", "\nbarge: {}\nplan:\n", "vessels"),
    ("\nplan:\n", "\nsea: {}\nplan:\n", "waves"),
]
# <!-- words: on -->


def answers(old: str, new: str) -> list[str]:
    """What is said, without file, line and path."""
    with pytest.raises(ScenarioError) as found:
        parse_scenario(spoiled(old, new))
    return [line.split(": ", 2)[2] for line in str(found.value).splitlines()]


@pytest.mark.parametrize(("old", "new", "key"), OTHER_WORDS)
def test_a_section_by_another_word_is_named(old: str, new: str, key: str) -> None:
    with pytest.raises(ScenarioError) as found:
        parse_scenario(spoiled(old, new))
    assert any(line.endswith(f"; did you mean '{key}'?") for line in str(found.value).splitlines())


def test_what_is_written_most_alike_may_be_there_already() -> None:
    said = answers("\nplan:\n", "\ncrane: {}\nplan:\n")
    assert said == ["'crane' is not a key of a lift file; did you mean 'cranes', which is there already?"]


@pytest.mark.parametrize(
    ("new", "says"),
    [
        (
            "title: Module",
            "'title' has another place: it belongs to 'lift': {title: Four slings lift a module}",
        ),
        (
            "gravity: 9.8 m/s^2",
            "'gravity' has another place: it belongs to 'simulation': {gravity: 9.81 m/s^2}",
        ),
    ],
)
def test_what_belongs_elsewhere_is_told_where(new: str, says: str) -> None:
    assert answers("\nplan:\n", f"\n{new}\nplan:\n") == [says]
