"""Slack tanks: their free surfaces make a vessel less stable.

A liquid follows the heel of its tank: its centre moves by i tan(phi)/v, i the second moment of its surface
about the axis of the turn and v its volume. To small angles that is as if its weight hung i/v higher, and
the vessel's centre of gravity rises by sum(rho i)/displacement (free-surface correction).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

__all__ = ["Tank", "free_surface_correction"]


@dataclass(frozen=True)
class Tank:
    """A box-shaped tank that is slack.

    Attributes:
        length: along the vessel [m].
        breadth: across it [m].
        density: of what is in it [kg/m^3].
    """

    length: float
    breadth: float
    density: float = 1025.0

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
    """
    slack = list(tanks)
    transverse = sum(tank.density * tank.transverse for tank in slack) / mass
    return transverse, sum(tank.density * tank.longitudinal for tank in slack) / mass
