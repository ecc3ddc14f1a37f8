"""What hangs between hooks and load: where at the start, and its weight.

Extension sheaves, spreaders and compensators.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from gantline.assembly.cranes.compensators import add_compensator, hung_mass
from gantline.assembly.loads.load_body import stated_inertia
from gantline.assembly.parts import ORIGIN, Json, Parts
from gantline.assembly.ropes.balance import Hung, Line, Pose, balance
from gantline.assembly.ropes.rope_weight import mass_at_end
from gantline.assembly.spatial import (
    Array,
    about_axis,
    inertia_list,
    rotation_quaternion,
    solid_box,
)
from gantline.assembly.yard import lower_end, lower_lump, sling_route, upper_lump
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.compensator import rods
from gantline.scenario.errors import StartError
from gantline.scenario.extension import SlingEnd, ends_below
from gantline.scenario.loads.spreader import Spreader

__all__ = ["add_between"]

#: Of the length of a sling, what it goes down at least where a spreader starts to look for its place.
_DOWN = 0.05


def add_between(
    parts: Parts,
    scenario: Scenario,
    rigging: Rigging,
    lugs: Mapping[str, Sequence[float]],
    pins: dict[str, bool],
) -> None:
    """Extension sheaves as points, spreaders and compensators as bodies, in balance on their slings.

    After hooks, equalizers and load. `lugs` are positions in the load's body frame, `pins` what locking pins
    there are, and whether they are in at the start. Rods stay where they start while balance is found.

    Raises:
        ScenarioError: if a sheave would hang below a lug that it serves, or nothing holds them in balance.
    """
    spreaders, compensators = scenario.spreaders or {}, scenario.compensators or {}
    names = [*rigging.extensions, *spreaders, *compensators]
    if scenario.load is None or not names:
        return
    # As bodies with all that is lumped on them they know their weights; where they hang comes after that.
    heading = scenario.load.heading
    for name in rigging.extensions:
        joint = {"type": "point", "position": [0.0, 0.0, 0.0], "velocity": [0.0, 0.0, 0.0]}
        parts.add_body(name, joint, mass=_mass_of_sheave(rigging, name))
    for name, spreader in spreaders.items():
        _add_spreader(parts, rigging, name, spreader, heading)
    for name, compensator in compensators.items():
        add_compensator(parts, rigging, name, compensator, pins)
    lines = list(_lines(parts, scenario, rigging, lugs, names))
    hung = []
    for name in names:
        mass, centre = parts.bodies[name]["mass"], np.array(parts.bodies[name]["centre_of_gravity"])
        if name in compensators:
            mass, centre = hung_mass(parts, name, compensators[name])
        hung.append(Hung(mass * scenario.simulation.gravity, centre, name not in rigging.extensions))
    turns = np.array([parts.pose(name)[1] for name in names])
    found = balance(hung, lines, _straight_below(lines, turns))
    if found is None:
        raise _no_balance(scenario, rigging)
    for place, turn, name in zip(found.places, found.turns, names, strict=True):
        joint = parts.bodies[name]["joint"]
        joint["position"] = [float(part) for part in place]
        if name not in rigging.extensions:
            joint["orientation"] = rotation_quaternion(turn)
    _check_sheaves(parts, scenario, rigging, lugs)


def _no_balance(scenario: Scenario, rigging: Rigging) -> StartError:
    key = "spreaders" if scenario.spreaders else "compensators"
    right = "raise the hook, or make slings longer or shorter"
    if rigging.extensions:
        key, right = "extension_sheaves", "two on one sling have equal masses, or slings that hold them"
    what = key.replace("_", " ")
    sentence = f"no place was found where the {what} hang at rest: they are not held in balance"
    return scenario.start_error((key,), f"{sentence}; {right}")


def _mass_of_sheave(rigging: Rigging, name: str) -> float:
    """Mass of an extension sheave with shackle and what it carries of its two slings [kg]."""
    extension = rigging.extensions[name]
    over = rigging.slings[extension.carries]
    return (
        extension.mass
        + lower_lump(rigging.slings[extension.hangs_on])
        + mass_at_end(over.weight, over.length)
    )


def _add_spreader(parts: Parts, rigging: Rigging, name: str, spreader: Spreader, heading: float) -> None:
    """Its origin is the middle of its box; shackles and halves of slings are lumped on its lugs."""
    own = spreader.inertia
    inertia = solid_box(spreader.mass, spreader.size) if own is None else stated_inertia(own)
    turned = about_axis((0.0, 0.0, 1.0), heading if spreader.heading is None else spreader.heading)
    still = {"velocity": [0.0, 0.0, 0.0], "angular_velocity": [0.0, 0.0, 0.0]}
    parts.add_body(
        name,
        {"type": "free", "position": [0.0, 0.0, 0.0], "orientation": turned, **still},
        mass=spreader.mass,
        centre_of_gravity=spreader.centre_of_gravity,
        inertia=inertia_list(inertia),
    )
    for sling in rigging.slings.values():
        if sling.spreader == name and sling.upper_lug is not None:
            parts.lump(name, spreader.lugs[sling.upper_lug].at, upper_lump(sling))
        for end in sling.ends:
            if end.spreader == name and end.lug is not None:
                parts.lump(name, spreader.lugs[end.lug].at, lower_lump(sling))


def _lines(
    parts: Parts,
    scenario: Scenario,
    rigging: Rigging,
    lugs: Mapping[str, Sequence[float]],
    names: Sequence[str],
) -> Iterator[Line]:
    """All slings at what hangs between, of those that are on at the start."""
    numbers = {name: number for number, name in enumerate(names)}
    of_rods = rods(scenario)

    def point(guide: Json) -> tuple[int | None, Array]:
        body, at = guide["body"], np.array(guide["at"])
        if body in of_rods:
            body = of_rods[body]
            given = (scenario.compensators or {})[body]
            at = at - (0.0, 0.0, given.length + given.out_at_start)
        return (numbers[body], at) if body in numbers else (None, parts.place(body, guide["at"]))

    for sling in (one for one in rigging.slings.values() if one.starts_on):
        points = tuple(point(guide) for guide in sling_route(scenario, rigging, sling, lugs))
        if any(body is not None for body, _ in points):
            yield Line(points, sling.length, sling.rope)


def _straight_below(lines: Sequence[Line], turns: Array) -> Pose:
    """Each below what holds it, as far as its slings reach; from there balance is found."""
    pose = Pose(np.zeros((len(turns), 3)), turns)
    todo = list(range(len(turns)))
    while todo:
        number = todo.pop(0)
        held = [one for line in lines for one in _held(line, number)]
        if any(body in (number, *todo) for (body, _), _, _ in held):
            todo.append(number)
            continue
        # Where the middle would be at the upper end of each sling, and how far below it may be.
        tops = np.array([pose.point(*top) - turns[number] @ at for top, at, _ in held])
        aside = np.linalg.norm((tops - tops.mean(axis=0))[:, :2], axis=1)
        lengths = np.array([length for _, _, length in held])
        down = np.sqrt(np.maximum(lengths**2 - aside**2, (_DOWN * lengths) ** 2))
        pose.places[number] = tops.mean(axis=0) - (0.0, 0.0, float(down.mean()))
    return pose


def _held(line: Line, number: int) -> Iterator[tuple[tuple[int | None, Array], Array, float]]:
    """How a line holds a body from above: its upper point, the point of the body, and the length between."""
    top = line.points[0 if len(line.points) == 2 else 1]
    for end in line.points:
        if end is not top and end[0] == number:
            yield top, end[1], line.length / (len(line.points) - 1)


def _check_sheaves(
    parts: Parts, scenario: Scenario, rigging: Rigging, lugs: Mapping[str, Sequence[float]]
) -> None:
    """Refuse extension sheaves that hang below a lug that they serve."""
    for name in rigging.extensions:
        height = float(parts.place(name, ORIGIN)[2])
        for end in ends_below(SlingEnd(None, name), rigging.extensions, rigging.slings):
            guide = lower_end(scenario, lugs, end)
            below = float(parts.place(guide["body"], guide["at"])[2]) - height
            if below > 0:
                lug = f"{guide['body']}.{end.lug}"
                sentence = f"it would hang {below:.3g} m below lug '{lug}' at the start"
                raise scenario.start_error(
                    ("extension_sheaves", name), f"{sentence}; raise the hook, or make its slings shorter"
                )
