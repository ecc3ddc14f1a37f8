"""A section that was indented under the one above it was taken for a name there.

`spreaders:` two blanks too far in, under `cranes`, was "cranes.spreaders: 'type' is missing; a crane is one
of ..."; with what belongs to it at the same depth it was "nothing is given here; write a value or leave the
key out". Neither says that it stands too far in.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from lift_text import MECHANICS, spoiled


def said(text: str) -> list[str]:
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text)
    return [f"{one.path}: {one.sentence}" for one in error.value.problems]


@pytest.mark.parametrize(
    "given", ["\n    bar: {box: [4 m, 1 m, 1 m], mass: 2 t}", " {bar: {mass: 2 t}}", " 2"]
)
def test_with_what_belongs_to_it(given: str) -> None:
    assert said(spoiled("equalizers:\n", f"  spreaders:{given}\nequalizers:\n")) == [
        "cranes.spreaders: 'spreaders' is not a name in 'cranes', but a section of a lift file: it stands "
        "too far in"
    ]


def test_with_what_belongs_to_it_beside_it() -> None:
    assert said(spoiled("equalizers:\n", "  spreaders:\n  bar:\n    mass: 2 t\nequalizers:\n")) == [
        "cranes.spreaders: nothing is given here; write a value or leave the key out (is 'spreaders' a "
        "section of the file? then it stands too far in)"
    ]


def test_a_thing_that_has_the_name_of_a_section() -> None:
    """Its own keys say what it is."""
    text = spoiled("  thick: {axial_stiffness: 100 MN", "  tag_lines: {axial_stifness: 1 MN, diameter: 9 mm")
    assert said(text.replace("rope: thick", "rope: tag_lines")) == [
        "ropes.tag_lines.axial_stifness: 'axial_stifness' is not a key of a rope; did you mean "
        "'axial_stiffness'?"
    ]


def test_ropes_of_mechanics_are_no_section_of_the_file() -> None:
    begin = MECHANICS.index("  ropes:\n    rope:")
    assert said(f"{MECHANICS[:begin]}  ropes:\n") == [
        "mechanics.ropes: nothing is given here; write a value or leave the key out"
    ]
