"""Two tanks in one place, one copied from the other, held water and free surfaces twice, in order."""

from __future__ import annotations

from pathlib import Path

import pytest

from afloat import barge, lift_of, written
from gantline.assembly import assemble
from gantline.scenario import load_scenario


@pytest.mark.parametrize(
    ("x", "shared"),
    [
        (30.0, 1000.0),  # the same place: 20 × 10 × 5 m
        (35.0, 750.0),  # 5 m further ahead: 15 × 10 × 5 m
        (50.0, 0.0),  # end to end
    ],
)
def test_tanks_in_one_place_are_told(tmp_path: Path, x: float, shared: float) -> None:
    size = {"box": ["20 m", "10 m", "5 m"], "content": "10 t"}
    tanks = {
        "fore": size | {"bottom": ["30 m", "0 m", "0.5 m"]},
        "aft": size | {"bottom": [f"{x} m", "0 m", "0.5 m"]},
    }
    found = assemble(load_scenario(written(tmp_path, lift_of(barge(tanks=tanks))))).warnings
    right = "'bottom' is the middle of a tank's bottom"
    said = f"tanks fore and aft of barge are in one place, {shared:.0f} m^3 of them: {right}"
    assert list(found) == ([said] if shared else [])
