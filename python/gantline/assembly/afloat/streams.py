"""Air and water that push on areas of bodies, standing or streaming, into forces."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from gantline.assembly.afloat.gusts import gusts, wind_of_limit
from gantline.assembly.cranes.boom import boom_top
from gantline.assembly.doubts.streams import doubtful_streams
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.parts import Json, Parts
from gantline.hydro.wind import WindProfile
from gantline.scenario import Scenario
from gantline.scenario.afloat.stream import AIR, StreamArea, Wind
from gantline.scenario.afloat.tanks import bodies_afloat
from gantline.scenario.afloat.water import Water
from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.crawler import Crawler
from gantline.scenario.errors import Doubt
from gantline.units import format_quantity

__all__ = ["add_streams"]

#: Wind in which cranes with booms lift, where nothing else is known [m/s]: ISO 4302, the lightest in service.
_LIFTS_UP_TO = 14.0
_AXES = ("x", "y", "z")
_STANDS = (0.0, 0.0, 0.0)


class _Fluid(NamedTuple):
    """Air or water: density [kg/m^3], velocity, in gusts the mean [m/s], what else forces know of it."""

    density: float
    velocity: tuple[float, float, float] = _STANDS
    beside: Mapping[str, Any] = MappingProxyType({})


def add_streams(parts: Parts, scenario: Scenario, lifted: LiftedLoad | None) -> None:
    """Add a force for each area of vessels, plain bodies and the load; warn of a stream that does nothing."""
    origins = {name: (body, np.zeros(3)) for name, body in bodies_afloat(scenario).items()}
    wind, current = scenario.wind, scenario.current
    air = _Fluid(AIR)
    if isinstance(wind, Wind):
        gusty: Json = {} if wind.gusts is None else {"gusty": True}
        air = _Fluid(wind.density, wind.velocity, {**_growing(scenario.wind_profile), **gusty})
        parts.gusts = None if wind.gusts is None else gusts(wind)
    water = _Fluid((scenario.water or Water()).density, _STANDS if current is None else current.velocity)
    for name, (body, origin) in origins.items():
        parts.forces += _pushed(name, "wind", body.wind_areas, origin, air)
        parts.forces += _pushed(name, "current", body.current_areas, origin, water)
    if scenario.load is not None and lifted is not None:
        load, origin = scenario.load, lifted.centre
        parts.forces += _pushed(load.name, "wind", load.areas_in("wind"), origin, air)
        parts.forces += _pushed(load.name, "current", load.areas_in("current"), origin, water)
    parts.doubts += _idle(parts, scenario) + _strong(parts, scenario)
    parts.doubts += doubtful_streams(parts, scenario, lifted)


def _growing(profile: WindProfile | None) -> Json:
    """How wind grows with height, as the core has it."""
    if profile is None:
        return {}
    by = {"power": profile.exponent} if profile.roughness is None else {"logarithm": profile.roughness}
    heights = {"level": profile.level, "height": profile.height, "lowest": profile.lowest}
    return {"profile": {**heights, "growth": by}}


def _idle(parts: Parts, scenario: Scenario) -> list[Doubt]:
    """Wind and current of the lift file that change nothing in it."""
    wind, found = scenario.wind, list[Doubt]()
    has_limit = any(getattr(crane, "wind_limit", None) for crane in (scenario.cranes or {}).values())
    speeds = {"current": 0.0 if scenario.current is None else scenario.current.speed}
    if isinstance(wind, Wind):
        speeds["wind"] = wind.speed
    elif isinstance(wind, float) and wind > 0.0 and not has_limit:
        sentence = (
            f"{_shown('wind', wind)} pushes nothing, being a speed without a direction, and no crane has a "
            "'wind_limit' that it is held against"
        )
        found.append(Doubt(("wind",), sentence))
    for kind, speed in speeds.items():
        pushes = any(f".{kind}_areas." in str(force["name"]) for force in parts.forces)
        pushes |= kind == "current" and scenario.load is not None and scenario.load.in_water is not None
        left = _left_out(scenario, kind)
        if speed > 0.0 and not pushes:
            sentence = f"{_shown(kind, speed)} pushes nothing: no body has '{kind}_areas'"
            found.append(Doubt((kind,), sentence))
        elif speed > 0.0 and left:
            sentence = f"{_shown(kind, speed)} does not push {', '.join(left)}, without '{kind}_areas'"
            right = "give them, or one with a coefficient of 0 where that is meant"
            found.append(Doubt((kind,), f"{sentence}: {right}"))
    return found


def _left_out(scenario: Scenario, kind: str) -> list[str]:
    """What wind or current would push most, and does not for want of a word: the load, and vessels in water.

    What a vessel that moves as given feels changes nothing.
    """
    if kind == "wind":
        load = scenario.load
        return [load.name] if load is not None and load.wind_areas is None else []
    vessels = (scenario.vessels or {}).items()
    return [name for name, one in vessels if one.current_areas is None and one.wave_motion is None]


def _strong(parts: Parts, scenario: Scenario) -> list[Doubt]:
    """Wind in which cranes with booms do not lift, of those without a `wind_limit`."""
    cranes = scenario.cranes or {}
    booms = {
        placed.crane: wind_of_limit(scenario, boom_top(parts, placed)) or 0.0
        for placed in scenario.booms.values()
        if isinstance(crane := cranes[placed.crane], Crawler | FloatingCrane) and crane.wind_limit is None
    }
    speed = max(booms.values(), default=0.0)
    if speed <= _LIFTS_UP_TO:
        return []
    usual = (
        f"{format_quantity(_LIFTS_UP_TO, 'm/s', 0)} is usual where their makers say nothing else (ISO 4302)"
    )
    pushed = f"does not push the booms of {', '.join(booms)} here, as it would"
    return [Doubt(("wind",), f"{_shown('wind', speed)} {pushed}; to lift in up to {usual}")]


def _shown(kind: str, speed: float) -> str:
    return f"the {kind} of {format_quantity(speed, 'm/s', 1)}"


def _pushed(
    body: str,
    kind: str,
    areas: Mapping[str, StreamArea] | None,
    origin: np.typing.NDArray[np.float64],
    fluid: _Fluid,
) -> list[Json]:
    """Forces ½ ρ C A |u| u on areas of a body, whose places count from `origin` in its axes [m]."""
    found = []
    for name, area in (areas or {}).items():
        quadratic = [0.0] * 6
        quadratic[_AXES.index(area.along)] = 0.5 * fluid.density * area.coefficient * area.area
        found.append(
            {
                "type": "drag",
                "name": f"{body}.{kind}_areas.{name}",
                "body": body,
                "at": (np.array(area.at) - origin).tolist(),
                "damping": [[0.0] * 6] * 6,
                "quadratic": quadratic,
                "stream": list(fluid.velocity),
                **fluid.beside,
            }
        )
    return found
