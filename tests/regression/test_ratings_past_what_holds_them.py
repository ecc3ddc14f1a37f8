"""Ratings ten times too high passed every check, and the lift was GO with them.

A hook of 300 t written as 3000 t has room for every load. Bounds by what has been built told what is a
thousand times too much, and nothing of a slipped decimal: `rated_capacity: 5000 t` of a hook whose 24 falls
break at 3305 t, a shackle of 35 t written as 350 t, a lug of 40 t as 392 t, which is kN for t.
"""

from __future__ import annotations

import csv
import math

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario

#: Standard gravity of lift files [m/s^2].
G = 9.81


def told(lift: str, **changes: object) -> list[str]:
    scenario = load_scenario(lift).changed({key.replace("__", "."): one for key, one in changes.items()})
    doubts = assemble(scenario).doubts
    return [f"{one.path}: {one.sentence}" for one in doubts]


@pytest.mark.parametrize(("rated", "is_told"), [("500 t", False), ("2200 t", False), ("5000 t", True)])
def test_a_hook_and_its_falls(rated: str, is_told: bool) -> None:
    """One rope of 24 parts of 44 mm, 6x36 IWRC 1960: 0.356 · 44² · 1960 N = 1350.9 kN each (EN 12385-4)."""
    breaks = 24 * 0.356 * 44**2 * 1.960 / G
    assert breaks == pytest.approx(3305, rel=1e-3)
    said = (
        "hook_types.hook_500.rated_capacity: goliath.L may carry 5,000 t, and its 24 parts of hoist_44 break "
        "at 3,305 t; 3 times as much is usual at least, and a unit or digit has slipped"
    )
    assert told("goliath", hook_types__hook_500__rated_capacity=rated) == ([said] if is_told else [])


def test_one_hook_type_is_told_once() -> None:
    """Two hooks of one type say the same."""
    assert len(told("goliath", hook_types__hook_300__rated_capacity="3000 t")) == 1


def test_an_equalizer_and_its_rope() -> None:
    """Two parts at each of five moving sheaves; three equalizers of one type."""
    (said,) = told("goliath", **{"equalizer_types__EQ5-300__rated_capacity": "3300 t"})
    breaks = 2 * 5 * 0.356 * 46**2 * 1.960 / G
    assert f"the 10 parts of its rope break at {breaks:,.0f} t" in said
    assert said.startswith("equalizer_types.EQ5-300.rated_capacity: E1 may carry 3,300 t")


def test_a_spreader_and_its_lugs() -> None:
    """It hangs in two lugs of 40 t."""
    assert told("spreader_bar", spreaders__bar__rated_capacity="80 t") == []
    assert told("spreader_bar", spreaders__bar__rated_capacity="600 t") == [
        "spreaders.bar.rated_capacity: bar may carry 600 t, and all lugs above its middle bear 80 t; a unit "
        "or digit has slipped"
    ]


@pytest.mark.parametrize(("limit", "is_told"), [("35 t", False), ("70 t", False), ("350 t", True)])
def test_a_shackle_and_its_pin(limit: str, is_told: bool) -> None:
    """A pin of 51 mm is sheared in two places, F / (2 · π/4 d²)."""
    assert 350e3 * G / (2 * math.pi / 4 * 51**2) == pytest.approx(840, abs=1)
    said = (
        "shackles.wb35.working_load_limit: 350 t, its limit, shears its pin of 51 mm with 840 N/mm^2; about "
        "100 is usual, and a unit or digit has slipped"
    )
    assert told("revolving_crane", shackles__wb35__working_load_limit=limit) == ([said] if is_told else [])


#: Limit [t], pin, bow [mm] of the lightest, the heaviest and the widest of shackles that are made (makers'
#: tables: Green Pin P-6036 and P-6033, Crosby G-2140 and G-2160).
MADE = """
120,95,95
1500,290,280
7,22,41
1550,320,560
30,41.1,41.1
175,116,116
400,184,184
55,57.2,114
200,105,217
"""


def test_shackles_that_are_made() -> None:
    for limit, pin, bow in csv.reader(MADE.split()):
        changes = {
            "working_load_limit": f"{limit} t",
            "pin_diameter": f"{pin} mm",
            "bow_diameter": f"{min(float(bow), 500.0)} mm",
            "mass": "20 kg",
        }
        assert told("revolving_crane", shackles__spare=changes) == []


def test_a_bow_ten_times_as_wide() -> None:
    """A wide bow makes a bending factor of 1 of what bends the sling sharply."""
    (said,) = told("equalizer_yard", shackles__wb75__bow_diameter="394 mm")  # 120 mm in feet, 3.28 times
    assert "a bow of 394 mm beside a pin of 70 mm" in said


@pytest.mark.parametrize(("capacity", "is_told"), [("40 t", False), ("200 t", False), ("392.4 t", True)])
def test_a_lug_and_its_shackle(capacity: str, is_told: bool) -> None:
    """A shackle of 40 t is on it: 392.4 / 40 = 9.81, kN for t."""
    said = (
        "spreaders.bar.lugs.T2.capacity: lug bar.T2 bears 392.4 t, and what is shackled to it 40 t, 9.81 "
        "times less; a unit or digit has slipped"
    )
    assert told("spreader_bar", spreaders__bar__lugs__T2__capacity=capacity) == ([said] if is_told else [])


def test_a_type_of_lugs() -> None:
    """Four lugs of one type, each with a shackle of 75 t, say the same once."""
    (said,) = [one for one in told("off_a_barge", lug_types__PL50__capacity="500 t") if "lug" in one]
    assert said.startswith("lug_types.PL50.capacity: lug A bears 500 t, and what is shackled to it 75 t")


def test_lugs_that_are_alike() -> None:
    """Five lugs of 500 t with shackles of 75 t were five warnings: whoever wrote one so wrote all so."""
    lugs = {f"load__lugs__L{k}__capacity": "500 t" for k in range(1, 6)}
    assert told("equalizer", **lugs) == [
        "load.lugs.L1.capacity: lugs L1, L2, L3, L4 and L5 bear 500 t each, and what is shackled to each 75 "
        "t, 6.67 times less; a unit or digit has slipped"
    ]


def test_lugs_without_shackles() -> None:
    """Nothing is known of what goes round the plate then."""
    assert told("reeved_hoist", load__lugs__L1__capacity="1000 t") == []
