"""`orientation` of a body turns the axes in which its joint has its axis, place and velocity.

The reference said of `axis` that it is in the parent's axes, of `position` and `velocity` nothing of axes:
a slider along x, on a joint turned by 90° about z, goes along the parent's y.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import gantline

SCHEMA = Path(__file__).resolve().parents[2] / "schema" / "lift.schema.json"
TURNED = """
format: 1
lift: {title: A turned joint}
duration: 20 ms
mechanics:
  bodies:
    base: {joint: {type: fixed}, orientation: {about: [0, 1, 0], angle: 90 deg}}
    part:
      parent: base
      orientation: {about: [0, 0, 1], angle: 90 deg}
      joint: {JOINT}
      mass: 10 kg
      inertia: {xx: 1 kg m^2, yy: 1 kg m^2, zz: 1 kg m^2}
"""
#: About y by 90° and about the new z by 90°: x of the joint is y of the world, y is z, z is x.
WORLD = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])


@pytest.mark.parametrize(
    ("joint", "place", "velocity", "turning"),
    [
        ("type: slider, axis: [1, 0, 0], position: 2 m, velocity: 1 m/s", (2, 0, 0), (1, 0, 0), (0, 0, 0)),
        ("type: hinge, axis: [0, 1, 0], velocity: 1 rad/s", (0, 0, 0), (0, 0, 0), (0, 1, 0)),
        (
            "type: point, position: [1 m, 2 m, 3 m], velocity: [3 m/s, 2 m/s, 1 m/s]",
            (1, 2, 3),
            (3, 2, 1),
            (0, 0, 0),
        ),
        (
            "type: free, position: [1 m, 2 m, 3 m], velocity: [3 m/s, 2 m/s, 1 m/s]",
            (1, 2, 3),
            (3, 2, 1),
            (0, 0, 0),
        ),
    ],
    ids=["slider", "hinge", "point", "free"],
)
def test_in_the_axes_of_the_joint(
    joint: str, place: tuple[float, ...], velocity: tuple[float, ...], turning: tuple[float, ...]
) -> None:
    """Both turns one after the other, as above."""
    run = gantline.simulate(gantline.parse_scenario(TURNED.replace("JOINT", joint)))
    wanted = {"body_position": place, "body_velocity": velocity, "body_angular_velocity": turning}
    for column, own in wanted.items():
        assert run.column(column, "part")[0] == pytest.approx(WORLD @ own, abs=1e-12)


def test_the_reference_says_so() -> None:
    """Of every axis, place and velocity of a joint of `mechanics`, in the schema that editors show."""
    joints = json.loads(SCHEMA.read_text(encoding="utf-8"))["$defs"]
    for name, keys in {
        "HingeJoint": ["axis"],
        "Slider": ["axis"],
        "Point": ["position"],
        "Free": ["position"],
    }.items():
        for key in keys:
            assert "turned by the body's 'orientation'" in joints[name]["properties"][key]["description"]
