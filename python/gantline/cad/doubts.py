"""All that is doubtful about a CAD model and its parts, in few sentences."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gantline.cad.model import CadModel, Part

__all__ = ["doubts_of_parts", "doubts_of_the_whole"]

#: From here on a difference between computed and declared mass is told as a doubt.
_DIFFERS = 0.01
_MOST_NAMES = 3
#: Decimals of metres to which parts are in one place.
_ONE_PLACE = 5


def doubts_of_the_whole(model: CadModel) -> Iterator[str]:
    """What is doubtful about the whole: sentences that begin small and have no full stop."""
    yield from model.doubts
    twice = [one.name for one in _in_one_place(model)]
    if twice:
        yield f"counted twice, since others just like them are in the same place: {_named(twice)}"
    without = [part.name for part in model.without_weight]
    if without:
        yield f"without weight: {_named(without)}"
    pointlike = [part.name for part in model.parts if part.properties is None and part.counted is not None]
    if pointlike:
        yield f"counted as point masses by their declared weight: {_named(pointlike)}"
    differing = [
        part.name
        for part in model.parts
        if part.properties is not None
        and part.declared is not None
        and part.declared.mass > 0
        and abs(part.properties.mass - part.declared.mass) > _DIFFERS * part.declared.mass
    ]
    if differing:
        yield f"computed and declared mass differ by more than {_DIFFERS:.0%}: {_named(differing)}"


def _in_one_place(model: CadModel) -> Iterator[Part]:
    """Parts of the same kind, mass and inertia in the same place as an earlier one."""
    seen: set[tuple[object, ...]] = set()
    for part in model.parts:
        own = part.properties
        if own is None:
            continue
        radii = np.sqrt(np.abs(np.diag(own.inertia)) / own.mass)
        key = (part.kind, f"{own.mass:.6g}", *np.round([*own.centre, *radii], _ONE_PLACE).tolist())
        if key in seen:
            yield part
        seen.add(key)


def doubts_of_parts(model: CadModel) -> Iterator[str]:
    """Doubts of parts, each once behind the names of those that have it, without full stop."""
    groups: dict[str, list[str]] = {}
    for part in model.parts:
        for doubt in part.doubts:
            groups.setdefault(doubt, []).append(part.name)
    for doubt, names in groups.items():
        yield f"{_named(names)}: {doubt}"


def _named(names: Sequence[str]) -> str:
    shown = [name or "(no name)" for name in names[:_MOST_NAMES]]
    more = len(names) - len(shown)
    return ", ".join(shown) + (f" and {more} more" if more else "")
