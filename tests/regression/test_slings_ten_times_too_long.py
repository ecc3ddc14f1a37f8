"""A sling with a digit too many, 60 m for 6 m, which was found in order: its run hoisted until its end."""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift

LUGS = {"A": (-2.5, 0.0, 3.0), "B": (2.5, 0.0, 3.0)}


@pytest.mark.parametrize(("length", "warned"), [(6.0, False), (12.0, False), (60.0, True)])
def test_a_sling_much_longer_than_its_way_is_told(length: float, warned: bool) -> None:
    """With its way, (2.5² + 5.3²)^½ = 5.86 m; twice as long it may hang from a hook that is low."""
    slings = {"A": ("hook", "A", length), "B": ("hook", "B", 6.0)}
    warnings = assemble(parse_scenario(hooked_lift({"hook": (0, 0, 8.3)}, LUGS, slings))).warnings
    told = [text for text in warnings if "m long" in text]
    way = "from 'hook' to 'load.A' it is 5.86 m at the start"
    assert told == [f"sling A is 60 m long, and {way}; check the number and its unit"] * warned
