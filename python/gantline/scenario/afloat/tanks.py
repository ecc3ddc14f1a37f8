"""Tanks of everything that floats and of the load, and which of them the plan pumps, or have holes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from gantline.scenario.afloat.water import SEA_WATER, Afloat, BallastTank, Hole
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.model import Scenario
from gantline.scenario.plan.steps import PumpStep

__all__ = [
    "SEA",
    "Contents",
    "bodies_afloat",
    "changing_tanks",
    "contents_along",
    "contents_of_load",
    "ends_of_pump",
    "has_sea",
    "hole_turns",
    "holed_tanks",
    "holes_of",
    "load_tanks",
    "pumped_at_most",
    "sea_density",
    "tanks_of",
    "with_contents",
]

#: What a pump may draw from and discharge to beside tanks.
SEA: Final = "sea"


def bodies_afloat(scenario: Scenario) -> dict[str, Afloat]:
    """Vessels and bodies of `mechanics` by name: all that water may act on."""
    plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    return {**(scenario.vessels or {}), **plain}


def has_sea(scenario: Scenario) -> bool:
    """Whether a pump can draw from water around: the file says where it is, or something floats in it."""
    afloat = any(body.hull is not None for body in bodies_afloat(scenario).values())
    return scenario.water is not None or afloat


def load_tanks(scenario: Scenario) -> dict[str, BallastTank]:
    """Tanks in the load by their full name, `<load>.<tank>`; none without a load."""
    load = scenario.load
    return {} if load is None else {f"{load.name}.{name}": tank for name, tank in (load.tanks or {}).items()}


def tanks_of(scenario: Scenario) -> dict[str, BallastTank]:
    """All tanks by their full name, `<vessel>.<tank>` or `<load>.<tank>`."""
    afloat = {
        f"{name}.{tank_name}": tank
        for name, body in bodies_afloat(scenario).items()
        for tank_name, tank in (body.tanks or {}).items()
    }
    return {**afloat, **load_tanks(scenario)}


def ends_of_pump(scenario: Scenario, step: PumpStep) -> tuple[str | None, str | None]:
    """Full names of the tanks from and to which a step pumps; None is the sea."""
    known = tanks_of(scenario)
    source, target = (
        None if text == SEA else full_name(text, known) for text in (step.pump.from_, step.pump.to)
    )
    return source, target


def holed_tanks(scenario: Scenario) -> dict[str, BallastTank]:
    """Tanks with holes by their full name."""
    return {name: tank for name, tank in tanks_of(scenario).items() if tank.holes}


def with_contents(scenario: Scenario, contents: Mapping[str, float]) -> Scenario:
    """The lift with other contents of tanks at its start [kg], by their full names."""
    load = () if scenario.load is None else [("load", scenario.load.name, scenario.load.tanks)]
    bodies = [
        (
            f"vessels.{name}" if name in (scenario.vessels or {}) else f"mechanics.bodies.{name}",
            name,
            body.tanks,
        )
        for name, body in bodies_afloat(scenario).items()
    ]
    paths = {
        f"{name}.{tank}": f"{path}.tanks.{tank}.content"
        for path, name, tanks in [*load, *bodies]
        for tank in tanks or {}
    }
    return scenario.changed({paths[tank]: f"{content!r} kg" for tank, content in contents.items()})


def holes_of(scenario: Scenario) -> dict[str, Hole]:
    """Holes of all tanks by their full name, `<vessel>.<tank>.<hole>` or `<load>.<tank>.<hole>`."""
    return {
        f"{name}.{own}": hole
        for name, tank in holed_tanks(scenario).items()
        for own, hole in (tank.holes or {}).items()
    }


def hole_turns(scenario: Scenario) -> dict[str, list[tuple[int, bool]]]:
    """Steps that open or close each hole, by its full name, in their order, and whether it is open then."""
    known = holes_of(scenario)
    found: dict[str, list[tuple[int, bool]]] = {name: [] for name in known}
    for place, step in enumerate(scenario.plan):
        for names, is_open in ((step.open_holes, True), (step.close_holes, False)):
            for text in names:
                if (name := full_name(text, known)) is not None:
                    found[name].append((place, is_open))
    return found


def _leaks_from(scenario: Scenario) -> dict[str, int]:
    """The first step of the plan in which a hole of each tank is open; past the last one where none is."""
    turns, found = hole_turns(scenario), dict[str, int]()
    for name, tank in holed_tanks(scenario).items():
        for own, hole in (tank.holes or {}).items():
            opens = [place for place, is_open in turns[f"{name}.{own}"] if is_open]
            first = opens[:1] if hole.closed else [0]
            found[name] = min([*first, found.get(name, len(scenario.plan))])
    return found


def changing_tanks(scenario: Scenario) -> set[str]:
    """Full names of the tanks that a step of the plan pumps, or that have holes."""
    steps = [step for step in scenario.plan if isinstance(step, PumpStep)]
    pumped = {name for step in steps for name in ends_of_pump(scenario, step) if name is not None}
    return pumped | set(holed_tanks(scenario))


def pumped_at_most(scenario: Scenario) -> dict[str, tuple[float, float]]:
    """What the plan has pumped into each tank, at its least and at its most, by steps with an amount [kg]."""
    now: dict[str, float] = {}
    found: dict[str, tuple[float, float]] = {}
    for step in scenario.plan:
        if not isinstance(step, PumpStep) or step.by is None:
            continue
        for name, amount in zip(ends_of_pump(scenario, step), (-step.by, step.by), strict=True):
            if name is not None:
                now[name] = now.get(name, 0.0) + amount
                least, most = found.get(name, (0.0, 0.0))
                found[name] = (min(least, now[name]), max(most, now[name]))
    return found


@dataclass(frozen=True)
class Contents:
    """What may be in a tank, least and most [kg]."""

    least: float
    most: float

    def pumped(self, least: float, most: float, capacity: float) -> Contents:
        """After so much more or less has been pumped in, at its least and most, as far as there is room."""
        bounds = (self.least + least, self.most + most)
        low, high = (min(max(one, 0.0), capacity) for one in bounds)
        return Contents(low, high)


def contents_along(scenario: Scenario) -> list[dict[str, Contents]]:
    """What may be in each tank, by full name, as each step of the plan begins, and at the end.

    A step that waits for something may pump anything or nothing; through holes, once open, anything may run.
    """
    known, leaks = tanks_of(scenario), _leaks_from(scenario)
    found = [{name: Contents(tank.content, tank.content) for name, tank in known.items()}]
    for place, step in enumerate(scenario.plan):
        now = dict(found[-1])
        if isinstance(step, PumpStep):
            least, most = (0.0, float("inf")) if step.by is None else (step.by, step.by)
            source, target = ends_of_pump(scenario, step)
            if source is not None:
                now[source] = now[source].pumped(-most, -least, known[source].capacity)
            if target is not None:
                now[target] = now[target].pumped(least, most, known[target].capacity)
        leaking = [name for name, first in leaks.items() if first <= place]
        found.append({**now, **{name: Contents(0.0, known[name].capacity) for name in leaking}})
    return found


def contents_of_load(scenario: Scenario) -> list[Contents]:
    """What may be in all tanks of the load together during each step of the plan and those beside it."""
    along, own = contents_along(scenario), load_tanks(scenario)
    beside = [getattr(step, "starts", "") == "with_previous" for step in scenario.plan]
    found = []
    for place in range(len(scenario.plan)):
        first, last = place, place
        while first > 0 and beside[first]:
            first -= 1
        while last + 1 < len(beside) and beside[last + 1]:
            last += 1
        ends = [[along[at][name] for name in own] for at in (first, last + 1)]
        least = min(math.fsum(one.least for one in end) for end in ends)
        found.append(Contents(least, max(math.fsum(one.most for one in end) for end in ends)))
    return found


def sea_density(scenario: Scenario) -> float:
    """Density of the water around [kg/m^3]."""
    return SEA_WATER if scenario.water is None else scenario.water.density
