"""`type: strand_jack` was answered with the list of cranes, though a page says how to write one."""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, parse_scenario


@pytest.mark.parametrize(
    ("kind", "says"),
    [
        (
            "strand_jack",
            "a strand jack is a drum of 'mechanics' with a 'drive', its bundle a rope from there to "
            "the load; or 'type: fixed_hook' with a sling, where the load goes straight up",
        ),
        ("gantry_crane", "a 'gantry_crane' is written as 'type: goliath' here"),
        ("pedestal_crane", "a 'pedestal_crane' is written as 'type: floating_crane' here"),
        (
            "tower_crane",
            "a tower crane that luffs is written as 'type: floating_crane', ashore with 'position' and "
            "'heading' in place of a 'vessel'; none here has a level jib",
        ),
        ("mobile_crane", "a 'mobile_crane' is written as 'type: crawler' here"),
        ("cableway", "'cableway' is not a type of crane; known here:"),
    ],
)
def test_what_is_written_for_it(kind: str, says: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(LIFT.replace("type: fixed_hook", f"type: {kind}"))
    assert f"cranes.crane.type: {says}" in str(caught.value)
