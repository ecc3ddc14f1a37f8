"""What steps of the plan wait for, in words, and by which variable of a recording it is seen."""

from __future__ import annotations

from typing import Any

from gantline.assembly.parts import Json
from gantline.scenario import Scenario
from gantline.scenario.condition import Condition, HoistLoadReached, MooringTensionReached
from gantline.scenario.hooks import full_name
from gantline.units import format_quantity

__all__ = ["waited_for"]


def waited_for(scenario: Scenario, step: Any) -> Json:
    """What a step waits for: words, and `[variable, element, unit]` where one variable has it; or nothing."""
    until: Condition | None = getattr(step, "until", None)
    if until is None:
        return {}
    load = "" if scenario.load is None else scenario.load.name
    if until.load_tilt is not None:
        tilt = until.load_tilt
        return _told("load_tilt", _bound(tilt.above, tilt.below, "deg", 1), ("load_tilt", load, "deg"))
    if until.hoist_load is not None:
        hook = full_name(until.hoist_load.hook, scenario.hooks) or until.hoist_load.hook
        bound = _force(scenario, until.hoist_load)
        return _told(f"hoist_load of {hook}", bound, ("hoist_load", hook, "kN"))
    if until.mooring_tension is not None:
        line, bound = until.mooring_tension.line, _force(scenario, until.mooring_tension)
        return _told(f"mooring_tension of {line}", bound, ("rope_tension", f"mooring.{line}", "kN"))
    if until.load_transferred is not None:
        share = format_quantity(until.load_transferred, "%", 0)
        return _told("load_transferred", share, ("load_transferred", load, "%"))
    if until.supports is not None:
        return _told("supports", until.supports, ("load_transferred", load, "%"))
    key = next(key for key in type(until).model_fields if key != "of" and getattr(until, key) is not None)
    return {"waits_for": key}


def _told(what: str, bound: str, seen: tuple[str, str, str]) -> Json:
    return {"waits_for": f"{what} {bound}", "seen_by": list(seen)}


def _force(scenario: Scenario, reached: HoistLoadReached | MooringTensionReached) -> str:
    gravity = scenario.simulation.gravity
    above, below = (None if one is None else one.newtons(gravity) for one in (reached.above, reached.below))
    return _bound(above, below, "kN", 1)


def _bound(above: float | None, below: float | None, unit: str, digits: int) -> str:
    if above is not None:
        return f"above {format_quantity(above, unit, digits)}"
    return f"below {format_quantity(below or 0.0, unit, digits)}"
