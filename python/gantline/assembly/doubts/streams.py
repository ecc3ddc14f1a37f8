"""Wind and current that cannot well be meant: speeds, directions and areas that have slipped."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from gantline.assembly.afloat.hulls import afloat_path
from gantline.assembly.afloat.vessels import vessel_hull
from gantline.assembly.loads.cells import seen
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.parts import Parts
from gantline.scenario import Scenario
from gantline.scenario.afloat.stream import LoadArea, Stream, StreamArea
from gantline.scenario.afloat.tanks import bodies_afloat
from gantline.scenario.cranes.crane import FixedHook
from gantline.scenario.errors import Doubt
from gantline.scenario.loads.load import Load
from gantline.units import format_quantity

__all__ = ["doubtful_streams"]

#: No wind but in the worst of storms, and no current where vessels work, is faster [m/s].
_FASTEST = {"wind": 60.0, "current": 5.0}
#: A stream meets an area that is turned from it by less than this share of a right angle, as a sine, and
#: next to nothing of its pressure is along the area's axis [1].
_ALONG = 0.02
#: An area may be so far off the box of its load [m], and all along an axis so many times the box's side [1].
_OFF, _LARGEST = 1.0, 2.0
_AXES = ("x", "y", "z")
#: A datum is in the middle of a load within this share of its sides [1].
_NEAR_MIDDLE = 0.1
#: Most of wind areas of a vessel over what its whole hull shows that way [1], A-frames, booms and cargo on
#: deck included, and the least of what its hull shows above the water.
_OF_HULL, _OF_DRY_HULL = {"x": 10.0, "y": 5.0}, 0.3


def doubtful_streams(parts: Parts, scenario: Scenario, lifted: LiftedLoad | None) -> list[Doubt]:
    """Each thing that cannot well be meant of wind and current.

    Args:
        parts: The system, with its bodies at the start.
        scenario: The lift.
        lifted: Its load; None if it has none.
    """
    streams = {"wind": scenario.wind, "current": scenario.current}
    doubts = list[Doubt]()
    for kind, stream in streams.items():
        if isinstance(stream, Stream) and stream.speed > 0.0:
            doubts += [*_fast(kind, stream), *_passing(parts, scenario, kind, stream)]
    doubts += _off_the_hull(scenario)
    doubts += _far_from_the_hull(scenario)
    doubts += _at_the_stern(scenario)
    if scenario.load is not None and lifted is not None:
        doubts += _off_the_load(scenario.load, lifted)
        doubts += _at_the_datum(scenario.load, lifted)
        doubts += _falls_that_stand(scenario, scenario.load)
    return doubts


def _falls_that_stand(scenario: Scenario, load: Load) -> Iterator[Doubt]:
    """Of fixed hooks in falls, which go up and down only, while wind pushes what hangs below them.

    On such a hook the load swings below its slings alone, and drifts by so much less.
    """
    wind = scenario.wind
    if not (isinstance(wind, Stream) and wind.speed > 0.0 and load.wind_areas):
        return
    lengths = {
        name: (crane.reeving.upper_sheaves_at or 0.0) - crane.at[2] - crane.hook_block.height
        for name, crane in (scenario.cranes or {}).items()
        if isinstance(crane, FixedHook) and crane.reeving is not None and crane.hook_block is not None
    }
    if not lengths:
        return
    longest = format_quantity(max(lengths.values()), "m", 1)
    yield Doubt(
        ("cranes", next(iter(lengths)), "reeving"),
        f"falls of a hook of 'type: fixed_hook' do not swing, {longest} long here: what the wind "
        f"pushes swings below {', '.join(lengths)} on its slings alone, faster and less far than it would; "
        "hooks of trolleys and booms swing",
    )


def _fast(kind: str, stream: Stream) -> Iterator[Doubt]:
    if stream.speed > _FASTEST[kind]:
        speed, most = (format_quantity(one, "m/s", 1) for one in (stream.speed, _FASTEST[kind]))
        sentence = f"the {kind} of {speed} is faster than {most}; a unit has slipped, m/s for km/h"
        yield Doubt((kind,), sentence)


def _passing(parts: Parts, scenario: Scenario, kind: str, stream: Stream) -> Iterator[Doubt]:
    """Of bodies all of whose areas lie along the stream at the start: it passes them and pushes nothing."""
    bodies: dict[str, Mapping[str, StreamArea | LoadArea] | None] = {
        name: getattr(body, f"{kind}_areas") for name, body in bodies_afloat(scenario).items()
    }
    if scenario.load is not None:
        bodies[scenario.load.name] = getattr(scenario.load, f"{kind}_areas")
    towards = np.array(stream.velocity) / stream.speed
    for name, areas in bodies.items():
        if not areas:
            continue
        turned = parts.pose(name)[1]
        met = [abs(float(turned[:, _AXES.index(area.along)] @ towards)) for area in areas.values()]
        if max(met) < _ALONG:
            direction = format_quantity(stream.direction, "deg", 0)
            what = f"the {kind} towards {direction} pushes {name} nowhere at the start"
            sentence = f"{what}: all of its '{kind}_areas' lie along it; see 'direction' and 'along'"
            yield Doubt((kind,), sentence)


def _off_the_hull(scenario: Scenario) -> Iterator[Doubt]:
    """Of wind areas of vessels that no vessel with its hull has."""
    for name, vessel in (scenario.vessels or {}).items():
        length, breadth, depth = np.ptp(vessel_hull(scenario, name, vessel).box, axis=0)
        for along, across in (("x", float(breadth)), ("y", float(length))):
            whole = sum(one.area for one in (vessel.wind_areas or {}).values() if one.along == along)
            most = _OF_HULL[along] * across * depth
            least = _OF_DRY_HULL * across * max(depth - vessel.draft, 0.0)
            if whole > most or 0.0 < whole < least:
                dry = f"{across * (depth - vessel.draft):.4g} m^2 above water"
                hull = f"its hull {across * depth:.4g} m^2, {dry}"
                sentence = f"{name} has {whole:.4g} m^2 of wind areas along {along}, and {hull}"
                yield Doubt((*afloat_path(scenario, name), "wind_areas"), f"{sentence}; a number has slipped")


def _far_from_the_hull(scenario: Scenario) -> Iterator[Doubt]:
    """Of areas of vessels where nothing of them can be: they heel, trim and turn her by a lever that is none.

    Masts, booms and cargo are farther from a hull than half its length only where cranes have longer booms,
    or a mass is given there.
    """
    booms = [crane.boom.length for crane in (scenario.cranes or {}).values() if hasattr(crane, "boom")]
    for name, vessel in (scenario.vessels or {}).items():
        box = vessel_hull(scenario, name, vessel).box
        room = max([0.5 * float(np.ptp(box, axis=0).max()), *booms])
        masses = [one.at for one in (vessel.masses or {}).values()]
        low, high = np.min([box[0], *masses], axis=0), np.max([box[1], *masses], axis=0)
        for kind in ("wind", "current"):
            for key, area in (getattr(vessel, f"{kind}_areas") or {}).items():
                off = float(np.max(np.maximum(low - area.at, np.array(area.at) - high)))
                if off > room:
                    far = format_quantity(off, "m", 1)
                    sentence = f"the {kind} area {key} of {name} pushes {far} off her hull"
                    path = (*afloat_path(scenario, name), f"{kind}_areas", key)
                    yield Doubt(path, f"{sentence} and all masses; a unit or digit has slipped")


def _at_the_stern(scenario: Scenario) -> Iterator[Doubt]:
    """Of areas across a vessel that say nothing of where they are: they turn her, and heel her otherwise.

    A stream that meets a side pushes it near its middle; what nobody has placed pushes where axes begin.
    """
    for name in scenario.vessels or {}:
        vessel, path = (scenario.vessels or {})[name], afloat_path(scenario, name)
        for kind in ("wind", "current"):
            for key, area in (getattr(vessel, f"{kind}_areas") or {}).items():
                if area.along == "y" and "at" not in area.model_fields_set:
                    where = "at her stern and on her keel, where the axes of a vessel begin"
                    sentence = f"the {kind} area {key} of {name} has no 'at', and pushes {where}"
                    yield Doubt((*path, f"{kind}_areas", key), f"{sentence}: say where its middle is")


def _at_the_datum(load: Load, lifted: LiftedLoad) -> Iterator[Doubt]:
    """Of areas along x or y that say nothing of where they are, on a load whose datum is not in its middle.

    Pushed at its foot a load that stands does not lean on its lee side, and one that hangs leans too much.
    """
    corners = lifted.corners + lifted.centre
    low, high = corners.min(axis=0), corners.max(axis=0)
    off = 0.5 * (low + high)
    for kind in ("wind", "current"):
        for name, area in (getattr(load, f"{kind}_areas") or {}).items():
            across = [axis for axis in range(3) if _AXES[axis] != area.along]
            is_placed = area.area is None or area.at is not None or area.coefficient == 0.0
            is_near = bool(np.all(np.abs(off[across]) < _NEAR_MIDDLE * (high - low)[across]))
            if is_placed or is_near or area.along == "z":
                continue
            far = format_quantity(float(np.linalg.norm(off[across])), "m", 2)
            where = f"at the datum, {far} from the middle of what the load shows"
            sentence = f"the {kind} area {name} of {load.name} has no 'at', and pushes {where}"
            yield Doubt(("load", f"{kind}_areas", name), f"{sentence}: say where its middle is")


def _off_the_load(load: Load, lifted: LiftedLoad) -> Iterator[Doubt]:
    """Of areas that the load's box has no room for, or that push where the load is not."""
    corners = lifted.corners + lifted.centre
    low, high = corners.min(axis=0), corners.max(axis=0)
    sides = seen(load, lifted.body.box)
    for kind, areas in (("wind", load.areas_in("wind")), ("current", load.areas_in("current"))):
        for name, area in areas.items():
            off = float(np.max(np.maximum(low - area.at, np.array(area.at) - high)))
            if off > _OFF:
                sentence = f"the {kind} area {name} of {load.name} pushes {off:.3g} m outside the load's box"
                yield Doubt(("load", f"{kind}_areas", name), sentence)
        for axis, along in enumerate(_AXES):
            whole = sum(area.area for area in areas.values() if area.along == along)
            side = float(sides[axis])
            if whole > _LARGEST * side:
                shown = f"{whole:.4g} m^2 of {kind} areas along {along}"
                own = "its box" if load.shape.cylinder is None else "all that it shows there is"
                sentence = f"{load.name} has {shown}, and {own} {side:.4g} m^2; a number has slipped"
                yield Doubt(("load", f"{kind}_areas"), sentence)
