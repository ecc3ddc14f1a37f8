"""A key that was missing was named, and nobody said what it is.

"'under' is missing; a group of supports needs it" sent a newcomer to the reference, though the models of the
lift file say in words what each key is.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (
            "supports: {stools: {grid: {x: [0 m], y: [0 m]}, height: 1 m}}",
            "supports.stools: 'under' is missing; a group of supports needs it "
            "(what they stand under: the name of the load)",
        ),
        (
            "wind: {speed: 9 m/s}",
            "wind: 'direction' is missing; wind needs it "
            "(direction in which it moves, from world x towards y)",
        ),
        # Where its words are those of the key they are left out.
        ("shackles: {s: {mass: 20 kg}}", "shackles.s: 'working_load_limit' is missing; a shackle needs it"),
    ],
)
def test_it_is_said_in_brackets(line: str, said: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(f"format: 1\nlift: {{title: A}}\nduration: 1 s\n{line}\n")
    assert said in [f"{one.path}: {one.sentence}" for one in caught.value.problems]
