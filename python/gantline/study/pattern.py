"""Which slings are long and which short: patterns of signs, chosen by sensitivities."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt

from gantline.statics import Statics
from gantline.units import format_quantity

__all__ = ["Floats", "changes_of_tension", "pattern_label", "single_patterns", "worst_patterns"]

Floats = npt.NDArray[np.float64]

#: Changes of tension that differ by less than this share of the largest are alike.
_ALIKE = 1e-6


def changes_of_tension(question: Statics, longer: Mapping[str, float]) -> Floats:
    """What greater length of each of some slings changes in the tension of every sling, to first order.

    Args:
        question: A lift of which the equilibrium has been found.
        longer: By how much each sling is longer [m].

    Returns:
        Changes of tension [N], shape (sling of the lift, sling of `longer`).

    Raises:
        RuntimeError: If tensions have no sensitivities to lengths.
    """
    ropes = {sling.name: sling.rope for sling in question.rig.slings}
    found = question.sensitivities([("length", ropes[sling]) for sling in longer])
    rows = [[one.of(rope) for one in found] for rope in ropes.values()]
    changes: Floats = np.array(rows) * np.array(list(longer.values()))
    return changes


def single_patterns(count: int) -> list[tuple[int, ...]]:
    """Signs of what slings are off, +1 long, −1 short, 0 as planned: each sling by itself."""
    single = [tuple(int(place == one) for place in range(count)) for one in range(count)]
    return [pattern for one in single for pattern in (one, _opposite(one))]


def worst_patterns(kind: str, change: Floats) -> list[tuple[int, ...]]:
    """The same of the worst patterns, each once.

    Args:
        kind: `worst` or `worst_pair`.
        change: As `changes_of_tension` gives it.
    """
    # What is left of a sensitivity by rounding has no sign.
    known = np.where(np.abs(change) > _ALIKE * np.abs(change).max(initial=0.0), change, 0.0)
    if kind == "worst":
        rows = [tuple(int(sign) for sign in np.sign(row)) for row in known]
    else:
        rows = [_worst_pair(known)]
    both = (pattern for row in rows for pattern in (row, _opposite(row)) if any(row))
    return list(dict.fromkeys(both))


def _worst_pair(change: Floats) -> tuple[int, ...]:
    """One sling long and another short by their tolerances: those that change some tension most."""
    most, pair = 0.0, (0, 0)
    for row in change:
        long, short = _first(row), _first(-row)
        spread = float(row[long] - row[short])
        if spread > most * (1.0 + _ALIKE):
            most, pair = spread, (long, short)
    return tuple(int(place == pair[0]) - int(place == pair[1]) for place in range(change.shape[1]))


def _first(row: Floats) -> int:
    """Place of the largest, of those alike the first."""
    return int(np.flatnonzero(row >= row.max() - _ALIKE * np.abs(row).max())[0])


def _opposite(pattern: Sequence[int]) -> tuple[int, ...]:
    return tuple(-sign for sign in pattern)


def pattern_label(longer: Mapping[str, float]) -> str:
    """Which slings are long and short; by how much, if they are few."""
    if len(longer) > 2:
        signs = {
            "+": [s for s, more in longer.items() if more > 0],
            "−": [s for s, more in longer.items() if more < 0],
        }
        return " ".join(f"{sign}{','.join(names)}" for sign, names in signs.items() if names)
    return ", ".join(
        f"{sling} {'+' if more > 0 else '−'}{format_quantity(abs(more), 'mm', 1)}"
        for sling, more in longer.items()
    )
