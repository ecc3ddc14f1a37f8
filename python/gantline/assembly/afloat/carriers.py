"""Vessels whose motion in waves is known beforehand: six drives that the sea moves, and nothing else.

The point that this motion is of is carried along the level axes of the vessel's heading, then turned by yaw,
pitch and roll, in this order. What the lift file says of heel and trim comes on top.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import about_axis, quaternion_product, rotation_matrix
from gantline.hydro.database import AXES
from gantline.scenario.afloat.vessel import Vessel

__all__ = ["add_carried_vessel", "carried_motion", "carrier", "wave_drive"]

Complex = npt.NDArray[np.complex128]

#: Joints in the order in which they carry, by their axes.
_JOINTS = {
    "surge": ("slider", (1.0, 0.0, 0.0)),
    "sway": ("slider", (0.0, 1.0, 0.0)),
    "heave": ("slider", (0.0, 0.0, 1.0)),
    "yaw": ("hinge", (0.0, 0.0, 1.0)),
    "pitch": ("hinge", (0.0, 1.0, 0.0)),
    "roll": ("hinge", (1.0, 0.0, 0.0)),
}


def carrier(vessel: str, axis: str) -> str:
    """Name of the body that carries one motion of a vessel."""
    return f"{vessel}/{axis}"


def wave_drive(vessel: str, axis: str) -> str:
    """Name of the drive of one motion of a vessel."""
    return f"{vessel}.{axis}"


def carried_motion(document: Json, vessel: str) -> Complex:
    """Surge to yaw of a carried vessel by each wave of the sea, over exp -iωt, shape (n, 6) [m or rad].

    Args:
        document: what has been assembled of a lift with waves.
        vessel: its name.
    """
    drives = {drive["name"]: drive for drive in document["drives"]}
    columns = [drives[wave_drive(vessel, axis)]["waves"]["components"] for axis in AXES]
    return np.array(
        [[wave["amplitude"] * np.exp(1j * wave["phase"]) for wave in column] for column in columns]
    ).T


def add_carried_vessel(parts: Parts, name: str, vessel: Vessel, start: Json) -> None:
    """Add a vessel that six drives carry at the point that its RAOs are of; its weight would change nothing.

    Args:
        parts: the lift so far.
        name: of the vessel.
        vessel: it.
        start: where a free body would be at the start: `position`, `orientation`.
    """
    motion = vessel.wave_motion
    assert motion is not None
    turned = rotation_matrix(start["orientation"])
    at = np.array(motion.at)
    place = {"position": np.array(start["position"]) + turned @ at}
    place |= {"orientation": about_axis((0.0, 0.0, 1.0), vessel.heading)}
    parent = None
    for axis, (kind, way) in _JOINTS.items():
        parts.add_drive(wave_drive(name, axis))
        joint = {"type": kind, "axis": list(way), "position": 0.0, "velocity": 0.0, "damping": 0.0}
        joint |= {"friction": 0.0, "drive": wave_drive(name, axis)}
        parts.add_body(carrier(name, axis), joint, parent=parent, **place)
        parent, place = carrier(name, axis), {}
    back = about_axis((0.0, 0.0, 1.0), -vessel.heading)
    leans = quaternion_product(back, start["orientation"])
    aside = -(rotation_matrix(leans) @ at)
    place = {"position": aside, "orientation": leans, "centre_of_gravity": vessel.centre_of_gravity}
    parts.add_body(name, {"type": "fixed"}, parent=parent, **place)
