"""Wind areas of a vessel far above her hull, by a slip of the unit: she heels by a lever that is none.

Places of areas of a load off its box were told, and of a vessel nothing: a deckhouse with its middle 9000 m
up, for mm, capsized her, and one at 90 m for 9.0 m had her heel ten times as far, without a word.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario

TEXT = """\
format: 1
lift: {title: A barge in wind}
duration: 1 s
water: {density: 1025 kg/m^3, level: 0 m}
wind: {speed: 10 m/s, direction: 90 deg}
vessels:
  barge:
    draft: 2 m
    hull: {box: [60 m, 20 m, 5 m]}
    masses: {all: {mass: 2460 t, at: [30 m, 0 m, 2 m]}}
    radii_of_gyration: [7 m, 17 m, 17 m]
    wind_areas: {house: {area: 180 m^2, coefficient: 1.2, along: y, at: PLACE}}
plan: [{step: hold, hold: until_end}]
"""


def told(place: str) -> list[str]:
    """Warnings of the lift file that name an area that pushes somewhere."""
    warnings = assemble(parse_scenario(TEXT.replace("PLACE", place))).warnings
    return [one for one in warnings if " area house " in one]


@pytest.mark.parametrize(
    ("place", "off"),
    [("[30 m, 0 m, 90 m]", "85.0 m"), ("[30 m, 0 m, 9000 m]", "8995.0 m"), ("[300 m, 0 m, 9 m]", "240.0 m")],
)
def test_an_area_far_off_is_told(place: str, off: str) -> None:
    """90 m - 5 m of her deck, 300 m - 60 m of her bow, farther than half of her 60 m."""
    assert told(place) == [
        f"the wind area house of barge pushes {off} off her hull and all masses; a unit or digit has slipped"
    ]


@pytest.mark.parametrize("place", ["[30 m, 0 m, 9 m]", "[30 m, 0 m, 34 m]", "[85 m, 0 m, 9 m]"])
def test_one_of_a_mast_or_what_overhangs_is_not(place: str) -> None:
    """Up to half of her length above her deck or ahead of her bow."""
    assert told(place) == []
