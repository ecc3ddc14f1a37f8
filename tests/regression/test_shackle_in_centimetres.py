"""A bow of 97 m.

`bow_diameter: 97 m` for 97 mm, or 97 cm, was taken as it stood. The bow is what a sling bends about: of
`rope_load_of_breaking_force` it took the bending factor 1/(1 - 0.5/sqrt(D/d)) away, for a sling of 44 mm 1.51
became 1.01, and slings that fail passed.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.scenario import ScenarioError, parse_scenario


def text(key: str, diameter: str) -> str:
    return LIFT.replace(
        "load:\n", f"shackles: {{wb40: {{working_load_limit: 40 t, {key}: {diameter}}}}}\nload:\n", 1
    )


@pytest.mark.parametrize("key", ["bow_diameter", "pin_diameter"])
@pytest.mark.parametrize(("diameter", "shown"), [("97 m", "97000"), ("97 cm", "970"), ("0.97 mm", "0.97")])
def test_what_no_shackle_has_is_refused(key: str, diameter: str, shown: str) -> None:
    with pytest.raises(ScenarioError, match=f"{shown} mm is no diameter of a shackle; from 4 mm to 500 mm"):
        parse_scenario(text(key, diameter))


@pytest.mark.parametrize("diameter", ["5 mm", "97 mm", "340 mm"])
def test_shackles_from_the_smallest_to_the_largest_are_taken(diameter: str) -> None:
    """Those of 0.33 t and of 1550 t, by makers' tables."""
    scenario = parse_scenario(text("bow_diameter", diameter))
    assert scenario.shackles is not None
    assert scenario.shackles["wb40"].bow_diameter == pytest.approx(float(diameter.split()[0]) / 1e3)
