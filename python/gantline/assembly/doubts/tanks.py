"""What cannot well be meant of tanks: two in one place, and pumps faster than any."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping

from gantline.assembly.afloat.hulls import afloat_path
from gantline.scenario import Scenario
from gantline.scenario.afloat.tanks import bodies_afloat, has_sea, hole_turns, holed_tanks
from gantline.scenario.afloat.water import BallastTank
from gantline.scenario.errors import Doubt, PathPart
from gantline.scenario.plan.steps import PumpStep
from gantline.units import format_quantity

__all__ = ["doubtful_tanks"]

#: Share of the smaller of two tanks that may be in the other one, by rounding of their places.
_SHARED = 0.01
#: The largest ballast systems of crane vessels pump a third of this [kg/s].
_PUMPED = 6e4 * 1e3 / 3600.0


def doubtful_tanks(scenario: Scenario) -> Iterator[Doubt]:
    """What is doubtful about the tanks of each vessel and of the load, and about pumps."""
    for name, vessel in (scenario.vessels or {}).items():
        yield from _in_one_place(afloat_path(scenario, name), name, vessel.tanks)
    load = scenario.load
    if load is not None:
        yield from _in_one_place(("load",), load.name, load.tanks)
    if load is not None and load.in_water is None and has_sea(scenario):
        for name, tank in (load.tanks or {}).items():
            if tank.holes:
                sentence = (
                    f"water runs through the holes of {load.name}.{name}, but carries nothing of {load.name}"
                )
                yield Doubt(("load", "tanks", name, "holes"), f"{sentence}: give the load 'in_water'")
    yield from _of_holes(scenario)
    for place, step in enumerate(scenario.plan):
        if isinstance(step, PumpStep) and step.rate > _PUMPED:
            sentence = f"step '{step.step}' pumps {step.rate * 3.6:,.0f} t in an hour"
            yield Doubt(("plan", place, "rate"), f"{sentence}, more than any ballast system: see its unit")


def _of_holes(scenario: Scenario) -> Iterator[Doubt]:
    """Holes that nothing opens, and those in waves."""
    turns = hole_turns(scenario)
    for body, path, tanks in _with_holes(scenario):
        for name, tank in tanks.items():
            for own, hole in (tank.holes or {}).items():
                if hole.closed and not turns[f"{body}.{name}.{own}"]:
                    sentence = f"the hole {own} of {body}.{name} is closed, and no step opens it"
                    yield Doubt((*path, "tanks", name, "holes", own), f"{sentence}: it lets nothing pass")
    if scenario.waves and (holed := list(holed_tanks(scenario))):
        sentence = f"the holes of {', '.join(holed)} feel still water: waves run past them"
        yield Doubt(("waves",), f"{sentence}, and only the motion of what has them counts")


def _with_holes(
    scenario: Scenario,
) -> Iterator[tuple[str, tuple[PathPart, ...], Mapping[str, BallastTank]]]:
    """All that has tanks: its name, where the lift file has it, its tanks."""
    for name, body in bodies_afloat(scenario).items():
        yield name, afloat_path(scenario, name), body.tanks or {}
    if scenario.load is not None:
        yield scenario.load.name, ("load",), scenario.load.tanks or {}


def _in_one_place(
    path: tuple[PathPart, ...], name: str, tanks: Mapping[str, BallastTank] | None
) -> Iterator[Doubt]:
    """Each two tanks of a body that have more than rounding in common."""
    for (one, first), (other, second) in itertools.combinations((tanks or {}).items(), 2):
        shared = _shared(first, second)
        if shared > _SHARED * min(math.prod(first.box), math.prod(second.box)):
            size = format_quantity(shared, "m^3", 0)
            sentence = f"tanks {one} and {other} of {name} are in one place, {size} of them"
            yield Doubt((*path, "tanks", other), f"{sentence}: 'bottom' is the middle of a tank's bottom")


def _shared(one: BallastTank, other: BallastTank) -> float:
    """Volume that two tanks have in common [m^3]."""
    sides = []
    for axis in range(3):
        (low, high), (under, over) = (tank.extents[axis] for tank in (one, other))
        sides.append(max(0.0, min(high, over) - max(low, under)))
    return math.prod(sides)
