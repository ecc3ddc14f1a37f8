"""Seas of a grid, whatever is known of each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Generic, Protocol, TypeVar

__all__ = ["SeaGrid"]


class _Sea(Protocol):
    @property
    def height(self) -> float:
        """[m]."""

    @property
    def period(self) -> float:
        """[s]."""

    @property
    def direction(self) -> float:
        """[rad]."""


_S = TypeVar("_S", bound=_Sea)


class SeaGrid(Generic[_S]):
    """Seas by direction, period and height, the lowest first.

    Attributes:
        seas: All of them.
    """

    seas: Sequence[_S]

    @property
    def directions(self) -> tuple[float, ...]:
        """Directions of the grid [rad]."""
        return tuple(dict.fromkeys(sea.direction for sea in self.seas))

    @property
    def periods(self) -> tuple[float, ...]:
        """Periods of the grid [s]."""
        return tuple(dict.fromkeys(sea.period for sea in self.seas))

    @property
    def heights(self) -> tuple[float, ...]:
        """Heights of the grid, the smallest first [m]."""
        return tuple(dict.fromkeys(sea.height for sea in self.seas))

    def of(self, direction: float, period: float) -> list[_S]:
        """Seas of a direction [rad] and a period [s] of the grid, the lowest first.

        Raises:
            KeyError: If there are none.
        """
        found = [sea for sea in self.seas if (sea.direction, sea.period) == (direction, period)]
        if not found:
            raise KeyError(
                f"there is no sea with a direction of {direction!r} rad and a period of {period!r} s"
            )
        return found
