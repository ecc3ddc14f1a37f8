"""Strengths, ratings, speeds and limits that nothing has: a unit has slipped, and they let everything pass.

What is a thousand times too weak fails in the first run, and is seen. What is a thousand times too strong is
never seen again: a hook of 400 000 t has room for every load. Bounds lie well beyond what has been built.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import TypeAlias

from gantline.scenario import Rigging, Scenario
from gantline.scenario.base import Element
from gantline.scenario.errors import Doubt
from gantline.scenario.findings import Path
from gantline.scenario.plan.bounds import Bound
from gantline.units import format_by_size, format_quantity

__all__ = ["FARTHEST", "STRONGEST", "doubtful_strength"]

#: The largest cranes afloat and gantries lift 20 000 t; nothing that is hung in a crane bears more [kg].
STRONGEST = 25e6
#: The farthest that a crane reaches is some 200 m [m].
FARTHEST = 500.0
#: The largest shackles have limits of 3000 t; those of steel bear a thousand to three thousand times their
#: own mass, small ones of fibre fifty thousand times: 1.7 t by a loop of 6 mm HMPE, which weighs 30 g.
_STRONGEST_SHACKLE, _OF_OWN_MASS = 5e6, 100e3
#: Lugs and supports bear some of the load that they are made for; more than so often all of it is a slip [1].
_TIMES_THE_LOAD = 100.0
#: But small loads, as models in a laboratory, hang in what the shop has [kg].
_FROM_THE_SHOP = 10e3
#: No chart holds for a crane that leans, or falls that lead, by more [rad].
_MOST_LEAN = math.radians(30.0)
#: Hoists and trolleys do 2 m/s, cranes slew by 3 revolutions and luff by some ten degrees a minute. Hoists of
#: heavy cranes do 5 m/min, of which 5 m/s is the slip; those of quay cranes do 3 m/s with nothing in them.
_FASTEST: dict[tuple[str, str], tuple[float, str, str]] = {
    ("hoist", "speed"): (3.0, "m/min", "hoists do up to 120 m/min"),
    ("traverse", "speed"): (5.0, "m/min", "trolleys do up to 120 m/min"),
    ("travel", "speed"): (10.0, "m/min", "cranes travel by up to 150 m/min"),
    ("slewing", "speed"): (math.radians(6.0 * 10.0), "deg/min", "cranes slew by up to 1000 deg/min"),
    ("luffing", "speed"): (math.radians(5.0), "deg/min", "booms luff by some 10 deg/min"),
}
#: All there is is 100 %, and rules for proof loads allow half as much more; a limit beyond this is none [1].
_MOST_SHARE = 2.0
#: Limits that are angles, and what nothing comes to that has not failed long before [deg]: loads are upended
#: and turned, but vessels lean, falls lead and ropes come onto their drum by a few degrees; level slings bear
#: nothing, and from plates there are no more than 90 deg.
_ANGLES = {
    "heel": 30.0,
    "trim": 30.0,
    "load_tilt": 180.0,
    "load_yaw": 180.0,
    "spreader_tilt": 90.0,
    "equalizer_tilt": 90.0,
    "falls_out_of_plumb": 30.0,
    "off_lead": 30.0,
    "side_lead": 30.0,
    "sling_angle_from_vertical": 89.0,
    "lug_out_of_plane_angle": 90.0,
    "fleet_angle": 30.0,
    "drum_fleet_angle": 30.0,
}
#: A distance that is kept and is less is no distance [m]; of models, less than this share of the load's
#: longest side [1].
_LEAST_KEPT, _LEAST_OF_LOAD = 5e-3, 1e-3
#: Slings that lie nearly level, and hooks that pull at each other, bear some times all of the load; a force
#: that has to stay below more of it is no bound [1].
_OF_ALL_THE_LOAD = 20.0
#: Slings that stay taut bear some thousandths of the load; one with less of it is as good as slack [1].
_LEAST_TAUT = 3e-5
#: Moving sheaves travel by some metres [m].
_FARTHEST_SHEAVE = 20.0
#: Ground and supports come to rest within some ten milliseconds [s].
_LONGEST_DAMPING = 1.0
_SLIPPED = "a unit or digit has slipped"
#: Share of a side of the load within which its centre of gravity is known, plus and minus [1]; of a thin
#: panel a share of its longest side, since all margins of a weight report are often one.
_LEAST_KNOWN, _OF_LONGEST = 0.5, 0.1

#: What a lift file says: path, the mapping that it stands in, key, value.
_Said: TypeAlias = tuple[Path, Element, str, object]


def doubtful_strength(scenario: Scenario, rigging: Rigging) -> list[Doubt]:
    """Each strength, rating, speed and limit that hides what it should show."""
    found: list[Doubt] = []
    values = list(_values(scenario, ()))
    for path, element, key, value in values:
        found += _of_value(path, element, key, value)
    return [
        *found,
        *_shackles(scenario),
        *_beside_the_load(scenario, values),
        *_limits(scenario),
        *_travels(rigging),
        *_contacts(scenario),
        *_distances(scenario),
        *_centre(scenario),
    ]


def _values(element: Element, path: Path) -> Iterator[_Said]:
    """Everything that a lift file says below a mapping: path, the mapping that it stands in, key, value."""
    for name, field in type(element).model_fields.items():
        if name not in element.model_fields_set:
            continue
        key = field.alias or name
        yield from _below((*path, key), element, key, getattr(element, name))


def _below(path: Path, element: Element, key: str, value: object) -> Iterator[_Said]:
    if isinstance(value, Element):
        yield from _values(value, path)
    elif isinstance(value, Mapping):
        for name, one in value.items():
            yield from _below((*path, name), element, str(name), one)
    elif isinstance(value, (list, tuple)) and any(isinstance(one, Element) for one in value):
        for place, one in enumerate(value):
            yield from _below((*path, place), element, key, one)
    else:
        yield path, element, key, value


def _of_value(path: Path, element: Element, key: str, value: object) -> Iterator[Doubt]:
    most = max(value) if isinstance(value, tuple) and value and isinstance(value[0], float) else value
    if not isinstance(most, float):
        return
    is_of_chart = element.what == "a rating chart"
    if key == "rated_capacity" or (is_of_chart and key == "rated"):
        if most > STRONGEST:
            yield Doubt(path, f"{_mass(most)}: no crane, hook or frame bears more than 20000 t; {_SLIPPED}")
    elif is_of_chart and key in ("radius", "outreach") and most > FARTHEST:
        yield Doubt(path, f"{most:g} m: no crane reaches farther than 200 m; {_SLIPPED}")
    elif is_of_chart and key in ("heel", "trim", "off_lead", "side_lead") and most > _MOST_LEAN:
        leans = format_quantity(most, "deg", 0)
        yield Doubt(path, f"{leans}: no chart holds so far, and a few degrees are usual; {_SLIPPED}")
    elif key == "spare_turns" and 0.0 < most < 1.0:
        yield Doubt(path, f"{most:g}: less than one turn holds no rope on its drum; 3 are usual")
    elif len(path) > 1 and (of := (str(path[-2]), key)) in _FASTEST:
        fastest, unit, usual = _FASTEST[of]
        if most > fastest:
            yield Doubt(path, f"{format_quantity(most, unit, 0)}: {usual}; {_SLIPPED}")


def _shackles(scenario: Scenario) -> Iterator[Doubt]:
    for name, shackle in (scenario.shackles or {}).items():
        limit, own = shackle.working_load_limit, shackle.mass
        path = ("shackles", name, "working_load_limit")
        if limit > _STRONGEST_SHACKLE:
            yield Doubt(path, f"{_mass(limit)}: no shackle bears more than 3000 t; {_SLIPPED}")
        elif own > 0.0 and limit > _OF_OWN_MASS * own:
            sentence = (
                f"a shackle of {_mass(own)} that bears {_mass(limit)}, {limit / own:,.0f} times as much"
            )
            yield Doubt(path, f"{sentence}; 500 to 3000 times are usual of steel, and {_SLIPPED}")


def _beside_the_load(scenario: Scenario, values: Iterable[_Said]) -> Iterator[Doubt]:
    """Lugs and supports that bear far more than all of the load."""
    load = scenario.load
    if load is None:
        return
    for path, _, key, value in values:
        is_beside = path[0] in ("supports", "lug_types") or path[:2] == ("load", "lugs")
        if is_beside and key == "capacity" and isinstance(value, float):
            times = value / (load.weight.design + load.room)
            if times > _TIMES_THE_LOAD and value > _FROM_THE_SHOP:
                yield Doubt(path, f"{_mass(value)}: {times:,.0f} times all of the load; {_SLIPPED}")


def _limits(scenario: Scenario) -> Iterator[Doubt]:
    """Limits, and bounds that steps require, that nothing can be over."""
    limits = scenario.limits
    of_lift = () if limits is None else ((key, getattr(limits, key)) for key in type(limits).model_fields)
    for key, value in of_lift:
        if isinstance(value, float):
            yield from _limit(("limits", key), key, value)
    for place, step in enumerate(scenario.plan):
        require = step.require
        for key in () if require is None else type(require).model_fields:
            bound = getattr(require, key)
            if isinstance(bound, Bound):
                path = ("plan", place, "require", key)
                yield from _limit(path, key, bound.value) if bound.relation == "below" else ()
                yield from _required(scenario, path, key, bound)
    if limits is not None and (least := limits.smallest_sling_tension_when_clear) is not None:
        kept = ("limits", "smallest_sling_tension_when_clear")
        yield from _required(scenario, kept, "sling_tension", Bound("above", least))


def _required(scenario: Scenario, path: Path, key: str, bound: Bound) -> Iterator[Doubt]:
    """Of a bound on forces of slings or hooks that a load of this weight always keeps."""
    load = scenario.load
    if load is None or key not in ("sling_tension", "hook_load"):
        return
    weight = (load.weight.design + load.room) * scenario.simulation.gravity
    force = format_by_size(bound.value, "force", 4)
    if bound.relation == "below" and bound.value > _OF_ALL_THE_LOAD * weight:
        sentence = f"below {force} is {bound.value / weight:,.0f} times what all of the load weighs"
        yield Doubt(path, f"{sentence}, and lets everything pass; {_SLIPPED}")
    elif key == "sling_tension" and bound.relation == "above" and 0.0 < bound.value < _LEAST_TAUT * weight:
        sentence = f"above {force} is one part in {weight / bound.value:,.0f} of what the load weighs"
        yield Doubt(path, f"{sentence}: what is all but slack has that; {_SLIPPED}")


def _limit(path: Path, key: str, value: float) -> Iterator[Doubt]:
    """Of a limit by its key, a share [1] or an angle [rad]."""
    is_share = "_of_" in key or key.startswith(("equalizer_travel", "tension_spread"))
    if is_share and value > _MOST_SHARE:
        sentence = f"a limit of {format_quantity(value, '%', 0)} lets everything pass"
        yield Doubt(path, f"{sentence}; 100 % is all there is, and {_SLIPPED}")
    elif key in _ANGLES and value > math.radians(_ANGLES[key]) * (1 + 1e-9):
        sentence = f"a limit of {format_quantity(value, 'deg', 0)} lets everything pass"
        yield Doubt(path, f"{sentence}; {_SLIPPED}")


def _travels(rigging: Rigging) -> Iterator[Doubt]:
    for name, equalizer in rigging.equalizers.items():
        for way in ("up", "down"):
            travel = getattr(equalizer.travel, way)
            if travel > _FARTHEST_SHEAVE:
                sentence = f"moving sheaves of {name} that may travel {travel:g} m {way} never meet a stop"
                yield Doubt(("equalizers", name), f"{sentence}; a few metres are usual, and {_SLIPPED}")


def _contacts(scenario: Scenario) -> Iterator[Doubt]:
    """Ground and supports on which a load sinks for seconds."""
    given: list[tuple[Path, float | None, float | None]] = []
    if scenario.ground is not None:
        given.append((("ground", "damping"), scenario.ground.damping, scenario.ground.stiffness))
    for name, group in (scenario.supports or {}).items():
        given.append((("supports", name, "damping"), group.damping, group.stiffness))
    for path, damping, stiffness in given:
        if damping is not None and stiffness is not None and damping > _LONGEST_DAMPING * stiffness:
            sentence = f"it is {damping / stiffness:.3g} s times its stiffness, and gives like dough"
            yield Doubt(path, f"{sentence}; 10 ms to 20 ms are usual, and {_SLIPPED}")


def _distances(scenario: Scenario) -> Iterator[Doubt]:
    """Distances of watched pairs that are as good as none."""
    box = scenario.load.shape.sizes if scenario.load is not None else None
    least = _LEAST_KEPT if box is None else min(_LEAST_KEPT, _LEAST_OF_LOAD * max(box))
    for place, pair in enumerate(scenario.watch):
        if 0.0 < pair.smallest < least:
            sentence = f"{1e3 * pair.smallest:g} mm: that is no distance to keep; {_SLIPPED}, mm for m"
            yield Doubt(("watch", place, "smallest"), sentence)


def _centre(scenario: Scenario) -> Iterator[Doubt]:
    """Of a centre of gravity that may lie outside of the load."""
    load = scenario.load
    sizes = None if load is None else load.shape.sizes
    if load is None or sizes is None:
        return
    envelope = load.centre_of_gravity.envelope
    for axis, margin, side in zip("xyz", envelope, sizes, strict=True):
        if margin > max(_LEAST_KNOWN * side, _OF_LONGEST * max(sizes)):
            sentence = f"{margin:g} m to either side along {axis}, and the load is {side:g} m long there"
            yield Doubt(("load", "centre_of_gravity", "envelope"), f"{sentence}; {_SLIPPED}")
            return


def _mass(mass: float) -> str:
    return format_by_size(mass, "mass", 4)
