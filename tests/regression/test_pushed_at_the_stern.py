"""A current that pushed a barge at her stern, since the area of her side said nothing of where it is.

Four lines held her in a current from abeam. Her side has its middle amidships, and what is not placed pushes
where the axes of a vessel begin: the worst line at the bow bore 115 kN and at the stern 159 kN, for 124 kN
each. Nothing was said.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario

TEXT = """\
format: 1
lift: {title: A barge in a current}
duration: 1 s
water: {density: 1025 kg/m^3, level: 0 m}
current: {speed: 1 m/s, direction: 90 deg}
vessels:
  barge:
    draft: 2 m
    hull: {box: [60 m, 20 m, 5 m]}
    masses: {all: {mass: 2460 t, at: [30 m, 0 m, 2 m]}}
    radii_of_gyration: [7 m, 17 m, 17 m]
    AREAS
plan: [{step: hold, hold: until_end}]
"""
SIDE, PLACE = "area: 120 m^2, coefficient: 1, along: y", "at: [30 m, 0 m, 1 m]"


def told(areas: str) -> list[str]:
    """Warnings of the lift file that name an area."""
    return [one for one in assemble(parse_scenario(TEXT.replace("AREAS", areas))).warnings if " area " in one]


@pytest.mark.parametrize(("kind", "size"), [("current", 120), ("wind", 180)])
def test_a_side_that_is_nowhere_is_told(kind: str, size: int) -> None:
    areas = f"{kind}_areas: {{side: {{{SIDE.replace('120', str(size))}}}}}"
    assert told(areas) == [
        f"the {kind} area side of barge has no 'at', and pushes at her stern and on her keel, where the axes "
        "of a vessel begin: say where its middle is"
    ]


@pytest.mark.parametrize("area", [f"{SIDE}, {PLACE}", SIDE.replace("along: y", "along: x")])
def test_one_that_has_a_place_or_is_ahead_is_not(area: str) -> None:
    """What pushes along x does so in the centre plane, wherever that is along the vessel."""
    assert told(f"current_areas: {{side: {{{area}}}}}") == []
