"""A pile of 10,000 t with a wall of 72 mm, which weighs 991 t, was in order.

Only loads `in_water` were held against what they displace.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import pytest

from gantline.assembly.doubts.weight import doubtful_density
from gantline.scenario import parse_scenario
from hull_lift import text
from round_lift import round_lift

#: 7850 kg/m3 times the ring of 7.5 m, 72 mm thick and 75 m long [t].
WALL = 7.85 * math.pi * (7.5 - 0.072) * 0.072 * 75.0


def told(shape: Mapping[str, object], mass: float) -> list[str]:
    """What is told of a load of that mass [t]."""
    given = round_lift(
        {"diameter": "1 m", "length": "2 m"}, (0.0, 0.0, 0.5), load={"weight": {"calculated": f"{mass!r} t"}}
    )
    given["load"]["shape"] = shape
    return [one.sentence for one in doubtful_density(parse_scenario(text(given)))]


@pytest.mark.parametrize(
    ("share", "is_told"), [(0.09, True), (0.11, False), (1.0, False), (4.9, False), (5.1, True), (10.0, True)]
)
def test_a_tube_is_held_against_its_wall(share: float, is_told: bool) -> None:
    tube = {"cylinder": {"diameter": "7.5 m", "length": "75 m", "wall": "72 mm"}}
    found = told(tube, share * WALL)
    assert bool(found) is is_told
    assert all(f"its wall of steel {WALL:.1f} t; a " in one and one.endswith("has slipped") for one in found)


@pytest.mark.parametrize(("share", "is_told"), [(1.44, False), (1.51, True)])
def test_what_is_solid_is_held_against_steel(share: float, is_told: bool) -> None:
    """Lead fills it with 1.44 times what steel would weigh there."""
    rod = {"cylinder": {"diameter": "1 m", "length": "2 m"}}
    assert bool(told(rod, share * 7.85 * math.pi / 2.0)) is is_told
