"""Current areas that hang in the air.

A load that is to be lowered into water has `current_areas`; while it hangs above, water resisted its swing,
800 times as much as air does, and its falls came less out of plumb than they would. Nothing was said. Areas
are pushed wherever they are, as their page says; a run tells of those that come out of the water.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from afloat import LENGTH, barge, lift_of, written
from gantline.results.recording import Recording
from gantline.simulation import simulate


def told(run: Recording) -> list[str]:
    return [one for one in run.attributes["warnings"] if "above the water" in one]


def hanging(folder: Path, height: float, **changes: Any) -> Recording:
    """A body of `mechanics`, its area `height` above its centre of gravity, which is at z = 0."""
    area = {"area": "10 m^2", "coefficient": "1", "along": "x", "at": ["0 m", "0 m", f"{height} m"]}
    body = {"joint": {"type": "point"}, "mass": "20 t", "current_areas": {"side": area}, **changes}
    path = written(
        folder,
        {
            "format": 1,
            "lift": {"title": "A weight"},
            "duration": "1 s",
            "start": "as_given",
            "mechanics": {"bodies": {"weight": body}},
            "water": {"density": "1025 kg/m^3", "level": "-2 m"},
        },
    )
    return simulate(path)


def test_an_area_above_the_water_is_told(tmp_path: Path) -> None:
    """It falls freely from 2 + 1.5 m above the water: at the start it is highest."""
    assert told(hanging(tmp_path, 1.5)) == [
        "the current area side of weight is up to 3.50 m above the water, first at 0.00 s: it resists and is "
        "pushed there as in water, which damps motion as air does not"
    ]


def test_an_area_in_the_water_is_not(tmp_path: Path) -> None:
    assert not told(hanging(tmp_path, -2.5))


@pytest.mark.parametrize(("height", "is_told"), [(3.9, False), (4.2, True)])
def test_areas_of_a_vessel(tmp_path: Path, height: float, is_told: bool) -> None:
    """4 m of draft; places count from its stern and keel, motions from its centre of gravity."""
    at = [f"{LENGTH / 2} m", "0 m", f"{height} m"]
    areas = {"side": {"area": "100 m^2", "coefficient": "1", "along": "y", "at": at}}
    run = simulate(written(tmp_path, lift_of(barge(current_areas=areas), start="as_given")))
    assert bool(told(run)) == is_told
