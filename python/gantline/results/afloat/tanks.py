"""Contents of tanks over time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results.rig import Load, Rig
from gantline.results.variable import Columns, FloatArray, Names, Variable
from gantline.units import format_quantity

__all__ = ["Ran", "hole_warnings", "pump_warnings", "ran_through_holes", "tank_contents", "weight_of"]

#: Share of its capacity within which a tank is empty or full.
_ROUNDING = 1e-9
#: Share of its capacity within which a tank has come to what is in it in the end.
_SETTLED = 1e-3
#: Share of a run at its end, in halves of which contents are compared.
_LAST = 0.05
#: By what they differ if liquid still runs: share of all that has run, and of the capacity at least.
_OF_CHANGE, _OF_CAPACITY = 0.005, 1e-5


def tank_contents(
    columns: Columns, names: Names, rig: Rig
) -> tuple[Columns, Names, dict[str, Variable], dict[str, Sequence[str]]]:
    """Contents of all tanks as a variable.

    Args:
        columns: columns of the core by name.
        names: names along their dimensions.
        rig: the lift.

    Returns:
        Columns and names without the joints that contents are for the core, and with `tank_content` where
        there are tanks; this as a variable, and the names of tanks.
    """
    if not rig.tanks:
        return columns, names, {}, {}
    content = np.stack([_content(columns, names, tank.name, tank.content) for tank in rig.tanks], axis=1)
    variable = Variable(("time", "tank"), content, "kg", "mass of the liquid in a tank")
    pumped = {_joint(tank.name) for tank in rig.tanks}
    kept = [place for place, joint in enumerate(names["joint"]) if joint not in pumped]
    columns = {**columns, "joint_position": columns["joint_position"][:, kept], "tank_content": content}
    tanks = [tank.name for tank in rig.tanks]
    names = {**names, "joint": [names["joint"][place] for place in kept], "tank": tanks}
    return columns, names, {"tank_content": variable}, {"tank": tanks}


def weight_of(columns: Columns, names: Names, rig: Rig, load: Load) -> FloatArray:
    """What a load weighs with what is in its tanks [N], shape (time,); of columns with `tank_content`."""
    weight = np.full(len(columns["time"]), load.weight)
    for tank in load.tanks:
        weight += rig.gravity * columns["tank_content"][:, list(names["tank"]).index(tank)]
    return weight


def pump_warnings(rig: Rig, columns: Columns, names: Names) -> list[str]:
    """Steps whose pumps stopped since a tank was empty or full."""
    warnings = []
    events = zip(columns["event_time"], names["event_kind"], names["event_name"], strict=True)
    for moment, kind, step in events:
        if kind != "pump_stopped":
            continue
        after = min(int(np.searchsorted(columns["time"], moment)), len(columns["time"]) - 1)
        states = []
        for tank in rig.tanks:
            content = _content(columns, names, tank.name, tank.content)[after] if after >= 0 else tank.content
            if tank.name in _pumped_by(rig, step) and content <= _ROUNDING * tank.capacity:
                states.append(f"{tank.name} is empty")
            elif tank.name in _pumped_by(rig, step) and content >= (1 - _ROUNDING) * tank.capacity:
                states.append(f"{tank.name} is full")
        because = " and ".join(states) or "a tank is empty or full"
        warnings.append(f"the pumps of '{step}' stop at {moment:.2f} s before it is done: {because}")
    return warnings


@dataclass(frozen=True)
class Ran:
    """What has run through the holes of a tank.

    Attributes:
        tank: Its full name.
        first: Mass of the liquid in it at the start [kg].
        last: The same at the end [kg].
        until: When it came to that, to a thousandth of what the tank holds [s].
        goes_on: Whether it still changed at the end.
    """

    tank: str
    first: float
    last: float
    until: float
    goes_on: bool


def ran_through_holes(rig: Rig, time: FloatArray, contents: Mapping[str, FloatArray]) -> list[Ran]:
    """What has run through holes of tanks, for each that has some.

    Args:
        rig: the lift.
        time: of the samples [s], shape (time,).
        contents: of tanks by their full names [kg], each of shape (time,).
    """
    found = []
    for tank in rig.tanks if len(time) else ():
        if not tank.holes:
            continue
        content = contents[tank.name]
        other = np.abs(content - content[-1]) > _SETTLED * tank.capacity
        after = min(int(np.flatnonzero(other)[-1]) + 1, len(time) - 1) if other.any() else 0
        ends = float(content[0]), float(content[-1])
        goes_on = _still_runs(time, content, tank.capacity)
        found.append(Ran(tank.name, *ends, until=float(time[after]), goes_on=goes_on))
    return found


def _still_runs(time: FloatArray, content: FloatArray, capacity: float) -> bool:
    """Whether the mean content still goes one way at the end: a vessel that rolls moves some to and fro.

    It is held against what has run so far: a small hole of a large tank may go on for hours.
    """
    before = time[-1] - _LAST * np.array([1.0, 0.5]) * (time[-1] - time[0])
    means = [
        content[part].mean()
        for part in ((time >= before[0]) & (time < before[1]), time >= before[1])
        if part.any()
    ]
    least = max(_OF_CHANGE * float(np.ptp(content)), _OF_CAPACITY * capacity)
    return float(np.ptp(means)) > least


def hole_warnings(rig: Rig, columns: Columns, names: Names) -> list[str]:
    """Tanks that still drain or flood as a run ends."""
    contents = {tank.name: _content(columns, names, tank.name, tank.content) for tank in rig.tanks}
    warnings = []
    for ran in ran_through_holes(rig, columns["time"], contents):
        if ran.goes_on:
            now, then = (format_quantity(one, "t", 1) for one in (ran.last, ran.first))
            sentence = f"as the run ends liquid still runs through the holes of {ran.tank}"
            warnings.append(f"{sentence}: {now} are in it, of {then} at the start; let the run last longer")
    return warnings


def _pumped_by(rig: Rig, step: str) -> set[str]:
    return {tank for one in rig.plan if one.step == step for tank in one.tanks}


def _content(columns: Columns, names: Names, tank: str, start: float) -> FloatArray:
    """Mass in a tank (time,)."""
    joints = list(names["joint"])
    if _joint(tank) not in joints:
        return np.full(len(columns["time"]), start)
    pumped: FloatArray = columns["joint_position"][:, joints.index(_joint(tank))]
    return start + pumped


def _joint(tank: str) -> str:
    """The joint that the content of a tank is for the core."""
    return f"{tank}/content"
