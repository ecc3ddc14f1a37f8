"""Added mass of a body that hangs in the air.

Added mass and damping of a body are constants, wherever its hull is. A subsea module of 180 t with 200 t of
added mass, a body of `mechanics` in four slings, bounced in its slings with 0.443 s while it still hung 1.5 m
above the water, in place of 0.305 s, and swung with 8.5 s in place of 7.2 s. Runs and statics said nothing.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from afloat import written
from gantline.scenario import load_scenario
from gantline.simulation import simulate
from gantline.statics import Statics

MASS, ADDED, EA, LENGTH = 180e3, 200e3, 300e6, 10.0
SAID = (
    "the hull of module is out of the water, first at 0.00 s: its added mass and water damping act there "
    "as in water, so that it swings and bounces otherwise than in air"
)


def hanging(folder: Path, height: float, **water: Any) -> Path:
    """A box of 6 m that hangs on one rope, its keel `height` above the water, which is at z = 0."""
    middle = height + 3.0
    body = {
        "at": ["0 m", "0 m", f"{middle} m"],
        "joint": {"type": "slider", "axis": [0, 0, 1]},
        "mass": f"{MASS} kg",
        "hull": {"box": ["6 m", "2 m", "6 m"], "keel": ["0 m", "0 m", "-3 m"]},
        **water,
    }
    route = [
        {"type": "end", "body": "world", "at": ["0 m", "0 m", f"{middle + LENGTH} m"]},
        {"type": "end", "body": "module"},
    ]
    return written(
        folder,
        {
            "format": 1,
            "lift": {"title": "A subsea module"},
            "duration": "1 s",
            "start": "rest",
            "ropes": {"line": {"axial_stiffness": f"{EA} N", "damping_time": "1 ms"}},
            "mechanics": {
                "bodies": {"module": body},
                "ropes": {"line": {"rope": "line", "length": f"{LENGTH} m", "route": route}},
            },
            "water": {"density": "1025 kg/m^3", "level": "0 m"},
        },
    )


OF_WATER = {"added_mass": {"heave": f"{ADDED} kg"}, "water_damping": {"heave": "10 kN s/m"}}


def told(warnings: list[str]) -> list[str]:
    return [one for one in warnings if "out of the water" in one]


def test_a_run_tells_of_added_mass_in_the_air(tmp_path: Path) -> None:
    assert told(simulate(hanging(tmp_path, 1.5, **OF_WATER)).attributes["warnings"]) == [SAID]


def test_statics_tells_of_it_with_the_motions_that_it_changes(tmp_path: Path) -> None:
    """The period is 2 pi sqrt((m + a) L / EA), 0.707 s; in air it would be 2 pi sqrt(m L / EA), 0.487 s."""
    statics = Statics(load_scenario(hanging(tmp_path, 1.5, **OF_WATER)))
    rest = statics.equilibrium()
    assert told(list(rest.recording.attributes["warnings"])) == [SAID]
    # The damped period is longer by half the square of the damping ratio, here 1e-4.
    (mode, *_) = statics.modes()
    assert mode.period == pytest.approx(2 * math.pi * math.sqrt((MASS + ADDED) * LENGTH / EA), rel=1e-3)


@pytest.mark.parametrize(
    ("height", "water"),
    [(-3.0, OF_WATER), (-20.0, OF_WATER), (1.5, {})],
    ids=["half_in", "deep", "a_hull_alone"],
)
def test_where_nothing_is_wrong_nothing_is_said(tmp_path: Path, height: float, water: dict[str, Any]) -> None:
    path = hanging(tmp_path, height, **water)
    assert not told(simulate(path).attributes["warnings"])
    assert not told(list(Statics(load_scenario(path)).equilibrium().recording.attributes["warnings"]))
