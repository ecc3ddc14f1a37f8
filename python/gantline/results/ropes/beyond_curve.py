"""Ropes that pull more than the last point of their curve, where nobody has said what they stretch by."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from gantline.results.gear import Rope
from gantline.results.variable import Columns, Names
from gantline.units import format_by_size

__all__ = ["beyond_curve", "beyond_curve_at_start"]

#: A tension that is above the last point by this share is above it: tolerances of methods are less [1].
_ABOVE = 1e-3


def beyond_curve(ropes: Sequence[Rope], columns: Columns, names: Names) -> list[str]:
    """A sentence for each rope whose tension goes past the last point of its curve, with the largest.

    Args:
        ropes: Those of the rig.
        columns: Columns of the core by name.
        names: Names along their dimensions.
    """
    found = []
    for rope in ropes if len(columns["time"]) else ():
        if not rope.curve:
            continue
        at = list(names["rope"]).index(rope.name)
        most = float(np.nanmax(columns["rope_tension"][:, at]))
        if "rope_peak_tension" in columns:
            most = max(most, float(columns["rope_peak_tension"][at]))
        if _is_beyond(rope, most):
            found.append(_told(rope, f"pulls with up to {format_by_size(most, 'force')}"))
    return found


def beyond_curve_at_start(ropes: Sequence[Rope], tensions: Mapping[str, float]) -> Iterator[tuple[Rope, str]]:
    """Each rope that pulls more than the last point of its curve before anything moves, and its sentence.

    Args:
        ropes: Those of the rig.
        tensions: Of those with a curve at the start, by their names [N].
    """
    for rope in ropes:
        if rope.curve and _is_beyond(rope, tensions[rope.name]):
            pulls = f"pulls with {format_by_size(tensions[rope.name], 'force')} at the start"
            yield rope, _told(rope, pulls)


def _is_beyond(rope: Rope, tension: float) -> bool:
    return tension > rope.curve[-1][1] * (1.0 + _ABOVE)


def _told(rope: Rope, pulls: str) -> str:
    strain, last = rope.curve[-1]
    point = f"the last point of its curve, {format_by_size(last, 'force')} at {100.0 * strain:.3g} %"
    return f"{rope.name} {pulls}, more than {point}: it goes on along its last line, which nobody has given"
