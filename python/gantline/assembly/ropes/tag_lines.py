"""Tag lines into ropes: made fast, or on a tugger of constant pull."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gantline.assembly.afloat.moorings import warn_of_hauled, winch_drive
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.loads.underground import under_ground
from gantline.assembly.parts import Json, Parts, end, material
from gantline.assembly.ropes.route import most_strain, taut_length, too_far
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.gear import RopeMaterial
from gantline.scenario.plan.parting import partings, steps_that_cut
from gantline.scenario.tag_line import TUGGER_MASS, TUGGER_SPEED, TagLine, tag_rope, tag_tugger
from gantline.units import format_by_size, format_quantity

__all__ = ["add_tag_lines", "line_drive", "tag_rig"]

#: Ends that are no farther apart are in one place [m]; a load that stands sinks in by less.
_ONE_PLACE = 1e-3
#: Time in which a tugger comes to its speed [s].
_STARTS_IN = 1.0
#: People and tuggers stand near, haul by some metres in a second and move little with the rope; beyond this
#: a unit has slipped [m], [m/s], [kg].
_LONGEST, _FASTEST, _HEAVIEST = 1000.0, 10.0, 10e3


def add_tag_lines(parts: Parts, scenario: Scenario, lifted: LiftedLoad) -> None:
    """Add tag lines; the load and all bodies that hold them are there.

    Raises:
        ScenarioError: if a line is too short for where the load is at the start, or pulls more than it holds.
    """
    assert scenario.load is not None
    for name, line in (scenario.tag_lines or {}).items():
        kind = (scenario.ropes or {})[line.rope]
        _check_pull(scenario, name, line, kind)
        at = (np.array(line.at) - lifted.centre).tolist()
        places = parts.place(scenario.load.name, at), parts.place(line.holder, line.to)
        chord = float(np.linalg.norm(places[0] - places[1]))
        parts.doubts += [*_doubtful(name, line, chord), *_under_ground(scenario, name, line, places[1][2])]
        length = _length(scenario, name, line, chord, kind)
        drum = None
        if line.pull is not None or line.winch is not None:
            _add_winch(parts, name, line)
            warn_of_hauled(parts, scenario, tag_rope(name), length)
            drum = (tag_tugger(name), 1.0)
        route = [end(scenario.load.name, at), end(line.holder, line.to, drum, laid_under=line.pull)]
        parts.add_rope(tag_rope(name), length, material(kind), route)


def _check_pull(scenario: Scenario, name: str, line: TagLine, kind: RopeMaterial) -> None:
    """What is asked for must not break it."""
    pull, key = (line.pull, "pull") if line.pull is not None else (line.pretension, "pretension")
    known = (partings(scenario)[tag_rope(name)].breaks_at, kind.breaking_force)
    limits = [limit for limit in known if limit is not None]
    if pull is not None and limits and pull >= min(limits):
        sentence = f"{pull / 1e3:g} kN are more than it holds, {min(limits) / 1e3:.4g} kN"
        raise scenario.error(("tag_lines", name, key), f"{sentence}; pull less")


def _doubtful(name: str, line: TagLine, chord: float) -> Iterator[Doubt]:
    """What cannot well be meant of a line whose ends are `chord` [m] apart at the start."""
    if chord > _LONGEST:
        sentence = f"tag line {name} is {chord:,.0f} m long at the start; a unit has slipped, m for mm"
        yield Doubt(("tag_lines", name), sentence)
    if line.speed is not None and line.speed > _FASTEST:
        speed = format_quantity(line.speed, "m/s", 0)
        sentence = f"tag line {name} is hauled in at up to {speed}; a unit has slipped, m/s for m/min"
        yield Doubt(("tag_lines", name, "speed"), sentence)
    if line.rotating_mass is not None and line.rotating_mass > _HEAVIEST:
        mass = format_by_size(line.rotating_mass, "mass")
        sentence = f"what moves with tag line {name} weighs {mass}; a unit has slipped, t for kg"
        yield Doubt(("tag_lines", name, "rotating_mass"), sentence)


def _under_ground(scenario: Scenario, name: str, line: TagLine, height: float) -> list[Doubt]:
    """What is said of a line that is held in the yard at this height [m], under what one stands on there."""
    if line.holder is not None:
        return []
    found = under_ground(scenario, (line.to[0], line.to[1], height))
    sentence = f"tag line {name} is held {found}: 'to' is a place in the world"
    return [Doubt(("tag_lines", name, "to"), sentence)] if found else []


def _length(scenario: Scenario, name: str, line: TagLine, chord: float, kind: RopeMaterial) -> float:
    """Unstretched length at first [m], for ends that are `chord` [m] apart; `kind` stretches."""
    if chord < _ONE_PLACE:
        sentence = "is where it is made fast to the load; a line has two ends"
        raise scenario.start_error(("tag_lines", name, "to"), sentence)
    if line.pull is not None:
        return taut_length(chord, line.pull, kind)
    if line.pretension is not None:
        return taut_length(chord, line.pretension, kind)
    length = line.length if isinstance(line.length, float) else chord
    if chord > length * (1 + most_strain(kind)):
        sentence = f"the line is {length:g} m, but its ends are {chord:.6g} m apart at the start"
        sentence = f"{sentence}: {too_far(chord, length, most_strain(kind))}; make it longer"
        raise scenario.start_error(("tag_lines", name, "length"), sentence)
    return length


def _add_winch(parts: Parts, name: str, line: TagLine) -> None:
    """What pays the line out: a winch that the plan moves, or a tugger.

    A tugger asks for its speed of hauling in all the time, with a motor that pulls no more than the line's
    pull: it hauls while the rope pulls less and gives way to more.
    """
    drive, capacity = line_drive(tag_rope(name)), line.pull
    ramps = []
    if line.pull is not None:
        velocity = -(line.speed or TUGGER_SPEED)
        ramps = [{"at": 0.0, "duration": _STARTS_IN, "velocity": velocity, "shape": "linear"}]
    elif line.winch is not None:
        capacity = line.winch.capacity
    parts.add_drive(drive, ramps)
    motor = {} if capacity is None else {"capacity": capacity, "keeps_pull": line.pull is not None}
    parts.add_flow(tag_tugger(name), line.rotating_mass or TUGGER_MASS, drive=drive, **motor)


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
            "speed": None if line.pull is None else line.speed or TUGGER_SPEED,
            "let_go_in": steps_that_cut(scenario, tag_rope(name)),
        }
        for name, line in (scenario.tag_lines or {}).items()
    ]
    return {"tag_lines": lines} if lines else {}
