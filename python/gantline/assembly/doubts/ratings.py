"""Ratings and limits beyond what holds them: a decimal has slipped, and they hide what is overloaded.

Ten times too much is not beyond what has been built, as a thousand times is. But a rating stands beside the
ropes, pins and lugs that bear it, and what is more than those break at is none.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from gantline.assembly.cranes.reeving import reeved_hooks
from gantline.assembly.doubts.strength import STRONGEST
from gantline.scenario import Rigging, Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.gear import Shackle
from gantline.scenario.loads.lug import Lug
from gantline.scenario.mechanics import RopeEnd
from gantline.units import format_by_size

__all__ = ["doubtful_ratings"]

#: Hoist ropes hold some three times what is rated at least (ISO 4308-1 asks for 3.15 and more); less than
#: this is no factor [1].
_LEAST_FACTOR = 1.5
#: A spreader that may carry more than this times what the lugs above it may is one of both in error [1].
_OF_LUGS = 2.0
#: Pins of shackles are sheared in two places by 50 to 130 MPa at their limit. They break at four times that
#: at least: at more than this [Pa] beyond 1400 MPa, which no steel of pins bears in shear.
_PIN_SHEAR = 350e6
#: Bows are up to 2.1 times as thick as their pins, of the widest for slings [1].
_WIDE_BOW = 3.0
#: A lug is as thick as the jaw of its shackle at most, 1.5 diameters of the pin, so that the shackle's limit
#: presses the pin on it with some 100 MPa. Six times that is about all that plates of the strongest steel may
#: have, 0.9 of 690 MPa [1].
_OF_SHACKLES = 6.0
#: But small loads, as models in a laboratory, hang in what the shop has [kg].
_FROM_THE_SHOP = 10e3
_SLIPPED = "a unit or digit has slipped"


def doubtful_ratings(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """Each hook, drum, equalizer, spreader, lug and shackle rated for more than what bears it."""
    if scenario.simulation.gravity == 0.0:
        return  # nothing weighs anything, and no rating is a force
    yield from _hooks(scenario)
    yield from _drums(scenario)
    yield from _equalizers(scenario, rigging)
    yield from _spreaders(scenario)
    yield from _shackles(scenario)
    yield from _lugs(scenario, rigging)


def _hooks(scenario: Scenario) -> Iterator[Doubt]:
    """Hooks that may carry what their falls break at, or nearly."""
    said: set[Path] = set()
    for one in reeved_hooks(scenario):
        rated, rope = one.hook.rated_capacity, (scenario.ropes or {})[one.reeving.rope]
        path = one.hook.paths["rated_capacity"]
        if rated is None or rated > STRONGEST or rope.breaking_force is None or path in said:
            continue  # what nothing bears is told as that
        parts = one.reeving.ropes * one.reeving.parts_each
        breaks = parts * rope.breaking_force / scenario.simulation.gravity
        if breaks < _LEAST_FACTOR * rated:
            said.add(path)
            falls = f"its {parts} parts of {one.reeving.rope} break at {_mass(breaks)}"
            usual = f"3 times as much is usual at least, and {_SLIPPED}"
            yield Doubt(path, f"{one.name} may carry {_mass(rated)}, and {falls}; {usual}")


def _drums(scenario: Scenario) -> Iterator[Doubt]:
    """Winches and strand jacks of `mechanics` that may carry what the rope on them breaks at, or nearly."""
    drums = (scenario.mechanics and scenario.mechanics.drums) or {}
    ropes = (scenario.mechanics and scenario.mechanics.ropes) or {}
    wound = {
        end.drum: rope.rope
        for rope in ropes.values()
        for end in rope.route
        if isinstance(end, RopeEnd) and end.drum is not None
    }
    for drum, rope in wound.items():
        rated, force = drums[drum].rated_capacity, (scenario.ropes or {})[rope].breaking_force
        if rated is None or rated > STRONGEST or force is None:
            continue
        breaks = force / scenario.simulation.gravity
        if breaks < _LEAST_FACTOR * rated:
            holds = f"{rope}, the rope on it, breaks at {_mass(breaks)}"
            usual = f"2 to 3 times as much is usual, and {_SLIPPED}"
            sentence = f"{drum} may carry {_mass(rated)}, and {holds}; {usual}"
            yield Doubt(("mechanics", "drums", drum, "rated_capacity"), sentence)


def _equalizers(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """Equalizers that may carry what their rope breaks at, or nearly; two parts hold each moving sheave."""
    said: set[Path] = set()
    for name, equalizer in rigging.equalizers.items():
        rated, force = equalizer.rated_capacity, equalizer.rope.breaking_force
        if rated is None or force is None or not equalizer.has_sheaves:
            continue
        parts = 2 * len(equalizer.moving_sheaves.along)
        breaks = parts * force / scenario.simulation.gravity
        given = (scenario.equalizers or {})[name]
        own = given.rated_capacity is not None
        path: Path = ("equalizers", name) if own else ("equalizer_types", str(given.type))
        if breaks < _LEAST_FACTOR * rated and path not in said:
            said.add(path)
            holds = f"the {parts} parts of its rope break at {_mass(breaks)}"
            usual = f"3 times as much is usual at least, and {_SLIPPED}"
            sentence = f"{name} may carry {_mass(rated)}, and {holds}; {usual}"
            yield Doubt((*path, "rated_capacity"), sentence)


def _spreaders(scenario: Scenario) -> Iterator[Doubt]:
    """Spreaders that may carry far more than the lugs by which they hang."""
    types = scenario.lug_types or {}
    for name, spreader in (scenario.spreaders or {}).items():
        above = [one for one in spreader.lugs.values() if one.at[2] > spreader.centre_of_gravity[2]]
        capacities = [one.or_of(types.get(one.type or "")).capacity for one in above]
        known = [capacity for capacity in capacities if capacity is not None]
        if spreader.rated_capacity is None or not known or len(known) < len(capacities):
            continue
        borne = math.fsum(known)
        if spreader.rated_capacity > _OF_LUGS * borne:
            bear = f"all lugs above its middle bear {_mass(borne)}"
            sentence = f"{name} may carry {_mass(spreader.rated_capacity)}, and {bear}; {_SLIPPED}"
            yield Doubt(("spreaders", name, "rated_capacity"), sentence)


def _shackles(scenario: Scenario) -> Iterator[Doubt]:
    """Shackles whose limit no pin of theirs holds, and bows that are of no pin as thick."""
    for name, shackle in (scenario.shackles or {}).items():
        pin, bow, path = shackle.pin_diameter, shackle.bow_diameter, ("shackles", name)
        if pin is None:
            continue
        shear = shackle.working_load_limit * scenario.simulation.gravity / (2 * math.pi / 4 * pin**2)
        if shear > _PIN_SHEAR:
            sheared = f"shears its pin of {1e3 * pin:g} mm with {shear / 1e6:,.0f} N/mm^2"
            usual = f"about 100 is usual, and {_SLIPPED}"
            limit = _mass(shackle.working_load_limit)
            yield Doubt((*path, "working_load_limit"), f"{limit}, its limit, {sheared}; {usual}")
        elif bow is not None and bow > _WIDE_BOW * pin:
            wide = f"a bow of {1e3 * bow:g} mm beside a pin of {1e3 * pin:g} mm"
            yield Doubt((*path, "bow_diameter"), f"{wide}; 1 to 2 times its pin is usual, and {_SLIPPED}")


def _lugs(scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """Lugs rated for far more than the shackles pinned to them, which do not go round such plates."""
    if scenario.mechanics is not None and scenario.mechanics.ropes:
        return  # of these nothing says which lug holds them
    limits = _shackled(rigging)
    types, said = scenario.lug_types or {}, set[Path]()
    lugs: list[tuple[Path, str, str, Lug]] = []
    if scenario.load is not None:
        lugs += [(("load", "lugs", name), "", name, one) for name, one in scenario.load.lugs.items()]
    for spreader, holder in (scenario.spreaders or {}).items():
        path: Path = ("spreaders", spreader, "lugs")
        lugs += [((*path, name), spreader, name, one) for name, one in holder.lugs.items()]
    alike: dict[tuple[float, float], list[tuple[Path, str]]] = {}
    for own, holds, name, one in lugs:
        path, limit = own, limits.get((holds, name), math.inf)
        if one.capacity is None:
            path = ("lug_types", one.type or "")
        capacity = one.or_of(types.get(one.type or "")).capacity
        if capacity is None or capacity <= max(_OF_SHACKLES * limit, _FROM_THE_SHOP) or path in said:
            continue
        said.add(path)
        of = f"{holds}.{name}" if holds else name
        alike.setdefault((capacity, limit), []).append(((*path, "capacity"), of))
    for (capacity, limit), those in alike.items():
        path, first = those[0]
        of = f"lug {first} bears {_mass(capacity)}, and what is shackled to it {_mass(limit)}"
        if len(those) > 1:
            names = f"{', '.join(name for _, name in those[:-1])} and {those[-1][1]}"
            of = f"lugs {names} bear {_mass(capacity)} each, and what is shackled to each {_mass(limit)}"
        yield Doubt(path, f"{of}, {capacity / limit:.3g} times less; {_SLIPPED}")


def _shackled(rigging: Rigging) -> dict[tuple[str, str], float]:
    """What all shackles at a lug bear [kg], by the spreader, "" for the load, and the lug."""
    limits: dict[tuple[str, str], float] = {}

    def add(spreader: str, lug: str, shackle: tuple[str, Shackle] | None) -> None:
        own = math.inf if shackle is None else shackle[1].working_load_limit
        limits[spreader, lug] = limits.get((spreader, lug), 0.0) + own

    for sling in rigging.slings.values():
        if sling.spreader is not None and sling.upper_lug is not None:
            add(sling.spreader, sling.upper_lug, sling.top)
        for end in sling.ends:
            if end.lug is not None:
                add(end.spreader or "", end.lug, sling.bottom)
    return limits


def _mass(mass: float) -> str:
    return format_by_size(mass, "mass", 4)
