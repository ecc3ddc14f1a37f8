"""Structures that are turned about their middle, and round ones: distances, and what they bear, by hand."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.scenario import ScenarioError
from gantline.scenario.loads.structures import BoxStructure, CylinderStructure
from hull_lift import HULL, G, lift, simulated
from of_recording import checks_of

#: The hull section lies with its sides at x = -13.5 m and y = 11.5 m, its centre of gravity at x = -37 m.
SIDE_X, SIDE_Y, CENTRE = -13.5, 11.5, -37.0
WALL = {"type": "box", "x": ["0 m", "2 m"], "y": ["-20 m", "20 m"], "z": ["0 m", "20 m"], "heading": "30 deg"}


def tower(x: float, y: float, diameter: float = 4.0, z: tuple[float, float] = (0.0, 30.0)) -> dict[str, Any]:
    place = {"at": [f"{x} m", f"{y} m"], "diameter": f"{diameter} m"}
    return {"type": "cylinder", **place, "z": [f"{one} m" for one in z]}


def wall_apart() -> float:
    """From the corner of the hull to the near face of the wall, along its normal [m]."""
    normal = math.cos(math.radians(30.0)), math.sin(math.radians(30.0))
    return (normal[0] * 1.0 - 1.0) - (normal[0] * SIDE_X + normal[1] * SIDE_Y)


@pytest.mark.parametrize(
    ("thing", "apart", "close"),
    [
        (WALL, wall_apart(), 1e-9),
        (tower(0.0, 5.0), -SIDE_X - 2.0, 1e-9),  # a side of what stands for it faces the hull
        (tower(0.0, 20.0), math.hypot(SIDE_X, 20.0 - SIDE_Y) - 2.0, 2.0 * (1 / math.cos(math.pi / 32) - 1)),
    ],
    ids=["turned", "beside_a_side", "beside_a_corner"],
)
def test_distances(thing: dict[str, Any], apart: float, close: float, tmp_path: Path) -> None:
    """From a corner or a side to a face or an axis, less its radius; a cylinder has 32 sides about it, whose
    corners are r (1/cos(pi/32) - 1) outside of it.
    """
    watch = [{"between": ["hull", "thing"], "smallest": "1 m"}]
    done = simulated(tmp_path, lift(structures={"thing": thing}, watch=watch, duration="0.1 s"))
    found = done.metrics()["smallest_clearance.hull - thing"]
    # The hull rests on keel blocks that give by 2 mm under its heavier end: its top leans out by 0.3 mm.
    assert apart - close - 3e-4 < found < apart + 3e-4


@pytest.mark.parametrize("angle", [90.0, 30.0])
def test_a_load_stands_on_a_turned_box(angle: float, tmp_path: Path) -> None:
    """Its four corners, about the middle at x = -36 m, share as springs: W (1/4 + d S⁻¹ r), S = Σ r rᵀ."""
    load = {**HULL["load"], "position": ["-35 m", "0 m", "3 m"]}
    del load["stands_on"]
    table = {"type": "box", "x": ["-46 m", "-26 m"], "y": ["-5 m", "5 m"], "z": ["0 m", "3 m"]}
    table = table | {"heading": f"{angle} deg"}
    given = lift(supports=None, load=load, slings=None, plan=[], structures={"table": table}, duration="20 s")
    done = simulated(tmp_path, given)
    turn = math.radians(angle)
    axes = np.array([[math.cos(turn), math.sin(turn)], [-math.sin(turn), math.cos(turn)]])
    corners = np.array([[x, y] for x in (-10, 10) for y in (-5, 5)]) @ axes
    off = np.array([CENTRE + 36.0, 0.0])
    shares = 0.25 + corners @ np.linalg.solve(corners.T @ corners, off)
    names = [name for name in done.coordinates["contact"] if name.startswith("hull.table/")]
    borne = sorted(float(done.column("contact_force", name)[-1]) for name in names)[-4:]
    # Sharper than the tilt of the load, 1e-4 rad, by which corners come to lie elsewhere under it.
    assert borne == pytest.approx(sorted(350e3 * G * shares), rel=1e-3)


def test_a_load_stands_on_a_cylinder(tmp_path: Path) -> None:
    """All of its weight, level: the middle of the top is under its centre of gravity."""
    load = {**HULL["load"], "position": ["-35 m", "0 m", "3 m"]}
    del load["stands_on"]
    top = {"top": tower(CENTRE, 0.0, 8.0, (0.0, 3.0))}
    given = lift(supports=None, load=load, slings=None, plan=[], structures=top, duration="20 s")
    done = simulated(tmp_path, given)
    names = [name for name in done.coordinates["contact"] if name.startswith("hull.top/")]
    borne = sum(float(done.column("contact_force", name)[-1]) for name in names)
    assert borne == pytest.approx(350e3 * G, rel=1e-6)
    assert done.metrics()["peak_load_tilt"] < 1e-3


@pytest.mark.parametrize(
    ("thing", "meets"),
    [
        (tower(CENTRE, 0.0, 2.0, (30.0, 50.0)), True),
        # Beside it along the diagonal: the box about the tower holds it, the tower does not.
        (tower(CENTRE + 3.0, 3.0, 8.0, (30.0, 50.0)), False),
        ({**WALL, "x": ["-38 m", "-36 m"], "z": ["30 m", "50 m"]}, True),
        # Turned by 45 deg, 4.2 m off the hook, which the box about it holds.
        ({**WALL, "x": ["-34.25 m", "-33.75 m"], "y": ["-13 m", "7 m"], "z": ["30 m", "50 m"],
          "heading": "-45 deg"}, False),
    ],
    ids=["tower", "beside_the_tower", "wall", "beside_the_wall"],
)  # fmt: skip
def test_hooks_in_what_is_turned_or_round(thing: dict[str, Any], meets: bool, tmp_path: Path) -> None:
    """`no_overlap` names what a hook is in, and not what is only near it."""
    done = simulated(tmp_path, lift(structures={"thing": thing}, duration="0.1 s"))
    found = {one.element for one in checks_of(done, "no_overlap") if one.remark and "thing" in one.remark}
    assert bool(found) == meets


def test_how_deep_a_place_lies() -> None:
    """Below zero outside; from the nearest side inside."""
    wall = BoxStructure.model_validate({**WALL, "heading": "90 deg"})
    assert wall.depth((11.0, 0.5, 10.0)) == pytest.approx(0.5)
    assert wall.depth((11.0, 3.0, 10.0)) == pytest.approx(-2.0)
    column = CylinderStructure.model_validate(tower(1.0, 1.0))
    assert column.depth((2.0, 1.0, 29.5)) == pytest.approx(0.5)
    assert column.depth((4.0, 5.0, 10.0)) == pytest.approx(-3.0)


def test_a_tower_is_a_cylinder(tmp_path: Path) -> None:
    """Words of a yard for what is round and upright."""
    with pytest.raises(ScenarioError, match="what is round and upright is 'type: cylinder'"):
        simulated(tmp_path, lift(structures={"thing": {"type": "tower"}}))
