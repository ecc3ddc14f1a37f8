"""Loads that go into water: only hulls feel it in a simulation."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from gantline.results.rotation import axes
from gantline.results.solids import skin_of
from gantline.results.surroundings import SIGNS
from gantline.results.variable import Columns, Names

__all__ = ["immersion_warnings"]

#: How deep a load may dip without a word [m]: contact and slings give that much.
_DIPS = 0.01


def immersion_warnings(
    columns: Columns,
    names: Names,
    scene: Mapping[str, Any],
    loads: Mapping[str, str],
    density: float,
) -> list[str]:
    """A sentence for each load of which part goes under water, with what water would carry of it at most.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        scene: What is drawn, with the level of the water where there is some.
        loads: Their bodies by name.
        density: Of the water [kg/m^3].
    """
    water = scene.get("water")
    if not water or not len(columns["time"]):
        return []
    drawn = {body["name"]: body for body in scene.get("bodies") or ()}
    warnings = []
    for load, body in loads.items():
        skin = skin_of(drawn.get(body))
        if not len(skin):
            continue
        # A load from CAD by the box about it: thousands of points at every sample are too many.
        least, most = skin.min(axis=(0, 1)), skin.max(axis=(0, 1))
        own = (least + most) / 2 + SIGNS * (most - least) / 2
        at = list(names["body"]).index(body)
        # Heights of its corners over its centre of gravity.
        heights = axes(columns["body_orientation"][:, at])[:, 2] @ own.T
        low = columns["body_position"][:, at, 2] + heights.min(axis=1)
        deep = float(water["level"]) - low
        under = np.flatnonzero(deep > _DIPS)
        if not under.size:
            continue
        worst = int(np.argmax(deep))
        share = min(1.0, float(deep[worst] / np.ptp(heights[worst])))
        carried = density * share * float(np.prod(most - least))
        since = f"at {columns['time'][under[0]]:.2f} s"
        when = f"{load} goes into the water {since}, up to {deep[worst]:.2f} m deep"
        without = "no buoyancy, slamming, drag or added mass acts on a load here, as it would"
        closed = f"if its box were closed, water would carry up to {carried / 1e3:.3g} t"
        warnings.append(f"{when}; {without}, and {closed}")
    return warnings
