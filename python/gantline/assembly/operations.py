"""The plan into operations of drives."""

from __future__ import annotations

from gantline.assembly.parts import Json
from gantline.assembly.plain import drum_drive
from gantline.assembly.yard import hoist_drive
from gantline.scenario import Scenario
from gantline.scenario.plan import DrumStep, HoldStep, HookStep, MovingStep, Step

__all__ = ["moved_drives", "operations"]

#: Within this a motor is asked to stop in an emergency [s]; brakes slip far longer.
_AT_ONCE = 1e-3


def operations(scenario: Scenario, weight: float) -> list[Json]:
    """Steps of the document; `weight` is what the load weighs as it is simulated [N]."""
    return [_operation(scenario, step, place, weight) for place, step in enumerate(scenario.plan)]


def moved_drives(step: Step) -> list[str]:
    """Names of the drives that a step moves."""
    if isinstance(step, HookStep):
        return [hoist_drive(hook) for hook in step.hooks]
    if isinstance(step, DrumStep):
        return [drum_drive(drum) for drum in step.drums]
    return []


def _operation(scenario: Scenario, step: Step, place: int, weight: float) -> Json:
    if isinstance(step, HoldStep):
        until = (
            {"type": "end_of_run"}
            if isinstance(step.hold, str)
            else {"type": "duration", "duration": step.hold}
        )
        return {"name": step.step, "moves": [], "start_at": 0.0 if place == 0 else None, "until": until}
    moves = [
        {
            "drive": drive,
            "velocity": step.direction * step.speed,
            "acceleration": step.acceleration if step.acceleration is not None else most,
            "shape": "linear",
            **emergency,
        }
        for drive, most, emergency in zip(
            moved_drives(step), _accelerations(scenario, step), _emergencies(scenario, step), strict=True
        )
    ]
    start = step.start_at if step.start_at is not None or place > 0 else 0.0
    return {
        "name": step.step,
        "moves": moves,
        "start_at": start,
        "until": _until(scenario, step, weight),
    }


def _accelerations(scenario: Scenario, step: MovingStep) -> list[float]:
    """Highest acceleration of each drive that a step moves [m/s^2]."""
    if isinstance(step, HookStep):
        return [(scenario.cranes or {})[hook].hoist.acceleration for hook in step.hooks]
    assert isinstance(step, DrumStep) and scenario.mechanics is not None  # checked when the file was read
    drives = [(scenario.mechanics.drums or {})[drum].drive for drum in step.drums]
    return [drive.acceleration for drive in drives if drive is not None]


def _emergencies(scenario: Scenario, step: MovingStep) -> list[Json]:
    """How each drive that a step moves is stopped in an emergency; nothing in a step without."""
    if step.emergency_stop_at is None:
        return [{} for _ in _accelerations(scenario, step)]
    brakes: list[float | None] = []
    if isinstance(step, HookStep):
        for name in step.hooks:
            crane = (scenario.cranes or {})[name]
            parts = crane.reeving.parts if crane.reeving is not None else 1
            brakes.append(None if crane.hoist.brake is None else crane.hoist.brake * parts)
    elif isinstance(step, DrumStep):
        assert scenario.mechanics is not None  # checked when the file was read
        drives = [(scenario.mechanics.drums or {})[drum].drive for drum in step.drums]
        brakes = [drive.brake for drive in drives if drive is not None]
    at_once = step.speed / _AT_ONCE
    return [{"emergency": {"acceleration": at_once, "brake": brake}} for brake in brakes]


def _until(scenario: Scenario, step: MovingStep, weight: float) -> Json:
    at = step.brake_from if step.brake_from is not None else step.emergency_stop_at
    if at is not None:
        return {"type": "brake_from", "time": at}
    if step.by is not None:
        return {"type": "distance", "distance": step.direction * step.by}
    assert step.until is not None and scenario.load is not None  # checked when the file was read
    group = scenario.load.name
    if step.until.load_transferred is not None:
        share = step.until.load_transferred
        return {"type": "load_transferred", "group": group, "weight": weight, "at_least": share}
    return {"type": "clear", "group": group}
