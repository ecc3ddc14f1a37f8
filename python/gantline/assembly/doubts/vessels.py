"""What cannot well be meant of vessels and their lines: inertia out of scale, damping twice, buried ends."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gantline.assembly.afloat.hulls import afloat_path
from gantline.assembly.afloat.vessels import upright_hydrostatics, vessel_hull
from gantline.assembly.parts import Parts
from gantline.assembly.plain import ropes_ending_at
from gantline.scenario import Scenario
from gantline.scenario.afloat.mooring import is_moored
from gantline.scenario.afloat.vessel import Vessel
from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.errors import Doubt
from gantline.scenario.loads.structures import Dock
from gantline.units import format_by_size, format_quantity

__all__ = ["doubtful_vessels"]

#: Radii of gyration over breadth (about x) and over length (about y and z). A solid box has 0.29, all mass at
#: both ends 0.5; masts and A-frames add to that about x.
_RADII = ((0.1, 1.0), (0.1, 0.6), (0.1, 0.6))
#: A hull is long from here on, over its breadth: what is on it has more inertia across than along it.
_LONG = 1.5
#: Added mass over what the hull displaces; that of turns over this times breadth or length squared. Barges
#: have 1 to 7 in heave, ships 0.03 in surge, round hulls little in roll; a unit slips by a thousand.
_ADDED = {
    "surge": (1e-3, 50.0),
    "sway": (5e-3, 50.0),
    "heave": (2e-2, 50.0),
    "roll": (2e-4, 10.0),
    "pitch": (5e-4, 10.0),
    "yaw": (2e-4, 10.0),
}
#: Shares of critical damping beside what `radiation` takes of a motion: what hull and lines add to that [1].
_BESIDE_WAVES = {"heave": 0.1, "pitch": 0.1, "roll": 0.2}
#: A light hull weighs a fifth of what it displaces laden; less than this share is a slip [1].
_LIGHTEST = 0.02
#: Periods of surge, sway and yaw on moorings, stiff fenders of a quay and slack chains included [s].
_PERIODS = (3.0, 600.0)
#: Lines are shorter than this times the distance of their ends, and this much more [1, m].
_SLACK = (2.0, 20.0)
#: Fairleads and turrets lie so far below a keel at the most [m].
_UNDER_KEEL = 2.0
#: Bollards stand on a quay or at its edge: no end of a line is deeper within a box than this [m].
_BURIED = 1.0


def doubtful_vessels(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """What is doubtful about each vessel and its mooring lines.

    Raises:
        ScenarioError: if the file of a hull cannot be used.
    """
    for name, vessel in (scenario.vessels or {}).items():
        path = afloat_path(scenario, name)
        length, breadth, _ = np.ptp(vessel_hull(scenario, name, vessel).box, axis=0)
        for key, sentence in (
            *_radii(vessel, float(length), float(breadth)),
            *_light(scenario, name, vessel),
            *_added(scenario, name, vessel, float(length), float(breadth)),
            *_twice(vessel),
            *_periods(vessel),
            *_high_sides(vessel, float(breadth)),
        ):
            yield Doubt((*path, *key), f"{name} {sentence}")
        yield from _under_keel(scenario, name, vessel)
    yield from _unmoored(scenario)
    yield from _buried(parts, scenario)
    yield from _long_lines(parts, scenario)


def _radii(vessel: Vessel, length: float, breadth: float) -> Iterator[tuple[tuple[str, ...], str]]:
    """Radii of gyration that no hull of this size has."""
    if vessel.is_carried:
        return
    own = vessel.own_inertia
    radii = [math.sqrt(one / vessel.mass) for one in (own.xx, own.yy, own.zz)]
    key = ("inertia",) if vessel.radii_of_gyration is None else ("radii_of_gyration",)
    shown = ", ".join(format_quantity(one, "m", 1) for one in radii)
    has = f"has radii of gyration of {shown} about x, y, z, and is {length:.4g} m long, {breadth:.4g} m wide"
    if length > _LONG * breadth and radii[0] > radii[1]:
        yield key, f"{has}: along a long hull the first is the smallest; see their order"
        return
    for radius, size, (least, most), axis in zip(
        radii, (breadth, length, length), _RADII, "xyz", strict=True
    ):
        if not least * size <= radius <= most * size:
            usual = f"{format_quantity(0.25 * size, 'm', 1)} to {format_quantity(0.45 * size, 'm', 1)}"
            usual = usual if axis == "x" else f"about {format_quantity(0.27 * size, 'm', 1)}"
            yield key, f"{has}: usual about {axis} is {usual}"
            return


def _light(scenario: Scenario, name: str, vessel: Vessel) -> Iterator[tuple[tuple[str, ...], str]]:
    """Own masses and tanks that are next to nothing of what the vessel displaces at its draft."""
    if vessel.is_carried:
        return
    own = vessel.mass + math.fsum(tank.content for tank in (vessel.tanks or {}).values())
    displaced = upright_hydrostatics(scenario, name, vessel).mass
    if own < _LIGHTEST * displaced:
        weighs, displaces = (format_by_size(one, "mass", 3) for one in (own, displaced))
        sentence = f"weighs {weighs} with its tanks, and displaces {displaces} at its draft"
        yield ("masses",), f"{sentence}: a unit has slipped, kg for t"


def _added(
    scenario: Scenario, name: str, vessel: Vessel, length: float, breadth: float
) -> Iterator[tuple[tuple[str, ...], str]]:
    """Added mass given by axes that no hull of this size has."""
    given = vessel.added_mass
    if given is None:
        return
    displaced = upright_hydrostatics(scenario, name, vessel).mass
    for key, (least, most) in _ADDED.items():
        size = {"roll": breadth, "pitch": length, "yaw": length}.get(key)
        whole = displaced * (1.0 if size is None else size**2)
        added = float(getattr(given, key))
        if added <= 0.0 or whole <= 0.0 or least <= added / whole <= most:
            continue
        has, displaces = (format_by_size(one, "mass", 3) for one in (added, displaced))
        if size is not None:
            has = f"{format_quantity(added, 't m^2', 0 if added > 1e4 else 3)}"
        sentence = f"has {has} of added mass in {key}, and displaces {displaces}"
        yield ("added_mass", key), f"{sentence} at its draft: a unit has slipped"


def _twice(vessel: Vessel) -> Iterator[tuple[tuple[str, ...], str]]:
    """Shares of critical damping as if waves took nothing, beside `radiation`, which has what they take."""
    damping = vessel.water_damping
    if vessel.radiation is None or damping is None or damping.critical is None:
        return
    for key, most in _BESIDE_WAVES.items():
        share = getattr(damping.critical, key)
        if share is not None and share > most:
            shown, usual = (format_quantity(one, "%", 0) for one in (share, most))
            sentence = f"has {shown} of critical damping in {key} beside 'radiation', which has that by waves"
            adds = f"what lines and hull add to it is less than {usual}"
            yield ("water_damping", "critical", key), f"{sentence}: {adds}"


def _periods(vessel: Vessel) -> Iterator[tuple[tuple[str, ...], str]]:
    """Periods on moorings as no moorings make them."""
    critical = None if vessel.water_damping is None else vessel.water_damping.critical
    for key in ("surge", "sway", "yaw") if critical is not None else ():
        assert critical is not None
        period = getattr(critical.periods, key)
        if period is not None and not _PERIODS[0] <= period <= _PERIODS[1]:
            sentence = f"has a period of {period:g} s in {key} on its moorings"
            right = "the last table of 'gantline statics' has the periods on its lines"
            place = ("water_damping", "critical", "periods", key)
            yield place, f"{sentence}, as no moorings make it: {right}"


def _high_sides(vessel: Vessel, breadth: float) -> Iterator[tuple[tuple[str, ...], str]]:
    """A box higher out of the water than it is wide, as none floats."""
    box, (_, _, bottom) = vessel.hull.box, vessel.hull.bottom
    if box is None:
        return
    freeboard = bottom + box[2] - vessel.draft
    if freeboard > breadth:
        high = f"has a hull that stands {format_quantity(freeboard, 'm', 1)} out of the water"
        sentence = f"{high}, and is {breadth:.4g} m wide: a digit of its depth or draft has slipped"
        yield ("hull", "box"), sentence


def _unmoored(scenario: Scenario) -> Iterator[Doubt]:
    """Vessels that no line holds beside others that are moored: what lies still on paper drifts in a run."""
    vessels = scenario.vessels or {}
    moored = [name for name in vessels if is_moored(scenario, name)]
    others = " and ".join(moored)
    for name, vessel in vessels.items():
        if not moored or name in moored or vessel.is_carried or ropes_ending_at(scenario, name):
            continue
        sentence = f"{name} is on no mooring line, as {others} is: nothing of the water holds it in plan"
        drifts = f"{sentence}, and it drifts off with what pulls or pushes it"
        yield Doubt(afloat_path(scenario, name), drifts)


def _under_keel(scenario: Scenario, name: str, vessel: Vessel) -> Iterator[Doubt]:
    """Lines and booms that begin below the keel: the sign of a height, which counts from there."""
    extent = vessel.hull.extent
    if extent is None:
        return
    keel = extent[0][2]
    for crane, given in (scenario.cranes or {}).items():
        if isinstance(given, FloatingCrane) and given.vessel == name and given.boom.heel_pins.at[2] < keel:
            below = format_quantity(keel - given.boom.heel_pins.at[2], "m", 1)
            sentence = f"the heel pins of {crane} are {below} below the keel of {name}"
            path = ("cranes", crane, "boom", "heel_pins", "at")
            yield Doubt(path, f"{sentence}; heights count up from it")
    for line, one in (scenario.mooring_lines or {}).items():
        for key, body, end in (("fairlead", one.vessel, one.fairlead), ("to", one.holder, one.to)):
            if body == name and end[2] < keel - _UNDER_KEEL:
                deep = format_quantity(keel - end[2], "m", 1)
                sentence = (
                    f"mooring line {line} ends {deep} below the keel of {name}; heights count up from it"
                )
                yield Doubt(("mooring_lines", line, key), sentence)


def _buried(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """Lines that end within a quay: the sign of a height, or one that counts from another zero."""
    solid = {name: one for name, one in (scenario.structures or {}).items() if not isinstance(one, Dock)}
    for line, given in (scenario.mooring_lines or {}).items():
        for key, body, end in (("fairlead", given.vessel, given.fairlead), ("to", given.holder, given.to)):
            at = parts.place(body, end)
            for name, one in solid.items():
                if one.depth(at.tolist()) > _BURIED:
                    below = format_quantity(one.z[1] - float(at[2]), "m", 1)
                    sentence = f"mooring line {line} ends inside {name}, {below} below its top"
                    yield Doubt(("mooring_lines", line, key), f"{sentence}, as no bollard stands")


def _long_lines(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """Mooring lines so long that they hold nothing: on a bed they lie in heaps."""
    for name, line in (scenario.mooring_lines or {}).items():
        if line.length is None:
            continue
        ends = parts.place(line.vessel, line.fairlead) - parts.place(line.holder, line.to)
        apart = float(np.linalg.norm(ends))
        if line.length > _SLACK[0] * apart + _SLACK[1]:
            sentence = f"mooring line {name} is {line.length:.5g} m long, its ends are {apart:.4g} m apart"
            yield Doubt(
                ("mooring_lines", name, "length"), f"{sentence}: it is slack, and holds next to nothing"
            )
