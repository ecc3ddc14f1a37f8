"""Hooks that are not above the centre of gravity of the load that they lift off.

All hooks together pull plumb only where the centre of gravity lies between them, seen from above: under one
hook, on the line between two, within the area between more. Otherwise the load comes off askew, is dragged
along what it stands on, and swings about the hooks by as much as they stand aside.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from gantline.assembly.loads.lifted import LiftedLoad, shift_by_liquid
from gantline.assembly.parts import Parts
from gantline.assembly.plain import bodies_in_hook, ropes_ending_at, ropes_over
from gantline.assembly.spatial import Array, about_axis, rotation_matrix
from gantline.scenario import Rigging, Scenario
from gantline.scenario.afloat.tanks import contents_along, load_tanks
from gantline.scenario.afloat.water import BallastTank
from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.goliath import Goliath
from gantline.scenario.cranes.hooks import Hook, full_name, full_names
from gantline.scenario.cranes.kept_plumb import is_moved_by, slings_under
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import AlongStep, HoistStep, HoldStep
from gantline.units import format_quantity

__all__ = ["doubtful_beside"]

#: How far hooks may stand aside, over their height above the centre of gravity: half a degree, at least [1].
_ASIDE = math.tan(math.radians(0.5))
#: What crews set hooks to [m], of small loads over that height [1].
_SET, _SET_OF_HEIGHT = 0.2, 0.03
#: How far heads of booms go outwards as they are loaded, over their height: a vessel trims, tracks sink [1].
_YIELDS_AFLOAT, _YIELDS_ASHORE = 0.05, 0.005
#: Newton's steps to where slings meet: digits double.
_STEPS = 8
#: A centre of gravity farther than this from the area between the lugs, over the load's smaller side [1], is
#: no mistake: one end is lifted, and the load turns about the other.
_OUTSIDE = 0.1


def doubtful_beside(
    parts: Parts, scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None
) -> Iterator[Doubt]:
    """Hooks that stand beside the centre of gravity of a load as it lifts off, with the way to go.

    What is in its tanks then counts, where that is known before. Nothing is said where one end alone is
    lifted, where what bears the hooks goes before that to where only the run knows, of a load in water or in
    a hinge, which hold a part of its weight elsewhere, or where `mechanics` hang in a hook.

    Args:
        parts: The system, with all its bodies.
        scenario: The lift.
        rigging: Who carries whom.
        lifted: The load with what is lumped on it; None for none.
    """
    load = scenario.load
    if lifted is None or load is None or load.in_water is not None or scenario.hinges:
        return
    if _stands_on(scenario, load.name) is None:
        return
    found = _lift_off(scenario, rigging)
    if found is None:
        return
    before, on = found
    names = _hooks_with(scenario, rigging, on)
    if any(_bears_mechanics(scenario, name) for name in names):
        return
    gone = {name: _gone(scenario, scenario.hooks[name], before) for name in names}
    if load.stands_on is None and any(way != (0.0, 0.0) for way in gone.values()):
        return  # it may hang at the start, touch only later, and go along
    centre, turned = parts.pose(load.name)
    filled = _filled(scenario, before)
    if filled is None:
        return
    shift = shift_by_liquid(filled, lifted.mass, lifted.centre)
    centre = centre + turned @ shift
    from_there = {name: (np.array(at) - shift).tolist() for name, at in lifted.lugs.items()}
    lifted = replace(lifted, corners=lifted.corners - shift, lugs=from_there)
    lugs = [(turned @ np.array(lifted.lugs[lug]))[:2] for lug in _lugs(rigging, on)]
    if not names or not lugs or any(way is None for way in gone.values()):
        return
    smaller = float(min(np.ptp(lifted.corners[:, :2], axis=0)))
    if np.linalg.norm(_way_into(np.zeros(2), lugs)) > _OUTSIDE * smaller:
        return
    bearings = {name: parts.pose(name)[0] + np.array((*(gone[name] or (0.0, 0.0)), 0.0)) for name in names}
    way = -_way_into(centre[:2], [place[:2] for place in bearings.values()])
    askew = _askew(rigging, centre, turned, lifted, bearings, on)
    # One that stands where the load, askew, comes off about its last corner drags nothing either.
    least = min(float(np.linalg.norm(way)), float(np.linalg.norm(way + askew)))
    most = max(
        _allowed(scenario, scenario.hooks[name], float(place[2] - centre[2]))
        for name, place in bearings.items()
    )
    if least > most:
        yield Doubt(scenario.hooks[names[0]].paths[""], _told(load.name, names, way))


def _filled(scenario: Scenario, before: Sequence[Step]) -> list[BallastTank] | None:
    """Tanks of the load with what is in them after some steps of the plan; None where that is not known."""
    contents = contents_along(scenario)[len(before)]
    found = []
    for name, tank in load_tanks(scenario).items():
        if contents[name].most > contents[name].least:
            return None
        found.append(tank.model_copy(update={"content": contents[name].least}))
    return found


def _told(load: str, names: Sequence[str], way: Array) -> str:
    """What is wrong and which way to go, along world x and y; `way` is from the hooks to the load [m]."""
    aside = format_quantity(float(np.linalg.norm(way)), "m", 2)
    ways = [
        f"{format_quantity(abs(part), 'm', 2)} along {'−' if part < 0.0 else '+'}{axis}"
        for part, axis in zip(way, "xy", strict=True)
        if abs(part) >= 5e-3
    ]
    goes = " and ".join(ways)
    hooks, stand = names[0], "stands"
    if len(names) > 1:
        hooks, stand = f"{', '.join(names[:-1])} and {names[-1]}", "stand"
        goes = f"at least {goes}"
    where = f"{hooks} {stand} {aside} beside the centre of gravity of {load} where it lifts off"
    drags = "it comes off askew, is dragged along and swings by that"
    return f"{where}: {drags}; move {hooks} {goes}, or {load} the other way"


def _stands_on(scenario: Scenario, load: str) -> str | None:
    """What a load stands on at the start; None where it hangs or floats."""
    assert scenario.load is not None  # asked of a load
    touching = (scenario.mechanics and scenario.mechanics.body_contacts) or {}
    aboard = next((name for name, contact in touching.items() if load in contact.between), None)
    return scenario.load.stands_on or aboard


def _lift_off(scenario: Scenario, rigging: Rigging) -> tuple[list[Step], frozenset[str]] | None:
    """Steps before the one that lifts the load off, and the slings that are on in it; None where none does.

    That is the first that waits until supports are clear; without one the first that hoists a hook with
    slings.
    """
    first: tuple[list[Step], frozenset[str]] | None = None
    before: list[Step] = []
    for step, on in zip(scenario.plan, slings_on(scenario), strict=True):
        if isinstance(step, HoistStep):
            names = [full_name(text, scenario.hooks) or "" for text in step.moved]
            is_slung = bool(set(names) & set(_hooks_with(scenario, rigging, on)))
            if is_slung and step.until is not None and step.until.supports == "clear":
                return list(before), on
            if is_slung and first is None:
                first = list(before), on
        before.append(step)
    return first


def _hooks_with(scenario: Scenario, rigging: Rigging, on: frozenset[str]) -> list[str]:
    """Hooks with slings that are on."""
    return [name for name in scenario.hooks if any(sling.name in on for sling in slings_under(rigging, name))]


def _lugs(rigging: Rigging, on: frozenset[str]) -> list[str]:
    return [lug for sling in rigging.slings.values() if sling.name in on for lug in sling.lugs]


def _bears_mechanics(scenario: Scenario, hook: str) -> bool:
    return any(find(scenario, hook) for find in (bodies_in_hook, ropes_ending_at, ropes_over))


def _gone(scenario: Scenario, hook: Hook, steps: Iterable[Step]) -> tuple[float, float] | None:
    """How far steps take a hook along world x and y [m]; None where that is not known before the run."""
    x = y = 0.0
    for step in steps:
        if isinstance(step, LeadStep) and hook.name in full_names(step.lead, scenario.hooks):
            return None
        if isinstance(step, HoldStep) or not isinstance(step, AlongStep):
            continue
        for text in step.moved:
            one = mover(scenario, step.kind, text)
            if one is None or not is_moved_by(one, hook):
                continue
            if not isinstance((scenario.cranes or {})[hook.crane], Goliath) or one.start is None:
                return None
            if step.by is None and step.to is None:
                return None
            along = one.kind == "trolley"
            now = x if along else y
            after = now + step.by if step.by is not None else (step.to or 0.0) - one.start
            x, y = (after, y) if along else (x, after)
    return x, y


def _allowed(scenario: Scenario, hook: Hook, height: float) -> float:
    """How far a hook may stand aside at some height above the centre of gravity [m]."""
    usual = max(_ASIDE * height, min(_SET, _SET_OF_HEIGHT * height))
    boom = scenario.booms.get(hook.crane)
    if boom is None:
        return usual
    crane = (scenario.cranes or {})[hook.crane]
    is_afloat = isinstance(crane, FloatingCrane) and crane.vessel is not None
    yields = _YIELDS_AFLOAT if is_afloat else _YIELDS_ASHORE
    return max(usual, yields * (boom.heel[2] + boom.boom.length * math.sin(boom.boom.angle)))


def _askew(
    rigging: Rigging,
    centre: Array,
    turned: Array,
    lifted: LiftedLoad,
    bearings: dict[str, Array],
    on: frozenset[str],
) -> Array:
    """From above the centre of gravity to where a hook lifts a load off that hangs askew by its slings [m].

    Level, (2,). The load then turns about the corner that hangs lowest. It is known of one hook with slings
    to lugs alone.
    """
    slings = [sling for name in bearings for sling in slings_under(rigging, name) if sling.name in on]
    is_plain = all(sling.equalizer is None and sling.spreader is None and sling.lugs for sling in slings)
    if len(bearings) > 1 or len(slings) < 2 or not is_plain:
        return np.zeros(2)
    lugs = np.array([turned @ np.array(lifted.lugs[sling.lugs[0]]) for sling in slings])
    hook = _meeting(lugs, np.array([sling.length for sling in slings]))
    plumb = hook / np.linalg.norm(hook)
    # By the least turn the hook comes plumb over the centre of gravity.
    axis = (float(plumb[1]), -float(plumb[0]), 0.0)
    if not any(axis):
        return np.zeros(2)
    turn = rotation_matrix(about_axis(axis, math.acos(min(1.0, float(plumb[2])))))
    corners = lifted.corners @ turned.T
    lowest = corners[np.argmin((corners @ turn.T)[:, 2])]
    gone: Array = (lowest - turn @ lowest)[:2]
    return gone


def _meeting(lugs: Array, lengths: Array) -> Array:
    """Where slings of given lengths [m] from lugs (slings, 3) meet above them, by least squares (3,) [m]."""
    hook: Array = lugs.mean(axis=0) + np.array((0.0, 0.0, float(lengths.mean())))
    for _ in range(_STEPS):
        ways = hook - lugs
        far = np.linalg.norm(ways, axis=1)
        step, *_ = np.linalg.lstsq(ways / far[:, None], lengths - far, rcond=None)
        hook = hook + step
    return hook


def _way_into(point: Array, places: Sequence[Array]) -> Array:
    """From a point to the nearest place of the area between places, all in a plane (2,) [m]; 0 within."""
    ways = np.array(places) - point
    directions = np.sort(np.arctan2(ways[:, 1], ways[:, 0]))
    # Within where no half plane is without a place; on an edge the nearest place is where the point is.
    if max(np.diff(directions, append=directions[0] + 2.0 * math.pi)) < math.pi:
        return np.zeros(2)
    ones, along = ways[:, None], ways - ways[:, None]
    square = np.sum(along**2, axis=2)
    share = np.clip(-np.sum(ones * along, axis=2) / np.where(square > 0.0, square, 1.0), 0.0, 1.0)
    nearest = (ones + share[:, :, None] * along).reshape(-1, 2)
    way: Array = nearest[np.argmin(np.linalg.norm(nearest, axis=1))]
    return way
