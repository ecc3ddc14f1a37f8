"""What slews of a crane into mechanics: its upper structure, and what its hook blocks turn with."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.plan.operations import slew_drive, turned_drive
from gantline.assembly.spatial import about_axis, inertia_list
from gantline.cad.mass_properties import point_inertia
from gantline.scenario.cranes.slewing import Slewing, turned_body, upper_body

__all__ = ["add_turned", "add_upper"]

_UP = (0.0, 0.0, 1.0)


def add_upper(
    parts: Parts,
    crane: str,
    parent: str,
    at: Sequence[float],
    lumps: Sequence[tuple[float, Sequence[float]]],
    slew: tuple[float, Slewing | None],
) -> None:
    """Add the upper structure: point masses that slew.

    Args:
        parts: The system.
        crane: Name of the crane.
        parent: Body that bears it.
        at: Where its axes begin, axes of that [m].
        lumps: Masses [kg] and their places in its axes [m].
        slew: Its direction at the start [rad], and what slews it, if anything does.
    """
    mass = math.fsum(lump for lump, _ in lumps)
    centre = np.zeros(3)
    if mass > 0.0:
        centre = np.sum([lump * np.asarray(place) for lump, place in lumps], axis=0) / mass
    inertia = np.sum([point_inertia(lump, np.asarray(place) - centre) for lump, place in lumps], axis=0)
    joint, turned = _turning(parts, slew_drive(upper_body(crane)), 0.0, slew)
    parts.add_body(
        upper_body(crane),
        joint,
        parent=parent,
        position=at,
        orientation=turned,
        mass=mass,
        centre_of_gravity=[float(part) for part in centre],
        inertia=inertia_list(inertia) if lumps else (0.0,) * 6,
    )


def add_turned(
    parts: Parts,
    crane: str,
    place: Sequence[float],
    heading: float,
    slew: tuple[float, Slewing | None],
) -> None:
    """Add what hook blocks are points under: it turns about the slewing axis as the crane is told to.

    Hook blocks turn with the boom in their falls. Points under this do, and are as free as under the world.

    Args:
        parts: The system.
        crane: Name of the crane.
        place: Of the slewing axis, world [m].
        heading: Direction from which the crane slews, from world x [rad].
        slew: Its direction at the start [rad], and what slews it, if anything does.
    """
    joint, turned = _turning(parts, turned_drive(upper_body(crane)), heading, slew)
    parts.add_body(turned_body(crane), joint, position=place, orientation=turned)


def _turning(
    parts: Parts, drive: str, heading: float, slew: tuple[float, Slewing | None]
) -> tuple[Json, Sequence[float]]:
    """A hinge that slews as its drive tells, or a fixed joint, and how what it bears is turned without it."""
    angle, slewing = slew
    if slewing is None:
        return {"type": "fixed"}, about_axis(_UP, heading + angle)
    parts.add_drive(drive)
    hinge = {"type": "hinge", "axis": list(_UP), "position": angle, "velocity": 0.0, "damping": 0.0}
    return hinge | {"friction": 0.0, "drive": drive}, about_axis(_UP, heading)
