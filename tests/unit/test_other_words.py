"""Keys by the words of other programs and other trades, which no misspelling leads to."""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, parse_scenario
from lift_text import spoiled


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (
            "weight: {calculated: 40 t, contingency: 1.15}",
            "mass: 40 t",
            "load.mass: .* did you mean 'weight'?",
        ),
        ("centre_of_gravity: {at", "cog: {at", "load.cog: .* did you mean 'centre_of_gravity'?"),
        ("shape: {box: [6 m, 4 m, 3 m]}", "size: [6 m, 4 m, 3 m]", "load.size: .* did you mean 'shape'?"),
        (
            "[-2.5 m,  1.5 m, 3 m], capacity",
            "[-2.5 m,  1.5 m, 3 m], wll",
            "lugs.A.wll: .* did you mean 'capacity'?",
        ),
        ("at: [0 m, 0 m, 11 m]", "position: [0 m, 0 m, 11 m]", "crane.position: .* did you mean 'at'?"),
        ("construction: 6x36 IWRC, grade: 1960", "EA: 90 MN", "sling.EA: .* did you mean 'axial_stiffness'?"),
        # What is there already is told as such.
        (
            "diameter: 44 mm",
            "diameter: 44 mm, radius: 22 mm",
            "sling.radius: .* is not a key of a rope; did you mean 'diameter', which is there already",
        ),
        ("diameter: 44 mm", "radius: 22 mm", "sling.radius: .* did you mean 'diameter', twice as much?"),
    ],
)
def test_another_word_leads_to_the_key(old: str, new: str, says: str) -> None:
    with pytest.raises(
        ScenarioError, match=says.replace(".", r"\.").replace(r"\.*", ".*").replace("?", r"\?")
    ):
        parse_scenario(spoiled(old, new, LIFT))
