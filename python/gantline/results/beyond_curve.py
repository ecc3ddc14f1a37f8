"""Ropes that pull more than the last point of their curve, where nobody has said what they stretch by."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gantline.results.gear import Rope
from gantline.results.variable import Columns, Names
from gantline.units import format_by_size

__all__ = ["beyond_curve"]

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
        if not rope.curve or rope.name not in names["rope"]:
            continue
        at = list(names["rope"]).index(rope.name)
        most = float(np.nanmax(columns["rope_tension"][:, at]))
        if "rope_peak_tension" in columns:
            most = max(most, float(columns["rope_peak_tension"][at]))
        strain, last = rope.curve[-1]
        if most > last * (1.0 + _ABOVE):
            pulls = f"{rope.name} pulls with up to {format_by_size(most, 'force')}"
            point = f"the last point of its curve, {format_by_size(last, 'force')} at {100.0 * strain:.3g} %"
            found.append(
                f"{pulls}, more than {point}: it goes on along its last line, which nobody has given"
            )
    return found
