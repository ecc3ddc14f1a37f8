"""What steps of the plan wait for, in words of a yard, and by which variable of a recording it is seen."""

from __future__ import annotations

from typing import Any

from gantline.assembly.parts import Json
from gantline.scenario import Scenario
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.plan.condition import Condition, Weighing
from gantline.units import format_quantity

__all__ = ["waited_for"]


def waited_for(scenario: Scenario, step: Any) -> Json:
    """The condition that ends a step, as `supports clear` and `hoist load of U1 above 40 t`; or nothing.

    Where one variable of recordings has it, `seen_by` names that, its element, and a unit for people. So it
    does of the tension spread, which tensions of slings have, with all equalizers that count, spaces between.
    """
    if step.until is None:
        return {}
    seen = _seen_by(scenario, step.until)
    return {"until": _in_words(step.until), **({"seen_by": list(seen)} if seen else {})}


def _seen_by(scenario: Scenario, until: Condition) -> tuple[str, str, str] | None:
    load = "" if scenario.load is None else scenario.load.name
    if until.load_tilt is not None:
        return "load_tilt", load, "deg"
    if until.hoist_load is not None:
        hook = until.hoist_load.hook
        return "hoist_load", full_name(hook, scenario.hooks) or hook, "kN"
    if until.mooring_tension is not None:
        return "rope_tension", f"mooring.{until.mooring_tension.line}", "kN"
    if until.load_transferred is not None or until.supports is not None:
        return "load_transferred", load, "%"
    if until.tension_spread is not None:
        return "tension_spread", " ".join(until.of or scenario.equalizers or ()), "%"
    for key, reached in (("vessel_heel", until.heel), ("vessel_trim", until.trim)):
        # No variable has it of a plain body of `mechanics`.
        if reached is not None and reached.vessel in (scenario.vessels or {}):
            return key, reached.vessel, "deg"
    return None


def _in_words(until: Condition) -> str:
    names = ", ".join(name.removeprefix("sling.") for name in until.of)
    if until.load_transferred is not None:
        return f"load transferred {_given(until.load_transferred, '%')}"
    if until.supports is not None:
        return f"supports {until.supports}"
    if until.tension_spread is not None:
        return f"tension spread{names and f' of {names}'} below {_given(until.tension_spread, '%')}"
    if until.slings is not None:
        return f"{names or 'slings'} {until.slings}"
    if until.falls_out_of_plumb is not None:
        return f"falls{names and f' of {names}'} within {_given(until.falls_out_of_plumb, 'deg')} of plumb"
    if until.hoist_load is not None:
        return f"hoist load of {until.hoist_load.hook} {_side(until.hoist_load)}"
    if until.mooring_tension is not None:
        return f"tension of {until.mooring_tension.line} {_side(until.mooring_tension)}"
    if until.load_tilt is not None:
        return f"tilt {_side(until.load_tilt)}"
    key, reached = ("heel", until.heel) if until.heel is not None else ("trim", until.trim)
    assert reached is not None, "the lift file was checked: a step waits for one thing"
    return f"{key} of {reached.vessel} {_side(reached)}"


def _side(reached: Any) -> str:
    """`above 40 t` or `below 0.1 deg`."""
    side = "above" if reached.above is not None else "below"
    value = getattr(reached, side)
    if not isinstance(value, Weighing):
        return f"{side} {_given(value, 'deg')}"
    # Without the commas between thousands that others read as decimal ones: 1095 t, 1602 kN.
    return f"{side} {_given(value.mass, 't') if value.mass else _given(value.force, 'kN')}"


def _given(value: float, unit: str) -> str:
    """A quantity with the digits that somebody gave it."""
    digits, _, name = format_quantity(value, unit, 3).partition(" ")
    return f"{digits.rstrip('0').rstrip('.')} {name}"
