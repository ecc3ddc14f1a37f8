"""How wind grows with height over water and land."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

__all__ = ["TERRAINS", "WindProfile"]

#: Roughness and lowest height of a profile [m] over the terrain categories 0 to IV of EN 1991-1-4, table 4.1.
TERRAINS = {
    "sea": (0.003, 1.0),
    "flat": (0.01, 1.0),
    "fields": (0.05, 2.0),
    "suburbs": (0.3, 5.0),
    "town": (1.0, 10.0),
}
#: Lowest height where only roughness or exponent is said [m], and so many times the roughness [1].
_LOWEST, _OVER_ROUGHNESS = 1.0, 10.0


@dataclass(frozen=True)
class WindProfile:
    """Speed of the wind over that at the height where it was measured, by (WC9).

    Attributes:
        level: z from which heights count [m].
        height: at which the speed was measured [m].
        lowest: below this height it blows as there [m].
        roughness: h₀ of the logarithm [m]; None where a power is given.
        exponent: α of the power; None where a roughness is given.
    """

    level: float
    height: float
    lowest: float
    roughness: float | None = None
    exponent: float | None = None

    @classmethod
    def over(cls, roughness: float, level: float, height: float) -> WindProfile:
        """A logarithm over a roughness [m]."""
        return cls(level, height, max(_LOWEST, _OVER_ROUGHNESS * roughness), roughness=roughness)

    @classmethod
    def by_power(cls, exponent: float, level: float, height: float) -> WindProfile:
        """A power of the height."""
        return cls(level, height, _LOWEST, exponent=exponent)

    @classmethod
    def over_terrain(cls, terrain: str, level: float, height: float) -> WindProfile:
        """A logarithm over one of :data:`TERRAINS`."""
        roughness, lowest = TERRAINS[terrain]
        return cls(level, height, lowest, roughness=roughness)

    @property
    def in_words(self) -> str:
        """By what it grows."""
        if self.roughness is None:
            return f"by the power {self.exponent:g} of height"
        rough = f"{self.roughness:g} m" if self.roughness >= 1.0 else f"{1000 * self.roughness:g} mm"
        return f"over a roughness of {rough}"

    def share(self, z: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """Shares s at heights z in the world [m]; shape as z."""
        height = np.maximum(np.asarray(z, dtype=np.float64) - self.level, self.lowest)
        if self.roughness is None:
            return np.asarray((height / self.height) ** (self.exponent or 0.0))
        return np.asarray(np.log(height / self.roughness) / np.log(self.height / self.roughness))
