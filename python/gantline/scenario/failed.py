"""Where and why a simulation failed, in words of the lift file: the core knows bodies, ropes and joints."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from gantline.scenario.errors import shorten
from gantline.scenario.loads.hinge import failed_at as failed_in_hinge
from gantline.scenario.mechanics import Sheave

if TYPE_CHECKING:
    from gantline.scenario.model import Scenario

__all__ = ["failed_at", "on_its_route"]

#: How the core says that a body has met the next place of its rope (`event/standstill.rs`).
_MET = "it has come to the next place that "
_RUN_OUT = re.compile(rf"{_MET}sling\.(?P<sling>.+) passes, and nothing stops it there")
#: How it names a straight part of a rope (`build/ropes.rs`, `stepper/seats.rs`), and what is wrong with one.
_PART = re.compile(r"\bits part (\d+)( at the start)?: ")
_WITHIN = {
    "the sheave where it starts holds the other end within its circle, seen along the axis": (
        "second",
        "first",
    ),
    "the sheave where it ends holds the other end within its circle, seen along the axis": (
        "first",
        "second",
    ),
}


def failed_at(scenario: Scenario, element: str, cause: str) -> tuple[str, str]:
    """Where a simulation failed, and why, of hooks, slings and hinges as who wrote the lift file knows them.

    Args:
        scenario: The lift.
        element: Name of what it failed at.
        cause: What failed.
    """
    if cause.startswith(_MET) and element in scenario.hooks:
        met = "its hook block has come up to the sheaves above it (two-blocking), and nothing stops it there"
        return element, f"{met}: hoist it less far; 'highest' of a hook is checked"
    if (found := _RUN_OUT.match(cause)) is not None:
        sling = (scenario.slings or {}).get(found["sling"])
        if sling is not None and sling.over is not None:
            # The core names the sheave or what hangs on the sling, as one or the other moves.
            ran = "the sling over it has run out to one of its ends, and nothing stops it there"
            return sling.over, f"{ran}: what hung on the other end of {found['sling']} does not hold any more"
    return failed_in_hinge(scenario, element, on_its_route(scenario, element, cause))


def on_its_route(scenario: Scenario, element: str, cause: str) -> str:
    """What the core says of a part of a rope, with the places of the `route` between which that is.

    Args:
        scenario: The lift.
        element: Name of what that is about; of all but ropes of `mechanics` the cause stays as it is.
        cause: What the core says.
    """
    ropes = (scenario.mechanics.ropes if scenario.mechanics is not None else None) or {}
    found = _PART.search(cause)
    # A part goes on over sheaves that the rope has left, and the core counts where it begins.
    if found is None or element not in ropes or any(_may_be_left(one) for one in ropes[element].route):
        return cause
    first = int(found[1])
    ends = " to ".join(
        f"route[{place}] ({one.what} on '{shorten(one.body)}')"
        for place, one in enumerate(ropes[element].route[first - 1 : first + 1], start=first)
    )
    rest = cause[found.end() :]
    if rest in _WITHIN:
        inner, outer = _WITHIN[rest]
        within = f"the {inner} lies within the circle of the {outer}, seen along the axis of that"
        rest = f"{within}, and no rope leads onto it from there"
    return f"{cause[: found.start()]}its part {first}{found[2] or ''}, from {ends}: {rest}"


def _may_be_left(guide: object) -> bool:
    return isinstance(guide, Sheave) and guide.may_lift_off
