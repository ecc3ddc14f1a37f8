"""Where a recording has no number: not a number, or infinite. Nothing that is shown may hide that."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from gantline.results.recording import Recording
from gantline.results.variable import Variable

__all__ = ["gap", "gaps", "without_gaps"]

#: Distances of ropes, which end where these part.
_END = frozenset({"clearance", "clearance_point"})
_MOST_NAMED = 3


def gaps(recording: Recording) -> list[str]:
    """A sentence for each variable that has values which are no numbers, though a run never leaves any.

    Args:
        recording: Any recording.
    """
    return [sentence for name in recording.variables if (sentence := gap(recording, name)) is not None]


def gap(recording: Recording, name: str) -> str | None:
    """A sentence for a variable that has values which are no numbers; None for one that has none."""
    variable = recording[name]
    if name in _END or variable.is_text or not _has_gaps(variable):
        return None
    return _sentence(recording, name, variable)


def without_gaps(document: Any) -> Any:
    """The same JSON with null in place of what is no number."""
    if isinstance(document, dict):
        return {key: without_gaps(one) for key, one in document.items()}
    if isinstance(document, list | tuple):
        return [without_gaps(one) for one in document]
    return None if isinstance(document, float) and not math.isfinite(document) else document


def _has_gaps(variable: Variable) -> bool:
    # One pass without a mask: a sum is finite if all are, and large sums that are not are looked at again.
    with np.errstate(over="ignore", invalid="ignore"):
        total = float(np.sum(variable.values))
    return not math.isfinite(total) and not bool(np.all(np.isfinite(variable.values)))


def _sentence(recording: Recording, name: str, variable: Variable) -> str:
    missing = ~np.isfinite(variable.values)
    of = ", ".join(_elements(recording, variable, missing))
    when = ""
    if variable.dims[:1] == ("time",):
        first = np.flatnonzero(missing.reshape(len(missing), -1).any(axis=1))
        samples = f"{len(first)} sample" + ("s" if len(first) > 1 else "")
        when = f" at {samples}, first at {recording.time[first[0]]:.2f} s"
    return f"{name}{f' of {of}' if of else ''} is no number{when}: what follows from it is not known"


def _elements(recording: Recording, variable: Variable, missing: Any) -> Iterator[str]:
    """Names along the first dimension that has some, of what has values that are no numbers."""
    of_points = recording["rope_of_point"].values.tolist() if "rope_of_point" in recording else None
    for axis, dim in enumerate(variable.dims):
        labels = of_points if dim == "rope_point" else recording.coordinates.get(dim)
        if labels is None:
            continue
        others = tuple(other for other in range(missing.ndim) if other != axis)
        found = list(dict.fromkeys(labels[place] for place in np.flatnonzero(missing.any(axis=others))))
        yield from found[:_MOST_NAMED]
        if len(found) > _MOST_NAMED:
            yield f"{len(found) - _MOST_NAMED} more"
        return
