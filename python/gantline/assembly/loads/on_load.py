"""Points of `mechanics` on the load, which count from its centre of gravity, where a case moves that."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.spatial import Array
from gantline.scenario import Scenario
from gantline.scenario.mechanics import HalfTurn

__all__ = ["kept_on_load"]


def kept_on_load(scenario: Scenario, lifted: LiftedLoad) -> Scenario:
    """The scenario with ropes, contacts and bodies of `mechanics` on its load where the lift file has them.

    A lift file counts them from the centre of gravity. In a case in which that is elsewhere they have not
    moved, and so count otherwise from it. What is lumped on the load stays, so that the common centre of
    gravity moves by less than that of the load by itself.
    """
    mechanics, load = scenario.mechanics, scenario.load
    if mechanics is None or load is None or not any(scenario.centre_moved):
        return scenario
    back = -lifted.body.mass / lifted.mass * np.array(scenario.centre_moved)

    def moved(element: Any, *keys: str) -> Any:
        return element.model_copy(update={key: _plus(getattr(element, key), back) for key in keys})

    def guide(one: Any) -> Any:
        if one.body != load.name:
            return one
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
