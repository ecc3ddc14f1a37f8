"""A barge of 4 m draft in a basin that was written 1.5 m deep for 15 m.

Nothing holds a hull off the ground in a simulation. The barge floated metres deep in the floor of its basin,
or within the quay, and the lift was GO without a word. So it was in water of a depth of 3 m.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from afloat import BREADTH, DRAFT, barge, lift_of, written
from gantline import simulate

HALF = BREADTH / 2


def warnings(folder: Path, floor: float, side: float = 20.0, **changes: Any) -> list[str]:
    """Of a barge from x = 0 to 100 m in a basin from x = -10 to 110 m and `side` to either side."""
    basin = {"type": "dock", "x": ["-10 m", "110 m"], "y": [f"{-side} m", f"{side} m"], "floor": f"{floor} m"}
    given = {"ground": {"level": "3.5 m"}, "structures": {"basin": basin}, "duration": "0.1 s", **changes}
    run = simulate(written(folder, lift_of(barge(), **given)))
    return [one for one in run.attributes["warnings"] if "in the ground" in one]


@pytest.mark.parametrize("floor", [-1.5, -3.9])
def test_a_keel_below_the_floor_is_told(tmp_path: Path, floor: float) -> None:
    """By draft and depth: 4 m less than 1.5 m is 2.5 m."""
    (found,) = warnings(tmp_path, floor)
    assert found.startswith(f"barge is {DRAFT + floor:.2f} m in the ground at ")
    assert found.endswith("see position, draft and the floor of its dock")


def test_a_side_within_the_quay_is_told(tmp_path: Path) -> None:
    """14 m of water to either side of a barge with 15 m: its bilge is 4 + 3.5 m below the top of the quay."""
    (found,) = warnings(tmp_path, -15.0, side=HALF - 1.0)
    assert found.startswith(f"barge is {DRAFT + 3.5:.2f} m in the ground at ")
    assert found.endswith("see position, mooring lines, fenders and the edges of its dock")


@pytest.mark.parametrize("floor", [-4.1, -15.0])
def test_water_below_the_keel_is_not(tmp_path: Path, floor: float) -> None:
    assert warnings(tmp_path, floor) == []


def test_ground_that_has_no_dock_says_nothing_of_water(tmp_path: Path) -> None:
    """Ground above the water and no dock in it: where the vessel floats is not said."""
    given = lift_of(barge(), duration="0.1 s", ground={"level": "0 m"})
    run = simulate(written(tmp_path, given))
    assert not [one for one in run.attributes["warnings"] if "in the ground" in one]


@pytest.mark.parametrize(("depth", "level"), [(3.0, 0.0), (3.9, 2.0), (4.1, 2.0)])
def test_water_that_is_not_deep_enough(tmp_path: Path, depth: float, level: float) -> None:
    """By draft and depth, wherever the water stands."""
    water = {"density": "1025 kg/m^3", "level": f"{level} m", "depth": f"{depth} m"}
    run = simulate(written(tmp_path, lift_of(barge(), duration="0.1 s", water=water)))
    found = [one for one in run.attributes["warnings"] if "in the ground" in one]
    if depth > DRAFT:
        assert not found
        return
    assert found == [
        f"barge is {DRAFT - depth:.2f} m in the ground at 0.00 s, which does not hold its hull here, as it "
        "would; see its draft and the 'depth' of the 'water'"
    ]
