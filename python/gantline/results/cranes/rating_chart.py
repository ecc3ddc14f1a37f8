"""Rating charts of cranes with a boom: what may hang at which radius, and for which attitudes that holds.

docs/concepts/rating.md says what is compared with what.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Self

import numpy as np

from gantline.results.strength import FromJson
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["RatingChart"]

#: Rounding of radii and angles at the ends of a chart, as a share of its largest entry.
_ROUNDING = 1e-9


@dataclass(frozen=True)
class RatingChart(FromJson):
    """The rating chart of one crane, or of one of its hooks.

    Attributes:
        crane: The crane.
        over: What its rows are for: `radius`, `outreach` or `angle`.
        at: Radius or outreach [m], or boom angle [rad], of each row, rising.
        rated: What may hang there, all hooks together [N].
        between: What may hang between two rows: on `lines` between them, or the `lower` of both.
        includes_hook_block: Whether that is the hoist load, else the hook load.
        hooks: The hooks of the crane.
        apart: Those that this chart is for by the place of the boom at which they hang, where that is not one
            for all.
        own: Charts of hooks that have one of their own, by hook; this one has no rows where all have.
        hook_shares: By hook the largest share of the row that it may carry alone [1].
        hooks_share: The same where the lift file says it; it holds of a hook that is alone there, too.
        heel: Largest heel for which the chart holds [rad]; None if not said, as the next three.
        trim: Largest trim.
        off_lead: Largest angle of falls from plumb in the plane of the boom.
        side_lead: Largest angle of falls from plumb across it.
        significant_height: Largest significant height of the waves [m].
    """

    crane: str
    over: str = "radius"
    at: Sequence[float] = ()
    rated: Sequence[float] = ()
    between: str = "lines"
    includes_hook_block: bool = False
    hooks: Sequence[str] = ()
    apart: Sequence[Sequence[str]] = ()
    own: Mapping[str, RatingChart] = field(default_factory=dict)
    hook_shares: Mapping[str, float] | None = None
    hooks_share: float | None = None
    heel: float | None = None
    trim: float | None = None
    off_lead: float | None = None
    side_lead: float | None = None
    significant_height: float | None = None

    @classmethod
    def from_json(cls, document: Mapping[str, Any]) -> Self:
        """Make one from its JSON object."""
        own = {hook: RatingChart.from_json(one) for hook, one in document.get("own", {}).items()}
        return super().from_json({**document, "own": own})

    def of(self, hook: str) -> RatingChart:
        """The chart that rates a hook."""
        return self.own.get(hook, self)

    @property
    def shared(self) -> tuple[str, ...]:
        """The hooks that this chart itself rates."""
        return tuple(hook for hook in self.hooks if hook not in self.own)

    def holds(self, place: FloatArray) -> BoolArray:
        """Where a radius [m] or boom angle [rad] is within the rows, of any shape."""
        rounding = self._rounding
        inside: BoolArray = (place >= self.at[0] - rounding) & (place <= self.at[-1] + rounding)
        return inside

    def nearest(self, place: FloatArray) -> FloatArray:
        """The nearest place within the rows."""
        return np.clip(place, self.at[0], self.at[-1])

    @property
    def _rounding(self) -> float:
        return _ROUNDING * abs(self.at[-1])

    def rated_at(self, place: FloatArray) -> FloatArray:
        """Rated load [N] at a radius [m] or boom angle [rad]; 0 outside of the rows."""
        if self.between == "lower":
            rows, last = np.asarray(self.at), len(self.at) - 1
            loads = np.asarray(self.rated)
            # At a row, to rounding, that row is both of its neighbours.
            above = np.minimum(np.searchsorted(rows, place - self._rounding), last)
            below = np.maximum(np.searchsorted(rows, place + self._rounding, side="right") - 1, 0)
            between = np.minimum(loads[below], loads[above])
        else:
            between = np.interp(place, self.at, self.rated)
        rated: FloatArray = np.where(self.holds(place), between, 0.0)
        return rated

    def share_of(self, hook: str) -> float:
        """Largest share of a row that a hook may carry alone [1]."""
        return (self.hook_shares or {}).get(hook, 1.0)
