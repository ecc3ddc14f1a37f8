"""Slack tanks: their free surfaces make a vessel less stable.

A liquid follows the heel of its tank: its centre moves by i tan(phi)/v, i the second moment of its surface
about the axis of the turn and v its volume. To small angles that is as if its weight hung i/v higher, and
the vessel's centre of gravity rises by sum(rho i)/displacement (free-surface correction).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.arguments import listed, needed, number
from gantline.hydro.shapes import box_hull

__all__ = ["Liquid", "Tank", "free_surface_correction", "liquid_in_box"]

Array = npt.NDArray[np.float64]

#: Halvings of a height: to the rounding of it.
_HALVINGS = 60


@dataclass(frozen=True)
class Tank:
    """A box-shaped tank that is slack.

    Attributes:
        length: along the vessel [m].
        breadth: across it [m].
        density: of what is in it [kg/m^3].

    Raises:
        TypeError: if one of these is no number.
    """

    length: float
    breadth: float
    density: float = 1025.0

    def __post_init__(self) -> None:
        number(self.length, "length", "metres")
        number(self.breadth, "breadth", "metres")
        number(self.density, "density", "kilograms per cubic metre")

    @property
    def transverse(self) -> float:
        """Second moment of its surface for heel [m^4]."""
        return self.length * self.breadth**3 / 12

    @property
    def longitudinal(self) -> float:
        """Second moment of its surface for trim [m^4]."""
        return self.breadth * self.length**3 / 12


def free_surface_correction(tanks: Iterable[Tank], mass: float) -> tuple[float, float]:
    """What slack tanks take from GM, transverse and longitudinal [m].

    Args:
        tanks: those that are slack.
        mass: displacement of the vessel, what is in the tanks included [kg].

    Raises:
        TypeError: if it is no number, or these are no tanks.
    """
    slack = listed(tanks, "a list of tanks", "[gantline.hydro.Tank(20.0, 10.0)] has one")
    for one in slack:
        needed(one, Tank, "a tank", "gantline.hydro.Tank(20.0, 10.0) has a surface of 20 m by 10 m")
    number(mass, "mass", "kilograms")
    transverse = sum(tank.density * tank.transverse for tank in slack) / mass
    return transverse, sum(tank.density * tank.longitudinal for tank in slack) / mass


@dataclass(frozen=True)
class Liquid:
    """A liquid in a box at rest.

    Attributes:
        centre: Its centre from the middle of the bottom, axes of the box (3,) [m].
        spread: Second moments of its surface about its own middle, int (r - r0)(r - r0)^T dA, the same axes
            (3, 3) [m^4].
        area: Of its surface [m^2].
        middle: Of its surface, from the middle of the bottom, the same axes (3,) [m].
    """

    centre: Array
    spread: Array
    area: float
    middle: Array


def liquid_in_box(size: Sequence[float], up: npt.ArrayLike, volume: float) -> Liquid:
    """Where a liquid lies in a box that leans.

    Args:
        size: Length, breadth and depth of the box [m].
        up: The way up in its axes, a unit vector (3,).
        volume: Of the liquid, above zero and less than the box has [m^3].
    """
    hull, way = box_hull(size), np.asarray(up, dtype=float)
    heights = hull.mesh[0] @ way
    low, high = float(heights.min()), float(heights.max())
    for _ in range(_HALVINGS):
        level = 0.5 * (low + high)
        below = hull.below(way, -level)
        low, high = (level, high) if below["volume"] < volume else (low, level)
    middle = np.array(below["area_moment"]) / below["area"]
    spread = np.array(below["area_second"]) - below["area"] * np.outer(middle, middle)
    to_middle = np.array([size[0] / 2.0, 0.0, 0.0])
    centre = np.array(below["moment"]) / below["volume"] - to_middle
    return Liquid(centre, spread, float(below["area"]), middle - to_middle)
