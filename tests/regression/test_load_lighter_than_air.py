"""A module of 72 m3 that weighs 40 kg, and one of which two lugs are one.

`calculated: 40 kg` for 40 t was GO: its four slings weighed more than it did. So was a lug whose place had
been copied from another: three corners were held, and each of both lugs against what one sling pulls.
`60000 t` for 60 t was told as ground that is too soft, which a harder ground made good.
"""

from __future__ import annotations

import pytest

from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import StartError, parse_scenario
from lift_text import spoiled


def warnings(old: str, new: str) -> list[str]:
    return list(assemble(parse_scenario(spoiled(old, new, LIFT))).warnings)


@pytest.mark.parametrize(
    ("weight", "is_told"), [("40 kg", True), ("86 kg", True), ("87 kg", False), ("40 t", False)]
)
def test_what_weighs_less_than_air_is_told(weight: str, is_told: bool) -> None:
    """1.2 kg/m3 in a box of 6 x 4 x 3 m are 86.4 kg."""
    said = [
        one for one in warnings("calculated: 40 t", f"calculated: {weight}") if "the air in its box" in one
    ]
    assert len(said) == is_told
    assert all("86.4 kg" in one for one in said)


@pytest.mark.parametrize(("weight", "is_told"), [("600 t", True), ("564 t", False)])
def test_what_weighs_more_than_steel_is_told(weight: str, is_told: bool) -> None:
    """7850 kg/m3 in that box are 565.2 t."""
    said = [one for one in warnings("calculated: 40 t", f"calculated: {weight}") if "full of steel" in one]
    assert len(said) == is_told
    assert all("565.2 t" in one for one in said)


def test_a_load_that_sinks_into_its_ground_is_told_with_its_weight() -> None:
    with pytest.raises(StartError, match=r"the load of 600000\.1 t would sink .* or a smaller weight"):
        warnings("calculated: 40 t", "calculated: 600000 t")


@pytest.mark.parametrize(("x", "is_told"), [("2.5 m", True), ("2.5005 m", True), ("2.51 m", False)])
def test_lugs_at_one_place_are_told(x: str, is_told: bool) -> None:
    """B is at (2.5, 1.5, 3) m."""
    said = warnings("A: {at: [-2.5 m,  1.5 m, 3 m]", f"A: {{at: [{x},  1.5 m, 3 m]")
    assert [one for one in said if "are at one place" in one] == [
        "lugs A and B are at one place; one lug would bear the slings of both"
    ] * is_told
