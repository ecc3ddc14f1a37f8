"""Vessels as free bodies: axes at stern, keel and centre plane, x forward, y to port, z up."""

from __future__ import annotations

import numpy as np

from gantline.assembly.hulls import HullMesh, hull_mesh, hull_shape
from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import about_axis, quaternion_product, rotation_matrix
from gantline.scenario import Scenario
from gantline.scenario.vessel import Vessel
from gantline.scenario.water import Water

__all__ = ["add_vessels", "vessel_hull", "vessel_shape"]


def add_vessels(parts: Parts, scenario: Scenario) -> None:
    """Add a free body for each vessel, with what it weighs by itself, where it is at the start."""
    level = (scenario.water or Water()).level
    for name, vessel in (scenario.vessels or {}).items():
        own = vessel.own_inertia
        parts.add_body(
            name,
            _start(scenario, name, vessel, level),
            mass=vessel.mass,
            centre_of_gravity=vessel.centre_of_gravity,
            inertia=(own.xx, own.yy, own.zz, own.xy, own.xz, own.yz),
        )


def _start(scenario: Scenario, name: str, vessel: Vessel, level: float) -> Json:
    """The free joint: turned by its heading, then trimmed, then heeled about its own long axis.

    The water is `draft` from the keel, along the vessel's z at half length in the centre plane.
    """
    turned = quaternion_product(about_axis((0, 0, 1), vessel.heading), about_axis((0, -1, 0), vessel.trim))
    orientation = quaternion_product(turned, about_axis((1, 0, 0), vessel.heel))
    box = vessel_hull(scenario, name, vessel).box
    if vessel.draft >= box[1, 2]:
        sentence = f"{vessel.draft:g} m is no less than the depth of the hull, {box[1, 2]:g} m"
        raise scenario.error(("vessels", name, "draft"), f"{sentence}; a vessel floats with its deck dry")
    at_water = np.array([box[:, 0].mean(), 0.0, vessel.draft])
    height = level - float((rotation_matrix(orientation) @ at_water)[2])
    return {
        "type": "free",
        "position": [*vessel.position, height],
        "orientation": orientation,
        "velocity": [0.0, 0.0, 0.0],
        "angular_velocity": [0.0, 0.0, 0.0],
    }


def vessel_hull(scenario: Scenario, name: str, vessel: Vessel) -> HullMesh:
    """The hull of a vessel in its axes.

    Raises:
        ScenarioError: if its file cannot be read, or holds no hull.
    """
    hull = hull_mesh(scenario, name, vessel)
    assert hull is not None  # a vessel has one
    return hull


def vessel_shape(scenario: Scenario, name: str) -> Json:
    """The hull of a vessel to draw, in its axes: a box, or a light mesh with the corners to touch it with."""
    vessel = (scenario.vessels or {})[name]
    hull = vessel_hull(scenario, name, vessel)
    if vessel.hull.mesh is not None:
        return hull_shape(hull)
    box = hull.box
    return {"type": "box", "size": np.ptp(box, axis=0).tolist(), "centre": box.mean(axis=0).tolist()}
