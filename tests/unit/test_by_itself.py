"""Vessels by themselves: inertia of all aboard, added mass about another point, stiffness by the water."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from afloat import BREADTH, DRAFT, LENGTH, MASS, barge, lift_of
from gantline.assembly.afloat.by_itself import about_point, mass_aboard, pumped_content, stiffness_by_water
from gantline.assembly.parts import Parts
from gantline.results.variable import FloatArray
from gantline.scenario import Scenario, parse_scenario
from gantline.scenario.afloat.vessel import Vessel
from gantline.scenario.afloat.water import BallastTank

G = 9.81
#: 20 × 10 m, 3 m deep: 512.5 t of sea water are 2.5 m of them; at a place that is nowhere in the middle.
BOX, BOTTOM = (20.0, 10.0, 3.0), (30.0, -4.0, 1.0)
TANK = {"box": [f"{side} m" for side in BOX], "bottom": [f"{at} m" for at in BOTTOM], "content": "512.5 t"}


def scenario(tanks: dict[str, Any], plan: list[dict[str, Any]] | None = None) -> tuple[Scenario, Vessel]:
    """A barge with tanks, whose hull weighs so much less."""
    filled = sum(1e3 * float(tank["content"].split()[0]) for tank in tanks.values())
    hull = {"hull": {"mass": f"{MASS - filled!r} kg", "at": [f"{LENGTH / 2} m", "0 m", "5 m"]}}
    given = lift_of(barge(masses=hull, tanks=tanks), duration="400 s", **({"plan": plan} if plan else {}))
    found = parse_scenario(json.dumps(given))
    assert found.vessels is not None
    return found, found.vessels["barge"]


def body(parent: str | None, at: FloatArray, turned: list[float], mass: float, centre: FloatArray) -> Any:
    """A body of a document with an inertia of its own, fixed to its parent."""
    return {
        "parent": parent,
        "placement": {"position": at.tolist(), "orientation": turned},
        "joint": {"type": "fixed"},
        "mass": mass,
        "centre_of_gravity": centre.tolist(),
        "inertia": [3.0 * mass, 4.0 * mass, 5.0 * mass, 0.3 * mass, -0.2 * mass, 0.1 * mass],
    }


def test_all_aboard_is_one_body() -> None:
    """About the world's origin masses, moments and inertias add up, of bodies and liquids.

    What stands aboard, and what is aboard of that, counts; what stands beside does not, and no empty frame.
    """
    rng = np.random.default_rng(5)
    parts = Parts()

    def add(name: str, parent: str | None, mass: float) -> None:
        turned = np.append(1.0, rng.normal(0.0, 0.5, 3))
        turned /= np.linalg.norm(turned)
        parts.bodies[name] = body(
            parent, rng.normal(0.0, 9.0, 3), turned.tolist(), mass, rng.normal(0.0, 2.0, 3)
        )

    for name, parent, mass in (
        ("vessel", None, 900.0),
        ("upper", "vessel", 80.0),
        ("frame", "upper", 0.0),
        ("hook", "frame", 7.0),
        ("load", None, 60.0),
        ("gear", "load", 5.0),
        ("buoy", None, 50.0),
    ):
        add(name, parent, mass)
    parts.bodies["frame"]["inertia"] = [0.0] * 6
    tank = BallastTank.model_construct(box=BOX, bottom=BOTTOM, content=100.0, density=1025.0)
    origin, turned = parts.pose("vessel")
    for aboard, standing in (("vessel upper hook", ()), ("vessel upper hook load gear", ("load",))):
        total, moment, inertia = 0.0, np.zeros(3), np.zeros((3, 3))

        def count(mass: float, at: FloatArray, own: FloatArray) -> None:
            nonlocal total, moment, inertia
            total, moment = total + mass, moment + mass * at
            inertia = inertia + own + mass * (at @ at * np.eye(3) - np.outer(at, at))

        for name in aboard.split():
            one = parts.bodies[name]
            place, orientation = parts.pose(name)
            xx, yy, zz, xy, xz, yz = one["inertia"]
            own = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
            at = place + orientation @ np.array(one["centre_of_gravity"])
            count(one["mass"], at, orientation @ own @ orientation.T)
        depth = 100.0 / (1025.0 * BOX[0] * BOX[1])
        x, y, z = BOX[0], BOX[1], depth
        liquid = 100.0 / 12 * np.diag([y * y + z * z, x * x + z * z, x * x + y * y])
        at = origin + turned @ (np.add(BOTTOM, (0.0, 0.0, depth / 2)))
        count(100.0, at, turned @ liquid @ turned.T)
        middle = moment / total
        about = inertia - total * (middle @ middle * np.eye(3) - np.outer(middle, middle))
        found = mass_aboard(parts, "vessel", [tank], standing)
        assert found[0] == pytest.approx(total, rel=1e-12)
        assert found[1] == pytest.approx(turned.T @ (middle - origin), abs=1e-9)
        assert found[2] == pytest.approx(turned.T @ about @ turned, abs=1e-8 * np.abs(about).max())


def test_added_mass_about_another_point_has_the_same_energy() -> None:
    """½ v·A v of any motion, told by the velocity of either point: v there is v here + ω × r."""
    rng = np.random.default_rng(7)
    root = rng.normal(size=(6, 6))
    matrix, at, centre = root @ root.T, rng.normal(size=3), rng.normal(size=3)
    about = about_point({"at": at.tolist(), "matrix": matrix.tolist()}, centre)
    for motion in rng.normal(size=(5, 6)):
        there = np.append(motion[:3] + np.cross(motion[3:], at - centre), motion[3:])
        assert motion @ about @ motion == pytest.approx(there @ matrix @ there, rel=1e-12)


def test_stiffness_of_a_box_with_a_slack_tank() -> None:
    """GM = T/2 + B²/12T - KG less b²/12 of the liquid's share of displacement; in pitch L in place of B.

    About a point aside of the middle of the waterplane turns lift that: its rise is z + y φ - x θ, and its
    stiffness times that is what pushes.
    """
    given, vessel = scenario(
        {"slack": TANK, "full": {**TANK, "bottom": ["70 m", "0 m", "1 m"], "content": "615 t"}}
    )
    ahead, aside, high = 3.0, 1.5, 6.0
    centre = np.array([LENGTH / 2 - ahead, -aside, high])
    found, heights = stiffness_by_water(given, "barge", vessel, centre)
    share = 512.5e3 / 2.5 / MASS  # of the plan of the tank: ρ l b/m
    roll = DRAFT / 2 + BREADTH**2 / (12 * DRAFT) - high - share * BOX[1] ** 2 / 12
    pitch = DRAFT / 2 + LENGTH**2 / (12 * DRAFT) - high - share * BOX[0] ** 2 / 12
    assert heights == pytest.approx({"roll": roll, "pitch": pitch})
    weight, plane = MASS * G, MASS * G / DRAFT
    rises = np.array([0.0, 0.0, 1.0, aside, -ahead, 0.0])
    expected = plane * np.outer(rises, rises) + np.diag([0.0, 0.0, 0.0, weight * roll, weight * pitch, 0.0])
    assert found == pytest.approx(expected, abs=1e-6 * weight)


def test_liquids_that_no_body_has() -> None:
    """Those of tanks that the plan pumps, as long as something is in them."""
    tanks = {
        name: {**TANK, "bottom": [f"{x} m", "0 m", "1 m"], "content": content}
        for name, x, content in (("from", 20, "400 t"), ("to", 45, "0 t"), ("left", 75, "400 t"))
    }
    pump = {"step": "pump", "pump": {"from": "barge.from", "to": "barge.to"}, "by": "50 t", "rate": "600 t/h"}
    given, vessel = scenario(tanks, [pump])
    assert pumped_content(given, "barge", vessel) == [(vessel.tanks or {})["from"]]
    given, vessel = scenario(tanks)
    assert pumped_content(given, "barge", vessel) == []
