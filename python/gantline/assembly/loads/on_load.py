"""Points of `mechanics` on the load, which count from its centre of gravity: ends at lugs, moved centres."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.plain import ropes_at_lugs
from gantline.assembly.spatial import Array
from gantline.scenario import Scenario
from gantline.scenario.mechanics import HalfTurn, RopeEnd

__all__ = ["kept_on_load"]


def kept_on_load(scenario: Scenario, lifted: LiftedLoad) -> Scenario:
    """The scenario with ropes, contacts and bodies of `mechanics` on its load where the lift file has them.

    Ends of ropes that are made fast to lugs come to these. All else a lift file counts from the centre of
    gravity. In a case in which that is elsewhere it has not moved, and so counts otherwise from there. What
    is lumped on the load stays, so that the common centre of gravity moves by less than that of the load by
    itself.
    """
    mechanics, load = scenario.mechanics, scenario.load
    if mechanics is None or load is None:
        return scenario
    if not any(scenario.centre_moved) and not ropes_at_lugs(scenario):
        return scenario
    back = -lifted.body.mass / lifted.mass * np.array(scenario.centre_moved)

    def moved(element: Any, *keys: str) -> Any:
        return element.model_copy(update={key: _plus(getattr(element, key), back) for key in keys})

    def guide(one: Any) -> Any:
        if one.body != load.name:
            return one
        if isinstance(one, RopeEnd) and one.lug is not None:
            x, y, z = lifted.lugs[one.lug]
            return one.model_copy(update={"at": (x, y, z)})
        return moved(one, "enter", "leave") if isinstance(one, HalfTurn) else moved(one, "at")

    def each(given: Mapping[str, Any] | None, of: str) -> dict[str, Any] | None:
        if given is None:
            return None
        return {
            name: moved(one, "at") if getattr(one, of) == load.name else one for name, one in given.items()
        }

    ropes = {
        name: rope.model_copy(update={"route": [guide(one) for one in rope.route]})
        for name, rope in (mechanics.ropes or {}).items()
    }
    kept = {
        "bodies": each(mechanics.bodies, "parent"),
        "contacts": each(mechanics.contacts, "body"),
        "ropes": ropes or None,
    }
    return scenario.model_copy(update={"mechanics": mechanics.model_copy(update=kept)})


def _plus(at: tuple[float, float, float], way: Array) -> tuple[float, float, float]:
    x, y, z = (float(part) for part in np.array(at) + way)
    return x, y, z
