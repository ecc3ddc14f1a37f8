"""The plan into operations of drives."""

from __future__ import annotations

from gantline.assembly.moorings import winch_drive
from gantline.assembly.parts import Json
from gantline.assembly.plain import drum_drive
from gantline.assembly.reeving import upper_sheaves
from gantline.assembly.yard import hoist_drive
from gantline.scenario import Rigging, Scenario
from gantline.scenario.condition import Condition
from gantline.scenario.hooks import full_name
from gantline.scenario.mooring import line_rope
from gantline.scenario.movers import Mover, mover
from gantline.scenario.plan import HoldStep, LowerStep, MovingStep, PayOutStep, Step
from gantline.scenario.reeving import hoist_ropes

__all__ = ["along_drive", "emergency_stop", "moved_drives", "operations"]

#: Within this a motor is asked to stop in an emergency [s]; brakes slip far longer.
_AT_ONCE = 1e-3


def along_drive(name: str) -> str:
    """Name of the drive of a trolley along its girder, or of a crane along its rails."""
    return f"{name}.along"


def operations(scenario: Scenario, rigging: Rigging, weight: float) -> list[Json]:
    """Steps of the document; `weight` is what the load weighs as it is simulated [N]."""
    found = []
    for place, step in enumerate(scenario.plan):
        made = _hold(step) if isinstance(step, HoldStep) else _moving(scenario, step)
        if step.until is not None:
            down = isinstance(step, (LowerStep, PayOutStep))
            made["until"] = _condition(scenario, rigging, step.until, weight, down=down)
        if place == 0 and made["start_at"] is None:
            made["start_at"] = 0.0
        found.append(made)
    return found


def moved_drives(scenario: Scenario, step: Step) -> list[str]:
    """Names of the drives that a step moves."""
    return [] if isinstance(step, HoldStep) else [_drive(one) for one in _moved(scenario, step)]


def emergency_stop(scenario: Scenario) -> Json | None:
    """The emergency stop of the document, of all that the plan moves; None without one."""
    stop = scenario.emergency_stop
    if stop is None:
        return None
    at: Json = {"type": "time", "time": stop.at}
    if stop.in_step is not None:
        place = [step.step for step in scenario.plan].index(stop.in_step)
        at = {"type": "in_step", "step": place, "after": stop.after or 0.0}
    stopped = {}
    for step in scenario.plan:
        for one in [] if isinstance(step, HoldStep) else _moved(scenario, step):
            drive = _drive(one)
            stopped[drive] = {"drive": drive, "stop": _stop(one, one.speed)}
    return {"at": at, "drives": list(stopped.values())}


def _drive(one: Mover) -> str:
    if one.kind == "hook":
        return hoist_drive(one.name)
    if one.kind == "mooring line":
        return winch_drive(one.name)
    return drum_drive(one.name) if one.kind == "drum" else along_drive(one.name)


def _moved(scenario: Scenario, step: MovingStep) -> list[Mover]:
    found = [mover(scenario, step.kind, text) for text in step.moved]
    return [one for one in found if one is not None]


def _stop(one: Mover, speed: float) -> Json:
    """How a drive at a speed [m/s] is stopped in an emergency."""
    acceleration = speed / _AT_ONCE if one.capacity or one.emergency is None else one.emergency
    return {"acceleration": acceleration, "brake": one.brake}


def _hold(step: HoldStep) -> Json:
    until: Json = {"type": "end_of_run"}
    if not isinstance(step.hold, str):
        until = {"type": "duration", "duration": step.hold}
    return {"name": step.step, "moves": [], "start_at": None, "until": until}


def _moving(scenario: Scenario, step: MovingStep) -> Json:
    moved = _moved(scenario, step)
    moves = [
        {
            "drive": _drive(one),
            "velocity": step.sign * step.speed,
            "acceleration": step.acceleration if step.acceleration is not None else one.acceleration,
            "shape": "linear",
            **({} if step.emergency_stop_at is None else {"emergency": _stop(one, step.speed)}),
        }
        for one in moved
    ]
    made: Json = {"name": step.step, "moves": moves, "start_at": step.start_at, "until": {}}
    if step.starts == "with_previous":
        made["with_previous"] = True
    at = step.brake_from if step.brake_from is not None else step.emergency_stop_at
    to = getattr(step, "to", None)
    if at is not None:
        made["until"] = {"type": "brake_from", "time": at}
    elif step.by is not None:
        made["until"] = {"type": "distance", "distance": step.sign * step.by}
    elif to is not None:
        made["until"] = {"type": "position", "positions": [to - one.zero for one in moved]}
    return made


def _condition(
    scenario: Scenario, rigging: Rigging, condition: Condition, weight: float, *, down: bool
) -> Json:
    if condition.hoist_load is not None:
        reached = condition.hoist_load
        name = full_name(reached.hook, scenario.hooks) or ""
        reeving = scenario.hooks[name].reeving
        assert reeving is not None  # checked when the file was read
        segments = [[rope, part] for rope in hoist_ropes(name, reeving) for part in range(reeving.parts_each)]
        if reached.above is not None:
            return {"type": "tension_above", "segments": segments, "bound": reached.above}
        return {"type": "tension_below", "segments": segments, "bound": reached.below}
    if condition.tension_spread is not None:
        names = condition.of or tuple(rigging.equalizers)
        groups = [
            [f"sling.{one.name}" for one in rigging.slings.values() if one.equalizer == name]
            for name in names
        ]
        groups = [group for group in groups if group]
        return {"type": "spread", "groups": groups, "at_most": condition.tension_spread}
    if condition.falls_out_of_plumb is not None:
        reeved = {name: hook for name, hook in scenario.hooks.items() if hook.reeving is not None}
        hooks = [full_name(text, reeved) or text for text in condition.of] or list(reeved)
        middle = [0.0, 0.0, 0.0]
        falls = [[[upper_sheaves(hook), middle], [hook, middle]] for hook in hooks]
        return {"type": "plumb", "falls": falls, "at_most": condition.falls_out_of_plumb}
    if condition.mooring_tension is not None:
        wanted = condition.mooring_tension
        segments = [[line_rope(wanted.line), 0]]
        if wanted.above is not None:
            return {"type": "tension_above", "segments": segments, "bound": wanted.above}
        return {"type": "tension_below", "segments": segments, "bound": wanted.below}
    assert scenario.load is not None  # checked when the file was read
    group = scenario.load.name
    if condition.load_transferred is not None:
        share = condition.load_transferred
        if down:
            return {"type": "load_returned", "group": group, "weight": weight, "at_most": share}
        return {"type": "load_transferred", "group": group, "weight": weight, "at_least": share}
    return {"type": "clear" if condition.supports == "clear" else "touched", "group": group}
