"""What joints do to the body that they carry where a lift starts, by the `type` of the document."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from gantline.assembly.spatial import Array, about_axis, rotation_matrix, unit

__all__ = ["placed_at_start", "start_of", "translates"]

_Joint = dict[str, Any]
#: Translation [m] and rotation of the body's frame from that of the joint.
_Start = tuple[Array, Array]


def _still(_joint: _Joint) -> _Start:
    return np.zeros(3), np.eye(3)


def _turned(joint: _Joint) -> _Start:
    return np.zeros(3), rotation_matrix(about_axis(joint["axis"], joint["position"]))


def _along(joint: _Joint) -> _Start:
    return np.array(unit(joint["axis"])) * joint["position"], np.eye(3)


def _ball(joint: _Joint) -> _Start:
    return np.zeros(3), rotation_matrix(joint["orientation"])


def _point(joint: _Joint) -> _Start:
    return np.array(joint["position"], dtype=np.float64), np.eye(3)


def _free(joint: _Joint) -> _Start:
    return _point(joint)[0], _ball(joint)[1]


#: Every type of joint: where its body is at the start, and whether it has translations of its own.
_TYPES: dict[str, tuple[Callable[[_Joint], _Start], bool]] = {
    "fixed": (_still, False),
    "hinge": (_turned, False),
    "slider": (_along, True),
    "ball": (_ball, False),
    "point": (_point, True),
    "free": (_free, True),
    "flow": (_still, False),
    "content": (_still, False),
}


def start_of(joint: _Joint) -> _Start:
    """Where a joint has its body at the start.

    Args:
        joint: Of the document.

    Returns:
        Translation (3,) [m] and rotation matrix (3, 3) from the frame of the joint to that of the body.
    """
    return _TYPES[joint["type"]][0](joint)


def placed_at_start(bodies: Mapping[str, dict[str, Any]], name: str | None) -> _Start:
    """World position (3,) [m] and rotation matrix (3, 3) of a body frame at the start; None is the world.

    Args:
        bodies: Bodies of a document by name.
        name: Of the body.
    """
    if name is None:
        return np.zeros(3), np.eye(3)
    body = bodies[name]
    position, rotation = placed_at_start(bodies, body["parent"])
    position = position + rotation @ np.array(body["placement"]["position"])
    rotation = rotation @ rotation_matrix(body["placement"]["orientation"])
    moved, turned = start_of(body["joint"])
    return position + rotation @ moved, rotation @ turned


def translates(joint: _Joint) -> bool:
    """Whether a joint has translations of its own: a sheave on its body is a moving sheave."""
    return _TYPES[joint["type"]][1]
