"""The plan into operations of drives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gantline.assembly.afloat.water import pump_drive
from gantline.assembly.cranes.chain_hoists import chain_drive
from gantline.assembly.parts import Json, Parts
from gantline.assembly.plain import drum_drive
from gantline.assembly.plan.conditions import condition_of
from gantline.assembly.plan.followed import followed
from gantline.assembly.plan.led import leading
from gantline.assembly.ropes.tag_lines import line_drive
from gantline.assembly.yard import hoist_drive
from gantline.scenario import Rigging, Scenario
from gantline.scenario.afloat.tanks import contents_of_load, ends_of_pump, tanks_of
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import movers_of_lead
from gantline.scenario.plan.movers import Mover, mover
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.positions import Places, boom_angles, boom_angles_at_end, places_of_cranes
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import AlongStep, HoldStep, LowerStep, MovingStep, PayOutStep, PumpStep

__all__ = [
    "along_drive",
    "drives_of",
    "emergency_stop",
    "luff_drive",
    "moved_drives",
    "operations",
    "reel_of",
    "slew_drive",
    "stop_of",
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


def operations(scenario: Scenario, rigging: Rigging, parts: Parts) -> list[Json]:
    """Steps of the document."""
    found = []
    mass = 0.0 if scenario.load is None else parts.bodies[scenario.load.name]["mass"]
    contents = contents_of_load(scenario)
    cranes = places_of_cranes(scenario)
    angles = zip(boom_angles(scenario), boom_angles_at_end(scenario), strict=True)
    each = zip(scenario.plan, angles, slings_on(scenario), strict=True)
    for place, (step, (before, after), on) in enumerate(each):
        if isinstance(step, HoldStep):
            made = _hold(step)
        elif isinstance(step, PumpStep):
            made = _pumping(scenario, step)
        elif isinstance(step, LeadStep):
            made = _leading(scenario, place, step, cranes[place])
        else:
            made = _moving(scenario, step, before, after)
        if isinstance(step, AlongStep) and step.keep_plumb:
            made["until"] = followed(scenario, rigging, parts, step, step.keep_plumb)
        if step.until is not None:
            # Known where a step waits for a share of it, see `gantline.scenario.consistency.pumps`.
            weight = (mass + contents[place].least) * scenario.simulation.gravity
            down = isinstance(step, (LowerStep, PayOutStep))
            made["until"] = condition_of(scenario, rigging, parts, step.until, weight, down=down, on=on)
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
    if isinstance(step, LeadStep):
        return [drive for one in movers_of_lead(scenario, step) for drive in drives_of(one)]
    return [drive for one in _moved(scenario, step) for drive in drives_of(one)]


def emergency_stop(scenario: Scenario) -> Json | None:
    """The emergency stop of the document, of all that the plan moves; None without one."""
    stop = scenario.emergency_stop
    if stop is None:
        return None
    at: Json = {"type": "time", "time": stop.at}
    if stop.in_step is not None:
        place = [step.step for step in scenario.plan].index(stop.in_step)
        at = {"type": "in_step", "step": place, "after": stop.after or 0.0}
    stopped: dict[str, list[Json]] = {}
    for place, (step, before) in enumerate(zip(scenario.plan, boom_angles(scenario), strict=True)):
        for drive, how in _stops(scenario, step, before):
            known = stopped.setdefault(drive, [])
            if not known or known[-1]["stop"] != how:
                known.append({"drive": drive, "stop": how, "step": place if known else 0})
    return {"at": at, "drives": [one for of_drive in stopped.values() for one in of_drive]}


def _stops(
    scenario: Scenario, step: Step, before: Mapping[str, tuple[float, bool]]
) -> Iterator[tuple[str, Json]]:
    """The drives that a step moves, each with how an emergency stop of everything stops it from then on."""
    if isinstance(step, PumpStep):
        slowing = {"acceleration": step.rate / _PUMPS_START, "brake": None}
        yield from ((drive, slowing) for drive in moved_drives(scenario, step))
    if isinstance(step, LeadStep):
        for one in movers_of_lead(scenario, step):
            stop = stop_of(one, one.speed, _rate(one, before, None))
            yield from ((drive, stop) for drive in drives_of(one))
    if not isinstance(step, MovingStep):
        return
    for one in _moved(scenario, step):
        rate = _rate(one, before, _target(step, one, before))
        yield from ((drive, stop_of(one, one.speed, rate)) for drive in drives_of(one))


def drives_of(one: Mover) -> list[str]:
    """Names of the drives that move something, all alike."""
    if one.kind == "upper":
        return [slew_drive(one.name), turned_drive(one.name)]
    if one.kind == "hook":
        return [hoist_drive(one.name)]
    if one.kind == "boom":
        return [luff_drive(one.name)]
    if one.kind == "line":
        return [line_drive(one.name)]
    if one.kind == "sling":
        return [chain_drive(one.name.removeprefix("sling."))]
    return [drum_drive(one.name) if one.kind == "drum" else along_drive(one.name)]


def _moved(scenario: Scenario, step: MovingStep) -> list[Mover]:
    found = [mover(scenario, step.kind, text) for text in step.moved]
    return [one for one in found if one is not None]


def stop_of(one: Mover, speed: float, rate: float = 1.0) -> Json:
    """How a drive at a speed is stopped in an emergency; `rate` is from words of the plan to the drive."""
    acceleration = speed / _AT_ONCE if one.capacity or one.emergency is None else one.emergency
    return {"acceleration": acceleration * rate, "brake": one.brake}


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


def _leading(scenario: Scenario, place: int, step: LeadStep, before: Places) -> Json:
    """Drives of several cranes that go the way of a load together."""
    found = leading(scenario, place, before)
    moves = [
        # What a drive may do has been looked at along the way; it does what its series says.
        {"drive": drive, "velocity": 1.0, "acceleration": 1.0, "shape": "linear"}
        for one in found.movers
        for drive in drives_of(one)
    ]
    series = [one for mover, one in zip(found.movers, found.series, strict=True) for _ in drives_of(mover)]
    until = {"type": "leading", "rate": found.rate, "acceleration": found.acceleration, "series": series}
    made: Json = {"name": step.step, "moves": moves, "start_at": step.start_at, "until": until}
    if step.starts == "with_previous":
        made["with_previous"] = True
    return made


def _moving(
    scenario: Scenario,
    step: MovingStep,
    before: Mapping[str, tuple[float, bool]],
    after: Mapping[str, tuple[float, bool]],
) -> Json:
    """A step; where booms are at its start and its end, see `boom_angles`."""
    moved = [(one, drive) for one in _moved(scenario, step) for drive in drives_of(one)]
    targets = [_target(step, one, before) for one, _ in moved]
    moves = []
    for (one, drive), target in zip(moved, targets, strict=True):
        rate = _rate(one, before, target)
        acceleration = step.acceleration if step.acceleration is not None else one.acceleration
        moves.append(
            {
                "drive": drive,
                "velocity": step.sign * step.speed * rate,
                "acceleration": acceleration * rate,
                "shape": "linear",
                **_range_to_keep(step, one),
                **reel_of(one),
                **({} if step.emergency_stop_at is None else {"emergency": stop_of(one, step.speed, rate)}),
            }
        )
    made: Json = {"name": step.step, "moves": moves, "start_at": step.start_at, "until": {}}
    if step.starts == "with_previous":
        made["with_previous"] = True
    at = step.brake_from if step.brake_from is not None else step.emergency_stop_at
    if at is not None:
        made["until"] = {"type": "brake_from", "time": at}
    elif step.by is not None and not any(one.gear for one, _ in moved):
        made["until"] = {"type": "distance", "distance": step.sign * step.by}
    elif any(target is not None for target in targets):
        positions = [
            (one.gear.taken_up(target) if one.gear is not None else target - one.zero - _head_up(one, after))
            for (one, _), target in zip(moved, targets, strict=True)
            if target is not None
        ]
        made["until"] = {"type": "position", "positions": positions}
    return made


def reel_of(one: Mover) -> Json:
    """Layers on the drum of a hook: ways and heights of the plan are those of the hook on any of them."""
    reel = one.reel
    if reel is None:
        return {}
    layers = {"radius": reel.radius, "step": reel.step, "turns": reel.turns, "start": reel.start}
    return {"reel": {"rate": float(reel.parts), "layers": layers}}


def _range_to_keep(step: MovingStep, one: Mover) -> Json:
    """Where a drive may go that finds its own way."""
    if not getattr(step, "keep_plumb", None) or one.range is None:
        return {}
    if one.gear is not None:
        return {"range": [one.gear.taken_up(end) for end in one.range]}
    return {"range": [end - one.zero for end in one.range]}


def _target(step: MovingStep, one: Mover, before: Mapping[str, tuple[float, bool]]) -> float | None:
    """Where a step brings what it moves, as `to` counts it; None where that is not known."""
    to: float | None = getattr(step, "to", None)
    if to is None and step.by is not None and one.name in before:
        return before[one.name][0] + step.by
    return to


def _head_up(one: Mover, after: Mapping[str, tuple[float, bool]]) -> float:
    """How far the boom head of a hook has gone up since the start where a step ends [m]."""
    return 0.0 if one.head is None else one.head.rise(after[one.head.boom][0])


def _rate(one: Mover, before: Mapping[str, tuple[float, bool]], target: float | None) -> float:
    """What the drive does for one unit of the plan: 1, or of a boom in tackles rope for each angle [m/rad].

    Over the way of the step in the mean, so that it takes as long as it says; where it does not know its end
    at the last angle that the plan has said, where it does not know its start at the end.
    """
    if one.gear is None:
        return 1.0
    angle, known = before[one.name]
    first = angle if known or target is None else target
    return one.gear.rate(first, first if target is None else target)
