"""Extension sheaves: where they hang at the start, and what they weigh."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.rope_weight import mass_at_end
from gantline.assembly.spatial import Array
from gantline.assembly.yard import lower_end, lower_lump, upper_end
from gantline.scenario import Rigging, Scenario
from gantline.scenario.extension import SlingEnd, lugs_below

__all__ = ["add_extension_sheaves"]

#: Rounds of Newton's method; a few are enough where there is a place at rest.
_ROUNDS = 500
#: What may be missing from balance, of the weight of the lightest sheave.
_BALANCED = 1e-9
#: Where steps have to be damped more than this, there is no better place nearby [N/m].
_STIFFEST = 1e20
#: A sheave this close to another end of its sling has nowhere to hang [m].
_CLOSEST = 1e-3


@dataclass(frozen=True)
class _Line:
    """A sling as a line of points: numbers of extension sheaves, and fixed places in the world."""

    points: tuple[int | Array, ...]
    length: float
    stiffness: float  # EA over length [N/m]


def add_extension_sheaves(
    parts: Parts, scenario: Scenario, rigging: Rigging, lugs: Mapping[str, Sequence[float]]
) -> None:
    """Each as a point with mass, in balance on its slings at the start; after hooks, equalizers and load.

    Raises:
        ScenarioError: if one would hang below a lug that it serves, or nothing holds them in balance.
    """
    if not rigging.extensions:
        return
    assert scenario.load is not None  # slings have been checked to lead to its lugs
    numbers = {name: number for number, name in enumerate(rigging.extensions)}
    masses = np.array([_mass(rigging, name) for name in numbers])
    lines = _lines(parts, scenario.load.name, rigging, lugs, numbers)
    start = _hanging(rigging, lines, numbers)
    places = _balance(lines, masses * scenario.simulation.gravity, start)
    if places is None:
        sentence = "no place was found where the extension sheaves hang at rest: they are not held in balance"
        raise scenario.start_error(
            ("extension_sheaves",),
            f"{sentence}; two on one sling have equal masses, or slings that hold them",
        )
    for (name, number), mass in zip(numbers.items(), masses, strict=True):
        for lug in lugs_below(SlingEnd(None, name), rigging.extensions, rigging.slings):
            below = float(parts.place(scenario.load.name, lugs[lug])[2] - places[number][2])
            if below > 0:
                sentence = f"it would hang {below:.3g} m below lug '{scenario.load.name}.{lug}' at the start"
                raise scenario.start_error(
                    ("extension_sheaves", name), f"{sentence}; raise the hook, or make its slings shorter"
                )
        position = [float(part) for part in places[number]]
        joint = {"type": "point", "position": position, "velocity": [0.0, 0.0, 0.0]}
        parts.add_body(name, joint, mass=float(mass))


def _mass(rigging: Rigging, name: str) -> float:
    """Mass of an extension sheave with shackle and what it carries of its two slings [kg]."""
    extension = rigging.extensions[name]
    over = rigging.slings[extension.carries]
    return (
        extension.mass
        + lower_lump(rigging.slings[extension.hangs_on])
        + mass_at_end(over.weight, over.length)
    )


def _lines(
    parts: Parts,
    load: str,
    rigging: Rigging,
    lugs: Mapping[str, Sequence[float]],
    numbers: Mapping[str, int],
) -> list[_Line]:
    """All slings that hold extension sheaves."""

    def point(guide: Json) -> int | Array:
        body = guide["body"]
        return numbers[body] if body in numbers else parts.place(body, guide["at"])

    lines = []
    for sling in rigging.slings.values():
        ends = [lower_end(load, lugs, end) for end in sling.ends]
        top = upper_end(rigging, sling)
        route = [top, *ends] if sling.over is None else [ends[0], top, ends[1]]
        points = tuple(point(guide) for guide in route)
        if any(isinstance(one, int) for one in points):
            assert sling.rope.stiffness is not None  # has been checked to stretch
            lines.append(_Line(points, sling.length, sling.rope.stiffness / sling.length))
    return lines


def _hanging(rigging: Rigging, lines: Sequence[_Line], numbers: Mapping[str, int]) -> Array:
    """Each straight below what it hangs on, as far as its sling reaches: places (sheaves, 3) [m]."""
    tops = {}
    for line in lines:
        if len(line.points) == 2 and isinstance(line.points[1], int):
            tops[line.points[1]] = line.points[0]
    places = np.zeros((len(numbers), 3))
    left = list(rigging.extensions.values())
    while left:
        one = left.pop(0)
        number, above = numbers[one.name], rigging.slings[one.hangs_on]
        if above.over is not None and any(other.name == above.over for other in left):
            left.append(one)
            continue
        top = tops[number] if above.over is None else places[numbers[above.over]]
        places[number] = np.asarray(top) - (0.0, 0.0, above.length / len(above.ends))
    return places


def _balance(lines: Sequence[_Line], weights: Array, start: Array) -> Array | None:
    """Where the sheaves hang at rest: least energy, by Newton's method; None if nowhere.

    The energy is convex in their places, as stretched lengths are, and only what is stretched holds any. So
    there is one least value, and no other place at rest.
    """
    places, damping = start.copy(), 1.0
    energy, slope, curve = _energy(lines, weights, places)
    for _ in range(_ROUNDS):
        if damping > _STIFFEST:
            break
        if np.abs(slope).max() <= _BALANCED * weights.min():
            return places
        step = np.linalg.solve(curve + damping * np.eye(len(slope)), -slope)
        moved = places + step.reshape(places.shape)
        if _too_close(lines, moved):
            damping *= 10.0
            continue
        trial = _energy(lines, weights, moved)
        # Near the end the energy no longer tells; the slope does.
        if trial[0] < energy or np.abs(trial[1]).max() < np.abs(slope).max():
            places, (energy, slope, curve), damping = moved, trial, damping / 10.0
        else:
            damping *= 10.0
    return None


def _too_close(lines: Sequence[_Line], places: Array) -> bool:
    return any(np.linalg.norm(way) < _CLOSEST for line in lines for way in _ways(line, places))


def _ways(line: _Line, places: Array) -> Array:
    """From each point of a line to the next (parts, 3) [m]."""
    points = [places[one] if isinstance(one, int) else one for one in line.points]
    return np.diff(np.array(points), axis=0)


def _energy(lines: Sequence[_Line], weights: Array, places: Array) -> tuple[float, Array, Array]:
    """Energy [J], its slope [N] and its curvature [N/m] over all coordinates of the places."""
    count = len(weights)
    slope, curve = np.zeros(3 * count), np.zeros((3 * count, 3 * count))
    slope[2::3] = weights
    energy = float(weights @ places[:, 2])
    for line in lines:
        ways = _ways(line, places)
        sizes = np.linalg.norm(ways, axis=1)
        stretch = float(sizes.sum()) - line.length
        if stretch <= 0:
            continue
        tension = line.stiffness * stretch
        energy += 0.5 * tension * stretch
        longer = np.zeros(3 * count)
        for (before, after), way, size in zip(
            zip(line.points[:-1], line.points[1:], strict=True), ways, sizes, strict=True
        ):
            along = way / size
            turning = tension * (np.eye(3) - np.outer(along, along)) / size
            free = [(one, sign) for one, sign in ((before, -1.0), (after, 1.0)) if isinstance(one, int)]
            for one, sign in free:
                longer[3 * one : 3 * one + 3] += sign * along
                for other, other_sign in free:
                    rows, columns = slice(3 * one, 3 * one + 3), slice(3 * other, 3 * other + 3)
                    curve[rows, columns] += sign * other_sign * turning
        slope += tension * longer
        curve += line.stiffness * np.outer(longer, longer)
    return energy, slope, curve
