"""`slamming_coefficient` of a load without added mass along z: "the height of a layer is 0".

The blow is that of added mass along z as it comes, over the depth d = 2 A/(ρ S C) of (LW5), which is 0
without any. `gantline check` found nothing, and the run was refused in words of the core, at the line of the
load and not at that of the coefficient.
"""

from __future__ import annotations

import pytest

from gantline import Simulation
from gantline.scenario import ScenarioError, load_scenario, parse_scenario


@pytest.mark.parametrize("added", [["30 t", "40 t", "0 t"], ["0 t", "0 t", "0 t"]])
def test_is_told_where_it_stands(added: list[str]) -> None:
    """Before anything is assembled, with what would be right."""
    with pytest.raises(ScenarioError) as caught:
        load_scenario("splash_zone").changed({"load.in_water.added_mass": added})
    (message,) = str(caught.value).splitlines()
    said = "slamming_coefficient: what slams is the added mass along z as it comes, and that is 0"
    right = "give the third number of 'added_mass', or leave 'slamming_coefficient' out"
    assert f"load.in_water.{said}; {right}" in message


def test_without_the_coefficient_it_is_in_order() -> None:
    """What has no added mass along z, and no blow to make of it, is borne and resisted by water alone."""
    text = load_scenario("splash_zone").text
    for was, words in (("slamming_coefficient: 5", ""), ("[30 t, 40 t, 80 t]", "[0 t, 0 t, 0 t]")):
        assert was in text
        text = text.replace(was, words)
    assert Simulation(parse_scenario(text)).time == 0.0
