"""The gas of a compensator: its pull over the way of the rod, docs/concepts/compensator.md."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

__all__ = ["GasLaw"]

#: Chords of the curve over the law are above it by this share of the pull of the gas at most [1].
_CHORDS = 1e-4


@dataclass(frozen=True)
class GasLaw:
    """F = (F0 + P) (V / (V - x))^n - P, x the way of the rod out of its cylinder: (PC1).

    Attributes:
        rod_in: F0, the pull with the rod in [N].
        column: V, the volume of the gas with the rod in over the area of the piston [m].
        exponent: n [1].
        outside: P, what the air outside takes away from the pull of the gas [N].
    """

    rod_in: float
    column: float
    exponent: float
    outside: float = 0.0

    @classmethod
    def between(cls, rod_in: float, rod_out: float, stroke: float, exponent: float) -> GasLaw:
        """The law of two pulls [N] at the ends of a stroke [m]: (PC2)."""
        column = stroke / (1.0 - (rod_in / rod_out) ** (1.0 / exponent))
        return cls(rod_in, column, exponent)

    def pull(self, out: float) -> float:
        """Pull with the rod out by a way below the column [m], also a little less than nothing [N]."""
        gas = (self.rod_in + self.outside) * (self.column / (self.column - out)) ** self.exponent
        return float(gas - self.outside)

    def stiffness(self, out: float) -> float:
        """Its slope there [N/m]."""
        return self.exponent * (self.pull(out) + self.outside) / (self.column - out)

    def out(self, pull: float) -> float:
        """The way out at which it pulls so [m]; less than nothing under a pull of less than `rod_in` [N]."""
        share = (self.rod_in + self.outside) / (pull + self.outside)
        return float(self.column * (1.0 - share ** (1.0 / self.exponent)))

    def ways(self, first: float, last: float) -> list[float]:
        """Ways out from one to another, dense enough for chords between them [m].

        Of F + P = C u^-n over u = V - x a chord from u to r u is at most n (n + 1)/8 (ln r)^2 of it above,
        the higher powers of ln r left out: ways are such that u goes by one ratio.
        """
        ends = self.column - first, self.column - last
        step = math.sqrt(8.0 * _CHORDS / (self.exponent * (self.exponent + 1.0)))
        count = 1 + math.ceil(math.log(ends[0] / ends[1]) / step)
        return [self.column - float(left) for left in np.geomspace(*ends, count)]
