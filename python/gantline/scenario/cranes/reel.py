"""How far a hook goes whose drum winds its rope up in layers.

Its drive counts what it would rise on the first layer; docs/concepts/winch.md has the equations.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

__all__ = ["Reel"]

#: Part of a turn in which rope climbs from one layer onto the next.
_CLIMB = 0.5
#: Steps of Newton's method; it takes about one for each layer.
_MOST_STEPS = 100


@dataclass(frozen=True)
class Reel:
    """Layers on the drum of a hook.

    Attributes:
        parts: parts of line of each rope.
        radius: pitch radius of the first layer [m].
        step: radius that each further layer adds [m].
        turns: turns of each rope in a full layer.
        start: turns on the drum at the start.
    """

    parts: int
    radius: float
    step: float
    turns: float
    start: float

    def gone(self, counted: float) -> float:
        """How far the hook has risen since the start where its drive counts so much [m]."""
        turn = 2 * math.pi * self.radius
        turned = self.start + self.parts * counted / turn
        more = self._climbed(turned) - self._climbed(self.start)
        return counted + turn * self.step / self.radius * more / self.parts

    def rate(self, counted: float) -> float:
        """What it rises there for what its drive counts: the radius over that of the first layer [1]."""
        turned = self.start + self.parts * counted / (2 * math.pi * self.radius)
        return 1 + self.step / self.radius * math.fsum(min(over, 1.0) for over in self._over(turned))

    def counted(self, gone: float) -> float:
        """What its drive counts where the hook has risen so far since the start [m], Newton's method."""
        if not math.isfinite(gone):
            return gone
        counted = gone
        for _ in range(_MOST_STEPS):
            step = (gone - self.gone(counted)) / self.rate(counted)
            counted += step
            if abs(step) <= 1e-15 * abs(counted):
                break
        return counted

    def _climbed(self, turned: float) -> float:
        """Turns on the drum, each as often as it lies layers above the first."""
        return _CLIMB * math.fsum(over**2 / 2 if over < 1 else over - 0.5 for over in self._over(turned))

    def _over(self, turned: float) -> list[float]:
        """How far over each climb that has begun the rope is, in climbs."""
        climbs = max(math.floor((turned + _CLIMB / 2) / self.turns), 0)
        overs = ((turned - layer * self.turns) / _CLIMB + 0.5 for layer in range(1, climbs + 1))
        return [over for over in overs if over > 0]
