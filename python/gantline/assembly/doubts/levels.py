"""Heights at which things cannot well be: heel pins, quays under water, loads over what they stand on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gantline.assembly.cranes.crawler import crawlers
from gantline.assembly.loads.under_load import UnderLoad
from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.plan.steps import HoistStep, HoldStep
from gantline.units import format_quantity

__all__ = ["doubtful_levels", "extent_of"]

#: Heel pins of crawler cranes are 2 m to 8 m over the ground, a thirtieth to a tenth of their boom; of cranes
#: afloat on deck, or on a pedestal, up to a third of it over the deck [1].
_PINS_ASHORE, _PINS_AFLOAT = 0.2, 0.5
#: A load so much over what it stands on comes down as it yields, or as slings stretch [m].
_NEAR = 0.1


def doubtful_levels(parts: Parts, scenario: Scenario, under: Sequence[UnderLoad]) -> Iterator[Doubt]:
    """Each of these.

    Args:
        parts: The system, with all its bodies, shapes and contacts.
        scenario: The lift.
        under: All supports, and where the load is over them.
    """
    yield from _high_pins(scenario)
    yield from _drowned(scenario, under)
    yield from _over(parts, scenario, under)


def _high_pins(scenario: Scenario) -> Iterator[Doubt]:
    """Booms that begin high above ground or deck: a digit has slipped, and they reach over everything."""
    ashore = crawlers(scenario)
    for boom in scenario.booms.values():
        most, length = _PINS_AFLOAT, boom.boom.length
        over, what = boom.heel[2], "keel"
        path: Path = (*boom.path, "boom", "heel_pins", "at")
        if boom.crane in ashore:
            most, what = _PINS_ASHORE, "ground"
            path = (*boom.path, "boom", "heel_pins", "height")
        else:
            crane = (scenario.cranes or {})[boom.crane]
            vessel = (scenario.vessels or {}).get(getattr(crane, "vessel", None) or "")
            extent = None if vessel is None else vessel.hull.extent
            if extent is not None:
                over, what = over - extent[1][2], "deck"
        if over > most * length:
            high = f"the heel pins of {boom.name} are {format_quantity(over, 'm', 1)} over the {what}"
            why = "a digit has slipped" if what == "ground" else "a digit has slipped, unless on a tower"
            sentence = f"{high}, and it is {format_quantity(length, 'm', 1)} long; {why}"
            yield Doubt(path, sentence)


def _drowned(scenario: Scenario, under: Sequence[UnderLoad]) -> Iterator[Doubt]:
    """Crawler cranes and supports that stand on ground under water."""
    if scenario.water is None or scenario.ground is None:
        return
    level, water = scenario.ground.level, scenario.water.level
    if level >= water:
        return
    load = scenario.load
    stands = [f"crane {name}" for name in crawlers(scenario)]
    dry = load is not None and load.in_water is None
    wet = {one.support.group for one in under if one.pad["at"][2] < water}
    stands += [f"supports {name}" for name in (scenario.supports or {}) if dry and name in wet]
    if stands:
        where = f"the ground at {level:g} m is {format_quantity(water - level, 'm', 2)} under water"
        sentence = f"{where}, and is taken as dry under {', '.join(stands)}"
        yield Doubt(("water", "level"), f"{sentence}; a quay is higher than its water")


def _over(parts: Parts, scenario: Scenario, under: Sequence[UnderLoad]) -> Iterator[Doubt]:
    """A load that the plan waits to come off what it stands on, and that begins above all of it."""
    load, place = scenario.load, _waits_for_lift_off(scenario)
    if load is None or place is None or scenario.load_has_settled or scenario.hinges or load.in_water:
        return
    gaps = _gaps(parts, scenario, under)
    if not gaps or min(gaps.values()) <= _NEAR:
        return
    nearest = min(gaps, key=lambda name: gaps[name])
    waits = f"step '{scenario.plan[place].step}' waits for {load.name} to leave what it stands on"
    sentence = f"{waits}, and it begins {format_quantity(gaps[nearest], 'm', 2)} over {nearest}"
    yield Doubt(("load", "position"), f"{sentence}: see its position, and 'stands_on'")


def _waits_for_lift_off(scenario: Scenario) -> int | None:
    """The place of the first step that moves anything but by holding or hoisting on, if it waits for that."""
    for place, step in enumerate(scenario.plan):
        if not isinstance(step, HoldStep | HoistStep):
            return None
        until = step.until if isinstance(step, HoistStep) else None
        if until is not None and (until.supports == "clear" or until.load_transferred is not None):
            return place
    return None


def _gaps(parts: Parts, scenario: Scenario, under: Sequence[UnderLoad]) -> dict[str, float]:
    """How far at least the load begins over supports, ground and bodies that may bear it [m].

    Nothing where planes of `mechanics` may.
    """
    assert scenario.load is not None  # asked of lifts with one
    name = scenario.load.name
    found = {f"'{one.support.name}'": one.gap for one in under if one.gap is not None}
    touching = [one for one in parts.contacts if name in (one["body"], one.get("plane_body"))]
    if any(not one["name"].startswith(f"{name}.corner_") for one in touching):
        return {}
    if touching and scenario.ground is not None:
        corners = [parts.place(name, one["at"])[2] for one in touching]
        found["the ground"] = float(min(corners)) - scenario.ground.level
    for pair in parts.pairs:
        shapes = [parts.shapes[shape] for shape in pair["shapes"]]
        own = [shape for shape in shapes if shape["body"] == name]
        if len(own) != 1:
            continue
        other = next(shape for shape in shapes if shape is not own[0])
        (low, high), (bottom, top) = extent_of(parts, own[0]), extent_of(parts, other)
        if (low[:2] < top[:2]).all() and (bottom[:2] < high[:2]).all():
            found[f"'{other['body'] or 'the ground'}'"] = float(low[2] - top[2])
    return found


def extent_of(parts: Parts, shape: Json) -> tuple[Array, Array]:
    """Least and largest x, y, z of a shape, world axes (3,) each [m]."""
    signs = np.array(np.meshgrid(*[(-0.5, 0.5)] * 3)).reshape(3, -1).T
    corners = []
    for piece in shape["parts"]:
        is_box = piece["type"] == "box"
        corners.append(piece["centre"] + signs * piece["size"] if is_box else np.array(piece["vertices"]))
    position, rotation = parts.pose(shape["body"])
    found = position + np.concatenate(corners) @ rotation.T
    return found.min(axis=0), found.max(axis=0)
