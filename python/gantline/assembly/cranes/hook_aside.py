"""How far a hook stands beside the lugs that it bears, where slings do not reach them at the start."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from gantline.assembly.parts import Parts
from gantline.scenario import Rigging, Scenario
from gantline.scenario.rigging import SlingRigging
from gantline.units import format_quantity

__all__ = ["hook_aside"]

#: What a hook may stand beside its lugs without a word [m]: slings that lack more than that lack height.
_ASIDE = 0.5


def hook_aside(
    parts: Parts,
    scenario: Scenario,
    rigging: Rigging,
    sling: SlingRigging,
    missing: float,
    lugs: Mapping[str, Sequence[float]],
) -> str:
    """That the hook of a sling that is too short stands beside the middle of its lugs; empty if it does not.

    Its height is seldom what is wrong then: a heading, an outreach or a sign is.

    Args:
        parts: The system, with hooks and load.
        scenario: The lift.
        rigging: Who carries whom.
        sling: The sling that is too short.
        missing: By how much [m].
        lugs: Positions of lugs in the load's body frame, by name [m].
    """
    hooks = set(_hooks_over(rigging, sling))
    if len(hooks) != 1 or scenario.load is None:
        return ""
    [hook] = hooks
    borne = [
        parts.place(scenario.load.name, lugs[lug])
        for one in rigging.slings.values()
        if set(_hooks_over(rigging, one)) == hooks  # below a beam in several hooks lugs are of none of them
        for lug in one.lugs
    ]
    if not borne:
        return ""
    way = (np.mean(borne, axis=0) - parts.pose(hook)[0])[:2]
    aside = float(np.linalg.norm(way))
    if aside <= max(_ASIDE, missing):
        return ""
    goes = " and ".join(
        f"{format_quantity(abs(part), 'm', 2)} along {'−' if part < 0.0 else '+'}{axis}"
        for part, axis in zip(way, "xy", strict=True)
        if abs(part) >= 5e-3
    )
    stands = f"{hook} stands {format_quantity(aside, 'm', 2)} beside the middle of its lugs"
    return f"{stands}: from it they are {goes}"


def _hooks_over(rigging: Rigging, sling: SlingRigging) -> Iterator[str]:
    """Hooks from which a sling hangs, by itself or by the gear between."""
    if sling.hook:
        yield sling.hook
        return
    bearing = sling.over or sling.spreader or sling.compensator
    for one in rigging.slings.values():
        if any(bearing in (end.spreader, end.extension, end.compensator) for end in one.ends):
            yield from _hooks_over(rigging, one)
