"""Tag lines into ropes: made fast, or on a tugger of constant pull."""

from __future__ import annotations

import numpy as np

from gantline.assembly.lifted import LiftedLoad
from gantline.assembly.moorings import winch_drive
from gantline.assembly.parts import Json, Parts, end, material
from gantline.assembly.route import MOST_STRAIN, taut_length, too_far
from gantline.scenario import Scenario
from gantline.scenario.errors import PathPart
from gantline.scenario.parting import partings
from gantline.scenario.tag_line import TUGGER_MASS, TUGGER_SPEED, TagLine, tag_rope, tag_tugger

__all__ = ["add_tag_lines", "line_drive", "tag_rig"]

#: Ends that are no farther apart are in one place [m]; a load that stands sinks in by less.
_ONE_PLACE = 1e-3
#: Time in which a tugger comes to its speed [s].
_STARTS_IN = 1.0
#: Of the distance at the start, the length of a line before the rest in which a run begins: its tugger gives
#: way there until it pulls as it shall, wherever that rest has the load.
_HAULED = 0.5


def add_tag_lines(parts: Parts, scenario: Scenario, lifted: LiftedLoad) -> None:
    """Add tag lines; the load and all bodies that hold them are there.

    A tugger asks for its speed of hauling in with a motor that pulls no more than the line's pull: it hauls
    while the rope pulls less and gives way to more.

    Raises:
        ScenarioError: if a line is too short for where the load is at the start, or pulls more than it holds.
    """
    assert scenario.load is not None
    kinds, parting = scenario.ropes or {}, partings(scenario)
    for name, line in (scenario.tag_lines or {}).items():
        path: tuple[PathPart, ...] = ("tag_lines", name)
        kind = kinds[line.rope]
        assert kind.stiffness is not None  # checked when the file was read
        pull, key = (line.pull, "pull") if line.pull is not None else (line.pretension, "pretension")
        limits = [
            limit for limit in (parting[tag_rope(name)].breaks_at, kind.breaking_force) if limit is not None
        ]
        if pull is not None and limits and pull >= min(limits):
            sentence = f"{pull / 1e3:g} kN are more than it holds, {min(limits) / 1e3:.4g} kN"
            raise scenario.error((*path, key), f"{sentence}; pull less")
        at = (np.array(line.at) - lifted.centre).tolist()
        holder = None if line.held_by == "world" else line.held_by
        chord = float(np.linalg.norm(parts.place(scenario.load.name, at) - parts.place(holder, line.to)))
        if chord < _ONE_PLACE:
            raise scenario.start_error(
                (*path, "to"), "is where it is made fast to the load; a line has two ends"
            )
        drum = (tag_tugger(name), 1.0) if line.pull is not None or line.winch is not None else None
        if line.pull is not None:
            _add_tugger(parts, name, line, line.pull)
            length = taut_length(chord, line.pull, kind.stiffness)
            length *= _HAULED if scenario.starts_at_rest else 1.0
        elif line.pretension is not None:
            length = taut_length(chord, line.pretension, kind.stiffness)
        else:
            length = line.length if isinstance(line.length, float) else chord
            if chord > length * (1 + MOST_STRAIN):
                sentence = f"the line is {length:g} m, but its ends are {chord:.6g} m apart at the start"
                raise scenario.start_error(
                    (*path, "length"), f"{sentence}: {too_far(chord, length)}; make it longer"
                )
        if line.winch is not None:
            parts.add_drive(line_drive(tag_rope(name)))
            motor = {} if line.winch.capacity is None else {"capacity": line.winch.capacity}
            parts.add_flow(tag_tugger(name), TUGGER_MASS, drive=line_drive(tag_rope(name)), **motor)
        route = [end(scenario.load.name, at), end(holder, line.to, drum, laid_under=line.pull)]
        parts.add_rope(tag_rope(name), length, material(kind.stiffness, kind.damping_time), route)


def _add_tugger(parts: Parts, name: str, line: TagLine, pull: float) -> None:
    """Its flow, which hauls in all the time."""
    drive = line_drive(tag_rope(name))
    speed = -(line.speed or TUGGER_SPEED)
    parts.add_drive(drive, [{"at": 0.0, "duration": _STARTS_IN, "velocity": speed, "shape": "linear"}])
    parts.add_flow(tag_tugger(name), line.rotating_mass or TUGGER_MASS, drive=drive, capacity=pull)


def line_drive(line: str) -> str:
    """Name of the drive that moves a mooring line by its name, or a tag line by that of its rope."""
    name = line.removeprefix(tag_rope(""))
    return winch_drive(line) if name == line else f"{tag_tugger(name)}.drive"


def tag_rig(scenario: Scenario) -> Json:
    """What results need to know of tag lines; nothing in a lift without."""
    lines = [
        {
            "name": name,
            "rope": tag_rope(name),
            "pull": line.pull,
            "slipping_winch": tag_tugger(name) if line.winch is not None and line.winch.capacity else None,
        }
        for name, line in (scenario.tag_lines or {}).items()
    ]
    return {"tag_lines": lines} if lines else {}
