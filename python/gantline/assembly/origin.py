"""From an element that the core names back to the place in the lift file that it was made of."""

from __future__ import annotations

from collections.abc import Iterable

from gantline.assembly.afloat.foundering import foundered
from gantline.scenario import Scenario
from gantline.scenario.afloat.mooring import is_moored
from gantline.scenario.afloat.stream import Wind
from gantline.scenario.errors import PathPart, Problem, StartError
from gantline.scenario.failed import on_its_route
from gantline.scenario.mechanics import Mechanics
from gantline.scenario.plan.slinging import starts_off
from gantline.scenario.rigging import resolve
from gantline.units import format_quantity

__all__ = ["FALLS", "origin_of", "refused", "with_advice"]

#: What the core says of a body that nothing holds.
FALLS = "nothing holds it, it falls without end"
#: What it says where its search ends without an equilibrium, and where a stream is why.
_NO_STEP = "no step brings its forces closer to balance"
_DRIVEN = "wind, current or waves drive it over its supports, which without friction hold nothing"
#: Share of its weight with which wind pushes a load that may not rest in it [1]: 11 deg out of plumb.
_BLOWN = 0.2
#: What it says of a rope of which nothing is left between two of its guides.
_USED_UP = "the rope is hauled in until two of the places that it passes have come together"

#: Keys of the lift file whose elements bear a prefix in the core.
_PREFIXED = {
    "sling": "slings",
    "mooring": "mooring_lines",
    "tag": "tag_lines",
    "fender": "fenders",
    "support": "supports",
    "guide": "guides",
    "hoist": "cranes",
}
#: Keys whose elements, and what is made of them, bear their names.
_NAMED = (
    "vessels",
    "equalizers",
    "cranes",
    "structures",
    "extension_sheaves",
    "spreaders",
    "compensators",
    "hinges",
    "slings",
)


def refused(scenario: Scenario, message: str) -> StartError:
    """What the core refuses, at the line of the element that it names.

    Args:
        scenario: The lift.
        message: As the core says it: the element, a colon, and what is wrong; or a sentence of no element.
    """
    element, _, sentence = message.partition(": ")
    path = origin_of(scenario, element) if sentence else None
    off = sorted(starts_off(scenario)) if sentence.endswith(FALLS) else []
    if off:
        later = f"; {', '.join(off)} {'is' if len(off) == 1 else 'are'} off until 'attach' of the plan"
        sentence, message = f"{sentence}{later}", f"{message}{later}"
    sentence, message = (with_advice(scenario, element, one) for one in (sentence, message))
    if path is None:
        return StartError(str(scenario.source), [Problem(None, "", message)])
    # Of what is made of an element the name says more than the path.
    is_itself = element in (path[-1], f"{element.partition('.')[0]}.{path[-1]}")
    return scenario.start_error(path, sentence if is_itself else message)


def with_advice(scenario: Scenario, element: str, cause: str) -> str:
    """What the core says of an element, and what would be right where the lift file has that.

    Args:
        scenario: The lift.
        element: As the core names it.
        cause: Why the lift comes to rest nowhere, as the core says it.
    """
    if cause.endswith((_NO_STEP, _DRIVEN)):
        advice = _runs_up(scenario, element) + _adrift(scenario, element) + _top_heavy(scenario, element)
        return cause + advice + _blown(scenario)
    cause = on_its_route(scenario, element, cause) + foundered(scenario, element, cause)
    return cause + _runs_up(scenario, element) if cause.endswith(_USED_UP) else cause


def _runs_up(scenario: Scenario, element: str) -> str:
    """Why a sheave of an equalizer, or its rope, comes to rest nowhere, after a colon; nothing of others."""
    equalizers = resolve(scenario).equalizers
    own = next((one for name, one in equalizers.items() if element.startswith(f"{name}.")), None)
    if own is None or own.travel.stops:
        return ""
    runs_up = "a moving sheave that less hangs on than on the others runs up to the fixed ones"
    return f": {runs_up}; 'stops: true' under 'travel' ends its way, 'locked: true' holds it"


def _adrift(scenario: Scenario, element: str) -> str:
    """That no line holds a vessel, after a semicolon; nothing of others."""
    if element not in (scenario.vessels or {}) or is_moored(scenario, element):
        return ""
    return "; no mooring line leads from it to the world, nor from what its lines lead to"


def _top_heavy(scenario: Scenario, element: str) -> str:
    """By how much a load's centre of gravity is above its lugs, after a semicolon; nothing of others."""
    load = scenario.load
    if load is None or element != load.name or load.centre_of_gravity.at == "from_cad":
        return ""
    slings = [sling for sling in resolve(scenario).slings.values() if sling.starts_on]
    ends = [end for sling in slings for end in sling.ends if end.held is None]
    heights = [load.lugs[end.lug].at[2] for end in ends if end.lug is not None]
    if not heights or (above := load.centre_of_gravity.at[2] - max(heights)) <= 0.0:
        return ""
    height = format_quantity(above, "m", 2)
    lies = f"its centre of gravity is {height} above the highest lug that it hangs from"
    return f"; {lies}, so that it may turn over"


def _blown(scenario: Scenario) -> str:
    """With what wind pushes a load that it may have blown away, after a semicolon; nothing of less wind."""
    load, wind = scenario.load, scenario.wind
    if load is None or not isinstance(wind, Wind):
        return ""
    there = scenario.wind_share(load.position[2])
    push = wind.push(load.areas_in("wind"), load.heading, there)
    share = push / (load.weight.simulated * scenario.simulation.gravity)
    if share < _BLOWN:
        return ""
    speed, force = format_quantity(there * wind.speed, "m/s", 1), format_quantity(push, "kN", 0)
    return f"; the wind of {speed} pushes {load.name} with {force}, {share * 100:.0f} % of its weight"


def origin_of(scenario: Scenario, element: str) -> tuple[PathPart, ...] | None:
    """Path of the lift file that an element of the core was made of; None if none is known.

    Args:
        scenario: The lift.
        element: A body, rope, contact, drive or step as the core names it, such as `mooring.bow`.
    """
    if scenario.mechanics is not None:
        for kind in Mechanics.model_fields:
            name = _longest(element, getattr(scenario.mechanics, kind) or {})
            if name is not None:
                return "mechanics", kind, name
    prefix, _, rest = element.partition(".")
    if prefix in _PREFIXED:
        name = _longest(rest, getattr(scenario, _PREFIXED[prefix]) or {})
        if name is not None:
            return _PREFIXED[prefix], name
    for key in _NAMED:
        name = _longest(element, getattr(scenario, key) or {})
        if name is not None:
            return key, name
    if scenario.load is not None and _longest(element, [scenario.load.name]) is not None:
        return ("load",)
    steps = [step.step for step in scenario.plan]
    return ("plan", steps.index(element)) if element in steps else None


def _longest(element: str, names: Iterable[str]) -> str | None:
    """The longest of these names that an element bears, by itself or before a dot or slash."""
    borne = [name for name in names if element == name or element.startswith((f"{name}.", f"{name}/"))]
    return max(borne, key=len, default=None)
