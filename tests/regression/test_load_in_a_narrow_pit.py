"""A load that swung in a pit with walls on all four sides went through one of them.

A pair of shapes has eight places at which it touches. Walls nearer than 0.2 m had them all, and kept them: of
a generator with 150 mm on every side, 16 corners over four walls, eight had none, and a side that was reached
with no place went 96 mm into the wall, without any force, until a place came free and threw it out with a
tilt of 2.5 deg. Places that do not press give way to what is nearer now.
"""

from __future__ import annotations

from functools import cache
from json import dumps
from typing import Any

import numpy as np
import pytest

from gantline import Simulation
from gantline.results import Recording
from gantline.scenario import parse_scenario
from mechanics import G

MASS, LENGTH = 20e3, 25.0  # kg; from hook to lug [m]
HALF = (6.0, 2.0)  # half the length and the breadth of the load [m]
SPEED, DENSITY, AREA, COEFFICIENT = 12.0, 1.225, 12.0 * 4.0, 1.0
#: Level pull of the wind, (WC1) square to the side [N].
WIND = 0.5 * DENSITY * SPEED**2 * AREA * COEFFICIENT
STIFFNESS = 50e6  # N/m
CENTRE = ["0 m", "0 m", "2 m"]
HOIST = {"speed": "1 m/min", "acceleration": "0.1 m/s^2"}


def lift(along: float, across: float) -> dict[str, Any]:
    """A box on one rope from a hook, over its middle, in a pit with so much clear on its sides [m]."""
    x, y = (half + clear for half, clear in zip(HALF, (along, across), strict=True))
    return {
        "format": 1,
        "lift": {"title": "A box in a pit"},
        "duration": "60 s",
        "wind": {"speed": f"{SPEED} m/s", "direction": "90 deg"},
        "ground": {"level": "0 m", "stiffness": f"{STIFFNESS} N/m", "damping": "1 MN s/m"},
        "structures": {
            "pit": {"type": "dock", "x": [f"{-x} m", f"{x} m"], "y": [f"{-y} m", f"{y} m"], "floor": "-8 m"}
        },
        "ropes": {"sling": {"axial_stiffness": "100 MN", "mass": "none", "damping_time": "20 ms"}},
        "load": {
            "name": "box",
            "shape": {"box": ["12 m", "4 m", "4 m"]},
            "position": ["0 m", "0 m", "-7 m"],
            "weight": {"calculated": f"{MASS} kg"},
            "centre_of_gravity": {"at": CENTRE},
            "lugs": {"middle": {"at": CENTRE}},
            "wind_areas": {
                "side": {"area": f"{AREA} m^2", "coefficient": COEFFICIENT, "along": "y", "at": CENTRE}
            },
        },
        "cranes": {
            "hook": {"type": "fixed_hook", "at": ["0 m", "0 m", f"{-5.0 + LENGTH} m"], "hoist": HOIST}
        },
        "slings": {"S": {"from": "hook", "to": "box.middle", "length": f"{LENGTH} m"}},
        "sling_defaults": {"rope": "sling"},
        "plan": [{"step": "hang", "hold": "until_end"}],
        "watch": [{"between": ["box", "pit.walls"], "smallest": "0 m"}],
        "start": "as_given",
        "simulation": {"sample_interval": "0.05 s"},
    }


@cache
def recorded(along: float, across: float) -> Recording:
    return Simulation(parse_scenario(dumps(lift(along, across)))).run()


@pytest.mark.parametrize("along", [0.1, 0.15, 0.19])
def test_no_wall_lets_it_through(along: float) -> None:
    """The wind blows it onto a wall 0.15 m away, while two others are near all the time.

    By hand it would swing to twice L W/(m g) = 1.08 m if nothing were in its way.
    """
    swung = 2.0 * LENGTH * WIND / (MASS * G)
    assert swung == pytest.approx(1.08, abs=0.01)
    recording = recorded(along, 0.15)
    distance = recording.column("clearance", "box - pit.walls")
    assert distance.min() < 1e-3  # it is there
    # The wind has worked over 0.15 m, m v^2/2 = W s, and one corner alone may have to stop it: m v^2 = k d^2.
    assert distance.min() > -np.sqrt(2.0 * WIND * 0.15 / STIFFNESS)


def test_the_wall_bears_what_the_sling_does_not() -> None:
    """At rest it bears the wind less what the sling, out of plumb by the way to the wall, pulls back."""
    recording = recorded(0.1, 0.15)
    names = [name for name in recording.coordinates["contact"] if name.startswith("box.ground/")]
    last = recording.time > 50.0
    force = sum(recording.column("contact_force", name)[last].mean() for name in names)
    back = MASS * G * 0.15 / np.sqrt(LENGTH**2 - 0.15**2)
    assert force == pytest.approx(WIND - back, rel=2e-3)
