"""Loads that go into water, and what comes out of it: only buoyancy ends there in a simulation."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from gantline.results.afloat.sea import Sea
from gantline.results.rotation import axes
from gantline.results.solids import skin_of
from gantline.results.surroundings import SIGNS, ground_in, is_cut
from gantline.results.variable import Columns, FloatArray, Names
from gantline.units import format_by_size

__all__ = [
    "askew_in_water",
    "dry_hulls",
    "feels_water",
    "immersion_warnings",
    "loads_in_bed",
    "misplaced_areas",
    "never_wet",
    "out_of_water",
]

#: How deep a load may dip, and an area come out, without a word [m]: contact and slings give that much.
_DIPS = 0.01
#: Share of what a load displaces from which it counts as wholly wet; below the rest it is out [1].
_WHOLLY = 0.99
#: How far from upright a load's layers still lie about level [rad].
_ASKEW = np.radians(45.0)
#: What is between body and area in the name of a force.
_CURRENT, _WIND = ".current_areas.", ".wind_areas."
#: What water does to a body wherever it is, by the end of the name of its force.
_OF_WATER = {"added_mass": "added mass", "water_damping": "water damping", "radiation": "memory of the water"}
#: Points of a box of twice the size 1 at which waves are looked at: corners, middles of sides and edges.
_POINTS = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)], dtype=np.float64)


def immersion_warnings(
    columns: Columns,
    names: Names,
    scene: Mapping[str, Any],
    loads: Mapping[str, str],
    density: float,
    sea: Sea | None = None,
) -> list[str]:
    """A sentence for each load of which part goes under water, with what water would carry of it at most.

    In waves also for one that only their crests reach, where it is not over ground.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        scene: What is drawn, with the level of the water where there is some.
        loads: Their bodies by name.
        density: Of the water [kg/m^3].
        sea: Waves; None if there are none.
    """
    water = scene.get("water")
    if not water or not len(columns["time"]):
        return []
    warnings = []
    for load, box in _boxes(columns, names, scene, loads):
        deep = float(water["level"]) - box.lowest
        under = np.flatnonzero(deep > _DIPS)
        without = "no buoyancy, slamming, drag or added mass acts on it without 'in_water'"
        if under.size:
            worst = int(np.argmax(deep))
            share = min(1.0, float(deep[worst] / np.ptp(box.corners[worst])))
            carried = density * share * float(np.prod(2 * box.half))
            since = f"at {columns['time'][under[0]]:.2f} s"
            when = f"{load} goes into the water {since}, up to {deep[worst]:.2f} m deep"
            closed = f"if its box were closed, water would carry up to {format_by_size(carried, 'mass')}"
            warnings.append(f"{when}; {without}, and {closed}")
        elif sea is not None and deep.max() + _highest(sea) > _DIPS:
            within = box.middle + _POINTS * box.half
            points = box.place[:, None] + within @ box.turn.transpose(0, 2, 1)
            crests = _crests(columns["time"], points, float(water["level"]), scene, sea)
            reached = np.flatnonzero(crests > _DIPS)
            if reached.size:
                since = f"at {columns['time'][reached[0]]:.2f} s"
                high = f"up to {crests.max():.2f} m above its lowest point"
                warnings.append(f"waves reach {load} {since}, {high}; {without}")
    return warnings


def loads_in_bed(
    columns: Columns, names: Names, scene: Mapping[str, Any], loads: Mapping[str, str], depth: float | None
) -> list[str]:
    """A sentence for each load of which part goes under the bed of the water, where no ground meets it.

    Args:
        columns: Columns of the core by name.
        names: Names along their dimensions.
        scene: What is drawn, with the level of the water where there is some, and the ground.
        loads: Their bodies by name.
        depth: Of the water [m]; None if not known.
    """
    water, ground = scene.get("water"), ground_in(scene)
    if not water or depth is None or not len(columns["time"]):
        return []
    bed = float(water["level"]) - depth
    warnings = []
    for load, box in _boxes(columns, names, scene, loads):
        under = bed - box.lowest
        if ground is not None:
            # Ground at the bed, or a structure on it, gives as much as the load sinks in.
            under = np.where(ground.under(box.place) >= bed - _DIPS, 0.0, under)
        reached = np.flatnonzero(under > _DIPS)
        if reached.size:
            when = f"at {columns['time'][reached[0]]:.2f} s, up to {under.max():.2f} m deep"
            bottom = f"'ground: {{level: {bed:g} m}}'"
            sentence = f"{load} goes into the bed of the water {when}: nothing holds it there"
            warnings.append(f"{sentence}; {bottom} would, or see the 'depth' of the 'water'")
    return warnings


def feels_water(document: Mapping[str, Any], body: str) -> bool:
    """Whether water acts on a body by how far it is wet."""
    return any(one["type"] == "submerged" and one["body"] == body for one in document.get("forces", ()))


def never_wet(
    document: Mapping[str, Any],
    columns: Columns,
    names: Names,
    scene: Mapping[str, Any],
    loads: Mapping[str, str],
) -> list[str]:
    """A sentence for each load with `in_water` that no water came to in a run that is over.

    What the lift file says of it in water then did nothing, and the lift is none through the splash zone.

    Args:
        document: What has been assembled of the lift.
        columns: Columns of the core by name.
        names: Names along their dimensions.
        scene: What is drawn, with the level of the water where there is some.
        loads: Their bodies by name.
    """
    water = scene.get("water")
    if not water or not len(columns["time"]):
        return []
    wet = {
        force["body"]: columns["displaced_volume"][:, list(names["hull"]).index(force["name"])].max()
        for force in document.get("forces", ())
        if force["type"] == "submerged"
    }
    sentences = []
    for load, box in _boxes(columns, names, scene, loads):
        if wet.get(loads[load], 1.0) > 0.0:
            continue
        above = f"its lowest point stays {box.lowest.min() - float(water['level']):.2f} m above still water"
        sentences.append(f"{load} has 'in_water' and never gets wet: {above}; see how far the plan lowers it")
    return sentences


def out_of_water(document: Mapping[str, Any], columns: Columns, names: Names) -> list[str]:
    """A sentence for each load with `in_water` that is out of the water again after it was wholly wet.

    What runs off it then, and what stays in it, is no force of the simulation, and hangs on the hook. Of one
    with tanks these say what is in it.

    Args:
        document: What has been assembled of the lift.
        columns: Columns of the core by name.
        names: Names along their dimensions.
    """
    warnings = []
    told = {one["body"] for one in document.get("forces", ()) if one["type"] == "tank"}
    for force in (one for one in document.get("forces", ()) if one["type"] == "submerged"):
        if force["body"] in told:
            continue
        wet = columns["displaced_volume"][:, list(names["hull"]).index(force["name"])]
        whole = sum(4 * one["layers"] * one["volume"] for one in force["lattices"])
        sunk = np.flatnonzero(wet >= _WHOLLY * whole)
        out = np.flatnonzero(wet < (1.0 - _WHOLLY) * whole)
        after = out[out > sunk[0]] if sunk.size else out[:0]
        if after.size:
            when = f"{force['body']} is out of the water at {columns['time'][after[0]]:.2f} s"
            held = "what water is held in it then, and runs off, has no weight here: its hook load is more"
            warnings.append(f"{when}, after it was wholly wet: {held}")
    return warnings


def askew_in_water(document: Mapping[str, Any], columns: Columns, names: Names) -> list[str]:
    """A sentence for each load that gets wet so far from upright that its layers are none of the water's.

    Args:
        document: What has been assembled of the lift.
        columns: Columns of the core by name.
        names: Names along their dimensions.
    """
    warnings = []
    for force in (one for one in document.get("forces", ()) if one["type"] == "submerged"):
        at = list(names["body"]).index(force["body"])
        wet = columns["displaced_volume"][:, list(names["hull"]).index(force["name"])]
        whole = sum(4 * lattice["layers"] * lattice["volume"] for lattice in force["lattices"])
        surfacing = (wet > 0.0) & (wet < (1.0 - 1e-9) * whole)
        tilt = np.arccos(np.clip(axes(columns["body_orientation"][:, at])[:, 2, 2], -1.0, 1.0))
        askew = np.flatnonzero(surfacing & (tilt > _ASKEW))
        if askew.size:
            when = (
                f"first at {columns['time'][askew[0]]:.2f} s, up to {np.degrees(tilt[askew].max()):.0f} deg"
            )
            sentence = f"{force['body']} is at the surface of the water far from upright, {when}"
            without = "it gets wet there in two steps, one for each row of its cells, and not evenly"
            warnings.append(f"{sentence}: {without}")
    return warnings


def misplaced_areas(
    document: Mapping[str, Any], columns: Columns, names: Names, level: float, *, has_water: bool
) -> list[str]:
    """A sentence for each current area that comes out of still water, and each wind area that goes into it.

    Args:
        document: What has been assembled of the lift.
        columns: Columns of the core by name.
        names: Names along their dimensions.
        level: Of the water [m].
        has_water: Whether there is any: wind pushes in a dry dock as well.
    """
    if not len(columns["time"]):
        return []
    kinds = (_CURRENT, _WIND) if has_water else (_CURRENT,)
    bodies = {body["name"]: body for body in document.get("bodies", ())}
    warnings = []
    for force in document.get("forces", ()):
        kind = next((kind for kind in kinds if kind in str(force["name"])), None)
        if kind is None:
            continue
        body, _, area = str(force["name"]).partition(kind)
        arm = np.asarray(force["at"]) - bodies[body].get("centre_of_gravity", (0.0, 0.0, 0.0))
        place, turn = _course(columns, names, body)
        height = place[:, 2] + turn[:, 2] @ arm - level
        off = height if kind == _CURRENT else -height
        if off.max() > _DIPS:
            first = columns["time"][np.argmax(off > _DIPS)]
            beyond = "above" if kind == _CURRENT else "under"
            where = f"up to {off.max():.2f} m {beyond} the water, first at {first:.2f} s"
            if kind == _CURRENT:
                as_if = "it resists and is pushed there as in water, which damps motion as air does not"
                warnings.append(f"the current area {area} of {body} is {where}: {as_if}")
            else:
                warnings.append(f"the wind area {area} of {body} is {where}: wind pushes it there as in air")
    return warnings


def dry_hulls(document: Mapping[str, Any], columns: Columns, names: Names) -> list[str]:
    """A sentence for each body whose hull comes out of the water, and which moves as if it had not.

    Args:
        document: What has been assembled of the lift.
        columns: Columns of the core by name.
        names: Names along their dimensions.
    """
    if not len(columns["time"]):
        return []
    forces = document.get("forces", ())
    warnings = []
    for hull in (force for force in forces if force["type"] == "buoyancy"):
        body = hull["body"]
        kept = [_OF_WATER[end] for end in _OF_WATER if any(one["name"] == f"{body}.{end}" for one in forces)]
        dry = columns["displaced_volume"][:, list(names["hull"]).index(hull["name"])] <= 0.0
        if kept and dry.any():
            first = f"first at {columns['time'][np.argmax(dry)]:.2f} s"
            acts = f"its {' and '.join(kept)} {'acts' if len(kept) == 1 else 'act'} there as in water"
            slow = "so that it swings and bounces otherwise than in air"
            warnings.append(f"the hull of {body} is out of the water, {first}: {acts}, {slow}")
    return warnings


class _Box(NamedTuple):
    """The box about a load on its way.

    A load from CAD by that, too: thousands of points at every sample are too many.

    Attributes:
        middle: Of the box, from the centre of gravity (3,) [m].
        half: Half its sides (3,) [m].
        place: Of the centre of gravity (time, 3) [m].
        turn: Axes of the load (time, 3, 3).
        corners: Heights of corners over the centre of gravity (time, 8) [m].
    """

    middle: FloatArray
    half: FloatArray
    place: FloatArray
    turn: FloatArray
    corners: FloatArray

    @property
    def lowest(self) -> FloatArray:
        """Height of its lowest corner (time,) [m]."""
        found: FloatArray = self.place[:, 2] + self.corners.min(axis=1)
        return found


def _boxes(
    columns: Columns, names: Names, scene: Mapping[str, Any], loads: Mapping[str, str]
) -> Iterator[tuple[str, _Box]]:
    """Boxes about loads, by name; those that are drawn without a solid have none."""
    drawn = {body["name"]: body for body in scene.get("bodies") or ()}
    for load, body in loads.items():
        skin = skin_of(drawn.get(body))
        if not len(skin):
            continue
        least, most = skin.min(axis=(0, 1)), skin.max(axis=(0, 1))
        middle, half = (least + most) / 2, (most - least) / 2
        place, turn = _course(columns, names, body)
        yield load, _Box(middle, half, place, turn, turn[:, 2] @ (middle + SIGNS * half).T)


def _course(columns: Columns, names: Names, body: str) -> tuple[FloatArray, FloatArray]:
    """Places of a body's centre of gravity (time, 3) [m], and its axes (time, 3, 3)."""
    at = list(names["body"]).index(body)
    return columns["body_position"][:, at], axes(columns["body_orientation"][:, at])


def _highest(sea: Sea) -> float:
    """No crest is higher [m]."""
    return float(sum(wave["amplitude"] for wave in sea.components))


def _crests(
    time: FloatArray, points: FloatArray, level: float, scene: Mapping[str, Any], sea: Sea
) -> FloatArray:
    """How far the waves come over the lowest points that they reach (time,) [m]; -inf over ground alone.

    Args:
        time: (time,) [s].
        points: Of a load (time, points, 3) [m].
        level: Of still water [m].
        scene: What is drawn; ground counts where it says where the water is.
        sea: The waves.
    """
    over = level + sea.at(time, points[..., :2]) - points[..., 2]
    ground = ground_in(scene)
    if ground is not None and is_cut(ground, level):
        is_land = ground.under(points.reshape(-1, 3)).reshape(over.shape) >= level
        over = np.where(is_land, -np.inf, over)
    highest: FloatArray = over.max(axis=1)
    return highest
