"""Falls that get longer than at the start: masses of ropes stay where they were put, so no force has them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.results.gear import Rope
from gantline.results.rig import Rig
from gantline.results.variable import Columns, Names
from gantline.units import format_by_size, format_quantity

__all__ = ["longer_falls"]

#: Share of its largest hoist load by which that of a hook may be more without a word.
_LITTLE = 0.01


def longer_falls(rig: Rig, columns: Columns, names: Names) -> list[str]:
    """A warning for each hook that is lowered so far that its falls would weigh more than a little.

    Rope that the drum pays out hangs between the sheaves of the hook block and the upper ones, and all of it
    is hoist load. What an empty hook has more of it than the load had higher up is not told of.
    """
    return list(_longer(rig, columns, names)) if len(columns["time"]) else []


def _longer(rig: Rig, columns: Columns, names: Names) -> Iterator[str]:
    segments, ropes = list(names["segment"]), {rope.name: rope for rope in rig.ropes}
    for hook in rig.hooks:
        masses = [_running(ropes.get(fall.rpartition("/")[0])) for fall in hook.falls]
        if not any(masses):
            continue
        at = [segments.index(fall) for fall in hook.falls]
        lengths = columns["segment_length"][:, at]
        more = (lengths - lengths[0]) @ np.array(masses)
        load = columns["segment_tension"][:, at].sum(axis=1) + hook.falls_weight_above
        most = int(np.argmax(load + more * rig.gravity))
        share = (load[most] + more[most] * rig.gravity) / load.max() - 1.0 if load.max() > 0.0 else 0.0
        if share > _LITTLE:
            rope = format_quantity(float((lengths[most] - lengths[0]).sum()), "m", 0)
            mass = format_by_size(float(more[most]), "mass")
            when = f"{columns['time'][most]:.2f} s"
            longer = f"the falls of {hook.name} hold {rope} of rope more at {when} than at the start"
            left_out = f"{mass} that no force has, and {100.0 * share:.1f} % of its hoist load"
            right = "'rope_weight: none' and falls of that length in the mass of the hook block count them"
            yield f"{longer}, {left_out}; {right}"


def _running(rope: Rope | None) -> float:
    """Mass per length of a rope that is lumped where it was at the start [kg/m]; 0 of one without weight."""
    return rope.mass_per_length if rope is not None and rope.weight == "lumped" else 0.0
