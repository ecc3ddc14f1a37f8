"""`require: {sling_tension: below 1000 MN}`, a thousand times off, was in order and let everything pass."""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario


def told(bound: str) -> list[str]:
    text = LIFT.replace("hold: 20 s}", f"hold: 20 s, require: {{{bound}}}}}")
    doubts = assemble(parse_scenario(text)).doubts
    return [one.sentence for one in doubts if "require" in one.path]


@pytest.mark.parametrize("key", ["sling_tension", "hook_load"])
def test_a_bound_that_nothing_comes_to(key: str) -> None:
    """40 t by a contingency of 1.15 at 9.81 m/s^2 weigh 451.3 kN, of which 1000 MN are 2216 times."""
    times = "1,000 MN are 2,216 times what all of the load weighs, 451.3 kN"
    assert told(f"{key}: below 1000 MN") == [f"{times}, and let everything pass; a unit or digit has slipped"]


@pytest.mark.parametrize(
    "bound", ["sling_tension: below 1 MN", "hook_load: below 40 MN", "hook_load: above 1 kN"]
)
def test_bounds_that_may_be_meant(bound: str) -> None:
    assert told(bound) == []
