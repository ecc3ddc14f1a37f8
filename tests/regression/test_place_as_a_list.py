"""Places of supports as lists, `p1: [-2 m, 1.5 m]`, and an answer that left the key out that they need.

"a place of a support is a mapping with keys such as height, stiffness, damping, friction, capacity, top": all
of these may be left out, and `at` may not.
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.scenario import parse_scenario

SUPPORTS = "supports: {stools: {under: module, places: {p1: [-2 m, 1.5 m]}, height: 1 m}}\ncranes:\n"


def test_what_a_mapping_needs_is_named_first() -> None:
    with pytest.raises(gantline.ScenarioError) as caught:
        parse_scenario(LIFT.replace("cranes:\n", SUPPORTS))
    assert "found a list; a place of a support is a mapping with keys such as at, height," in str(
        caught.value
    )
