"""The plan into operations of drives."""

from __future__ import annotations

from gantline.assembly.parts import Json
from gantline.assembly.plain import drum_drive
from gantline.assembly.water import pump_drive
from gantline.assembly.yard import hoist_drive
from gantline.scenario import Rigging, Scenario
from gantline.scenario.condition import Condition
from gantline.scenario.hooks import full_name
from gantline.scenario.movers import Mover, mover
from gantline.scenario.plan import HoldStep, LowerStep, MovingStep, PayOutStep, PumpStep, Step
from gantline.scenario.reeving import hoist_ropes
from gantline.scenario.tanks import ends_of_pump, tanks_of

__all__ = [
    "along_drive",
    "emergency_stop",
    "luff_drive",
    "moved_drives",
    "operations",
    "slew_drive",
    "turned_drive",
]

#: Within this a motor is asked to stop in an emergency [s]; brakes slip far longer.
_AT_ONCE = 1e-3
#: Within this pumps come to their rate, and to rest [s].
_PUMPS_START = 10.0


def along_drive(name: str) -> str:
    """Name of the drive of a trolley along its girder, or of a crane along its rails."""
    return f"{name}.along"


def luff_drive(boom: str) -> str:
    """Name of the drive that luffs a boom."""
    return f"{boom}.luff"


def slew_drive(upper: str) -> str:
    """Name of the drive that slews an upper structure."""
    return f"{upper}.slew"


def turned_drive(upper: str) -> str:
    """Name of the drive that turns hook blocks along with an upper structure."""
    return f"{upper}/turned.slew"


def operations(scenario: Scenario, rigging: Rigging, weight: float) -> list[Json]:
    """Steps of the document; `weight` is what the load weighs as it is simulated [N]."""
    found = []
    for place, step in enumerate(scenario.plan):
        if isinstance(step, HoldStep):
            made = _hold(step)
        elif isinstance(step, PumpStep):
            made = _pumping(scenario, step)
        else:
            made = _moving(scenario, step)
        if step.until is not None:
            down = isinstance(step, (LowerStep, PayOutStep))
            made["until"] = _condition(scenario, rigging, step.until, weight, down=down)
        if place == 0 and made["start_at"] is None:
            made["start_at"] = 0.0
        found.append(made)
    return found


def moved_drives(scenario: Scenario, step: Step) -> list[str]:
    """Names of the drives that a step moves."""
    if isinstance(step, PumpStep):
        return [pump_drive(name) for name in ends_of_pump(scenario, step) if name is not None]
    if isinstance(step, HoldStep):
        return []
    return [drive for one in _moved(scenario, step) for drive in _drives(one)]


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
        if isinstance(step, PumpStep):
            slowing = {"acceleration": step.rate / _PUMPS_START, "brake": None}
            for drive in moved_drives(scenario, step):
                stopped[drive] = {"drive": drive, "stop": slowing}
        for one in _moved(scenario, step) if isinstance(step, MovingStep) else ():
            for drive in _drives(one):
                stopped[drive] = {"drive": drive, "stop": _stop(one, one.speed)}
    return {"at": at, "drives": list(stopped.values())}


def _drives(one: Mover) -> list[str]:
    if one.kind == "upper":
        return [slew_drive(one.name), turned_drive(one.name)]
    if one.kind == "hook":
        return [hoist_drive(one.name)]
    if one.kind == "boom":
        return [luff_drive(one.name)]
    return [drum_drive(one.name) if one.kind == "drum" else along_drive(one.name)]


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


def _pumping(scenario: Scenario, step: PumpStep) -> Json:
    """What one tank loses the other gets, by drives that move alike and so keep the sum to the last bit."""
    tanks, moves = tanks_of(scenario), []
    for name, sign in zip(ends_of_pump(scenario, step), (-1.0, 1.0), strict=True):
        if name is None:
            continue
        tank = tanks[name]
        moves.append(
            {
                "drive": pump_drive(name),
                "velocity": sign * step.rate,
                "acceleration": step.rate / _PUMPS_START,
                "shape": "linear",
                "range": [-tank.content, tank.capacity - tank.content],
            }
        )
    made: Json = {"name": step.step, "moves": moves, "start_at": step.start_at, "until": {}}
    if step.starts == "with_previous":
        made["with_previous"] = True
    if step.by is not None:
        made["until"] = {"type": "along", "distance": step.by}
    return made


def _moving(scenario: Scenario, step: MovingStep) -> Json:
    moved = [(one, drive) for one in _moved(scenario, step) for drive in _drives(one)]
    moves = [
        {
            "drive": drive,
            "velocity": step.sign * step.speed,
            "acceleration": step.acceleration if step.acceleration is not None else one.acceleration,
            "shape": "linear",
            **({} if step.emergency_stop_at is None else {"emergency": _stop(one, step.speed)}),
        }
        for one, drive in moved
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
        made["until"] = {"type": "position", "positions": [to - one.zero for one, _ in moved]}
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
    for angle in ("heel", "trim"):
        reached = getattr(condition, angle)
        if reached is not None:
            above = reached.above is not None
            bound = reached.above if above else reached.below
            return {
                "type": "attitude",
                "body": reached.vessel,
                "angle": angle,
                "above": above,
                "bound": bound,
            }
    assert scenario.load is not None  # checked when the file was read
    group = scenario.load.name
    if condition.load_transferred is not None:
        share = condition.load_transferred
        if down:
            return {"type": "load_returned", "group": group, "weight": weight, "at_most": share}
        return {"type": "load_transferred", "group": group, "weight": weight, "at_least": share}
    return {"type": "clear" if condition.supports == "clear" else "touched", "group": group}
