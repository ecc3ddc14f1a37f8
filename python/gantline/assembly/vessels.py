"""Vessels as free bodies: axes at stern, keel and centre plane, x forward, y to port, z up."""

from __future__ import annotations

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import about_axis, quaternion_product, rotation_matrix
from gantline.scenario import Scenario
from gantline.scenario.vessel import Vessel
from gantline.scenario.water import Water

__all__ = ["add_vessels", "hull_shape"]


def add_vessels(parts: Parts, scenario: Scenario) -> None:
    """Add a free body for each vessel, with what it weighs by itself, where it is at the start."""
    level = (scenario.water or Water()).level
    for name, vessel in (scenario.vessels or {}).items():
        own = vessel.own_inertia
        parts.add_body(
            name,
            _start(vessel, level),
            mass=vessel.mass,
            centre_of_gravity=vessel.centre_of_gravity,
            inertia=(own.xx, own.yy, own.zz, own.xy, own.xz, own.yz),
        )


def _start(vessel: Vessel, level: float) -> Json:
    """The free joint: turned by its heading, then trimmed, then heeled about its own long axis.

    The water is `draft` from the keel, along the vessel's z at half length in the centre plane.
    """
    turned = quaternion_product(about_axis((0, 0, 1), vessel.heading), about_axis((0, -1, 0), vessel.trim))
    orientation = quaternion_product(turned, about_axis((1, 0, 0), vessel.heel))
    at_water = np.array([vessel.hull.bottom[0], 0.0, vessel.draft])
    height = level - float((rotation_matrix(orientation) @ at_water)[2])
    return {
        "type": "free",
        "position": [*vessel.position, height],
        "orientation": orientation,
        "velocity": [0.0, 0.0, 0.0],
        "angular_velocity": [0.0, 0.0, 0.0],
    }


def hull_shape(vessel: Vessel) -> Json:
    """The hull to draw and to touch, in the vessel's axes; see `gantline.assembly.shapes`."""
    (x, y, z), size = vessel.hull.bottom, vessel.hull.box
    return {"type": "box", "size": list(size), "centre": [x, y, z + size[2] / 2]}
