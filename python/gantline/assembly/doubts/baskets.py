"""Baskets of `mechanics` that slide along their load as no rope does here, or that go through it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations, groupby, pairwise

import numpy as np

from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.loads.load import Load
from gantline.scenario.mechanics import Eye, MechanicsRope, RopeEnd
from gantline.units import format_quantity

__all__ = ["doubtful_baskets"]

#: Friction of steel and slings along a smooth load, wet or painted [1]: less than this may be there.
_FRICTION = 0.1
_UP = np.array([0.0, 0.0, 1.0])
#: How deep a fall may cut the corner of a box [m]: a box stands for what is round, or has chamfers.
_DEEP = 0.1
#: The same of what is round already [m]: a rope lies on its own radius beside the skin.
_DEEP_IN_ROUND = 0.05
#: Places along a fall at which its depth is looked at.
_LOOKS = 200


@dataclass(frozen=True)
class _Basket:
    """A rope that goes over eyes of one body and up from there on both sides.

    Attributes:
        rope: Its name.
        body: What lies in it.
        lean: How far both falls lean along the body, a horizontal vector of the length tan(angle), from
            the body to above (3,).
        middle: Between its eyes (3,) [m].
        height: Of its eyes above the origin of the body, along the body's own z [m].
    """

    rope: str
    body: str
    lean: Array
    middle: Array
    height: float


def doubtful_baskets(parts: Parts, scenario: Scenario, lifted: LiftedLoad | None) -> Iterator[Doubt]:
    """Each pair of baskets of one body that lean along it, towards or away from each other.

    An eye stays where it is on its body. A sling round it, not choked and without a stop, stays along a
    smooth load while its falls lean by less than the angle of friction: they pull with T sin of what they
    lean by and press with T cos. Eyes on top of the load are shackles at lugs, which do not slide.
    """
    mechanics = scenario.mechanics
    ropes = {} if mechanics is None or mechanics.ropes is None else mechanics.ropes
    top = math.inf if lifted is None else float(lifted.body.box[1][2] - lifted.body.centre[2])
    load = None if scenario.load is None else scenario.load.name
    baskets = [
        basket
        for name, rope in ropes.items()
        for basket in _baskets(parts, name, rope)
        if basket.body != load or basket.height < top
    ]
    yield from _through_the_load(parts, scenario, ropes, lifted)
    for first, second in combinations(baskets, 2):
        if first.body != second.body:
            continue
        between = second.middle - first.middle
        towards = (float(first.lean @ between), -float(second.lean @ between))
        least = min(float(np.linalg.norm(one.lean)) for one in (first, second))
        if least <= _FRICTION or not (min(towards) > 0.0 or max(towards) < 0.0):
            continue
        way = "towards" if towards[0] > 0.0 else "away from"
        angle = format_quantity(math.atan(least), "deg", 0)
        sentence = (
            f"baskets {first.rope} and {second.rope} lean along {first.body} by {angle}, {way} each other: "
            f"where friction is less than {least:.2g}, and 0.1 to 0.2 is usual, they slide along it, and "
            "here they stay where their eyes are; hang them plumb, from two hooks or a bar, or choke them"
        )
        yield Doubt(("mechanics", "ropes", second.rope), sentence)


def _through_the_load(
    parts: Parts, scenario: Scenario, ropes: Mapping[str, MechanicsRope], lifted: LiftedLoad | None
) -> Iterator[Doubt]:
    """That falls go through the box or the cylinder of the load between an eye on it and what is above.

    A real rope bends about the upper edge. Here it pulls from the lower eye, so that a load rolls in it that
    would lie still, and bears less than it does.
    """
    load = scenario.load
    if load is None or load.shape.cad is not None or lifted is None:
        return
    centre, turned = parts.pose(load.name)
    size = float(np.linalg.norm(np.ptp(lifted.body.box, axis=0)))
    found: dict[str, tuple[str, float]] = {}
    for name, rope in ropes.items():
        for one, other in pairwise(rope.route):
            if not isinstance(one, RopeEnd | Eye) or not isinstance(other, RopeEnd | Eye):
                continue
            inner, above = (one, other) if one.body == load.name else (other, one)
            if not isinstance(inner, Eye) or inner.body != load.name or above.body == load.name:
                continue
            start, end = ((_place(parts, guide) - centre) @ turned for guide in (inner, above))
            way = end - start
            # No farther from the eye than the load is large: a fall may be much longer.
            part = min(1.0, size / max(float(np.linalg.norm(way)), size))
            line = start + np.linspace(0.0, part, _LOOKS)[:, np.newaxis] * way
            deep = _deepest(load, lifted, line)
            if deep > max(
                _DEEP if load.shape.cylinder is None else _DEEP_IN_ROUND, found.get(name, ("", 0.0))[1]
            ):
                found[name] = above.body, deep
    if not found:
        return
    names, upper = list(found), next(iter(found.values()))[0]
    goes = f"{names[0]} goes" if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]} go"
    deepest = format_quantity(max(deep for _, deep in found.values()), "m", 2)
    yield Doubt(
        ("mechanics", "ropes", names[0]),
        f"{goes} through {load.name}, up to {deepest} deep, between eyes on it and {upper}: a rope bends "
        "about the edge that it meets; lead it over an eye there too, or the load rolls in it as it would "
        "not",
    )


def _deepest(load: Load, lifted: LiftedLoad, line: Array) -> float:
    """How deep places from the origin of its body (n, 3) [m] come into a load [m]; negative outside."""
    if load.shape.cylinder is not None:
        return max(load.shape.cylinder.depth(at) for at in line + lifted.centre)
    low, high = (np.asarray(corner) - lifted.body.centre for corner in lifted.body.box)
    return float(np.minimum(line - low, high - line).min(axis=1).max())


def _baskets(parts: Parts, name: str, rope: MechanicsRope) -> Iterator[_Basket]:
    """Where a rope goes over two eyes or more of one body, between others, of a length that is known."""
    route = [guide for guide in rope.route if isinstance(guide, RopeEnd | Eye)]
    if len(route) < len(rope.route):
        return
    groups = [(body, list(guides)) for body, guides in groupby(route, lambda guide: guide.body)]
    for (_, before), (body, guides), (_, after) in zip(groups, groups[1:], groups[2:], strict=False):
        if body == "world" or len(guides) < 2:
            continue
        eyes = [_place(parts, guide) for guide in guides]
        above: Array = (_place(parts, before[-1]) + _place(parts, after[0])) / 2
        middle, chord = (eyes[0] + eyes[-1]) / 2, eyes[-1] - eyes[0]
        along = np.cross(chord, _UP)
        if not np.linalg.norm(along) > 0.0:  # one eye over the other: it lies along nothing
            continue
        along /= np.linalg.norm(along)
        aside = float((above - middle) @ along)
        legs = float(np.linalg.norm(above - middle))
        if len(groups) == 3 and isinstance(rope.length, float):
            # Taut, which it need not be where the lift begins: half of what does not lie between the eyes.
            under = math.fsum(float(np.linalg.norm(end - start)) for start, end in pairwise(eyes))
            leg = (rope.length - under) / 2
            legs = max(math.sqrt(max(leg**2 - float(chord @ chord) / 4, 0.0)), abs(aside))
        down = math.sqrt(max(legs**2 - aside**2, 0.0))
        if down > 0.0:
            height = float(np.mean([guide.at[2] for guide in guides]))
            yield _Basket(name, body, aside / down * along, middle, height)


def _place(parts: Parts, guide: RopeEnd | Eye) -> Array:
    """World position of a guide at the start (3,) [m]."""
    return parts.place(None if guide.body == "world" else guide.body, guide.at)
