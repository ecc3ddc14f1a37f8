"""Areas in wind and current that a load takes from its shape were pushed at its datum, below its middle.

A column of 20 m on one sling leaned twice as much as wind leans it, since its foot was pushed away.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from gantline.scenario.loads.cylinder import Cylinder
from gantline.scenario.loads.load import Load
from round_lift import round_lift, simulated

WEIGHT, PRESSURE = 200e3 * 9.81, 0.5 * 1.225 * 20.0**2


def leans(folder: Path, shape: dict[str, Any], **at: Any) -> tuple[float, float]:
    """Its tilt at rest in wind of 20 m/s along x, and how high its middle is over the hook's sling end."""
    given = round_lift(
        {"diameter": "5 m", "length": "20 m", "along": "z"},
        (0, 0, 10),
        load={
            "shape": shape,
            "position": ["0 m", "0 m", "5 m"],
            "lugs": {"a": {"at": ["0 m", "0 m", "20 m"]}},
            "wind_areas": {"x": {"coefficient": "0.7", "along": "x", **at}},
        },
        ground=None,
        wind={"speed": "20 m/s", "direction": "0 deg"},
        slings={"a": {"from": "hook", "to": "column.a", "length": "174.9 m", "rope": "sling"}},
        start="rest",
        duration="0.1 s",
    )
    recording = simulated(folder, given)
    return float(recording.column("load_tilt", "column")[0]), PRESSURE * 0.7 * 100.0


@pytest.mark.parametrize(
    "shape",
    [
        {"cylinder": {"diameter": "5 m", "length": "20 m", "along": "z"}},
        {"box": ["5 m", "5 m", "20 m"]},
    ],
)
def test_a_column_leans_as_plumb_as_its_sling(tmp_path: Path, shape: dict[str, Any]) -> None:
    """Pushed at its centre of gravity, tan φ = F/W, as its sling; at its foot, 20 m below the lug, twice
    that. As it leans the wind meets cos² of it: 1e-4 of the force.
    """
    tilt, force = leans(tmp_path, shape)
    assert math.tan(tilt) == pytest.approx(force / WEIGHT, rel=3e-4)
    tilt, force = leans(tmp_path, shape, at=["0 m", "0 m", "0 m"])
    assert math.tan(tilt) == pytest.approx(2.0 * force / WEIGHT, rel=1e-3)


def test_middle_of_a_cone_seen_from_its_side() -> None:
    """A trapezium of the breadths 6 m and 3 m, 9 m high: 9/3 · (6 + 2 · 3)/(6 + 3) = 4 m over its foot."""
    cone = Cylinder.model_validate({"diameter": "6 m", "end_diameter": "3 m", "length": "9 m", "along": "z"})
    assert cone.middle == pytest.approx((0.0, 0.0, 4.0), rel=1e-14)
    lying = Cylinder.model_validate({"diameter": "6 m", "end_diameter": "3 m", "length": "9 m"})
    assert lying.middle == pytest.approx((-0.5, 0.0, 3.0), rel=1e-14)


def test_an_area_that_says_how_large_it_is_is_pushed_at_the_datum() -> None:
    """As before: its place counts from there."""
    load = Load.model_validate(
        {
            "name": "box",
            "shape": {"box": ["5 m", "5 m", "20 m"]},
            "weight": {"calculated": "10 t"},
            "centre_of_gravity": {"at": ["0 m", "0 m", "10 m"]},
            "wind_areas": {
                "one": {"area": "9 m^2", "coefficient": "1", "along": "x"},
                "all": {"coefficient": "1", "along": "x"},
            },
        }
    )
    areas = load.areas_in("wind")
    assert areas["one"].at == (0.0, 0.0, 0.0)
    assert areas["all"].at == (0.0, 0.0, 10.0)
