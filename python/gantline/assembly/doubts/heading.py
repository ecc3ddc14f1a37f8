"""Loads that are set down to their place from one hook, which lets them turn about plumb.

All slings of a hook end in its bearing, one point: they have no moment about plumb there, whatever its falls
do, as the swivel of a hook block has none. How far a load may turn is therefore what its place allows, and
how soon it has turned so far by what pushes it: from rest, with the moment M and its inertia I about plumb,

    t = sqrt(2 I ψ/M)        (TL4 of docs/concepts/tag_line.md)
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from gantline.assembly.doubts.guides import Turned, guide_fits, is_taken_along, misses
from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.loads.tops import Sides
from gantline.assembly.loads.under_load import UnderLoad, sides_in_world
from gantline.assembly.parts import Parts
from gantline.assembly.plain import ropes_ending_at, ropes_over
from gantline.assembly.spatial import about_axis, rotation_matrix
from gantline.scenario import Rigging, Scenario
from gantline.scenario.afloat.stream import Wind
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.slinging import ropes_cut, slings_on
from gantline.scenario.plan.steps import HoistStep, LowerStep
from gantline.units import format_quantity

__all__ = ["doubtful_heading"]

#: Turns that are looked at, up to what anybody sees, and stops by hand, in good time [rad]; plausible.
_TURNS = tuple(math.radians(0.1 * tenth) for tenth in range(1, 51))
#: What one person pushes a hanging load with at its end [N]; plausible, no document.
_PUSH = 100.0
#: A moment of wind below this share of that of the push is not worth a word.
_LITTLE = 0.1


def doubtful_heading(
    parts: Parts,
    scenario: Scenario,
    rigging: Rigging,
    lifted: LiftedLoad | None,
    under: Sequence[UnderLoad],
) -> Iterator[Doubt]:
    """A load that one hook sets down where it may turn by less than 5 deg, and that nothing holds.

    Supports count where no step takes the load elsewhere; landing guides do there too, as if it came down on
    the middle of them. Nothing is said with tag lines, hinges, or ropes of `mechanics` at the load.

    Args:
        parts: The system, with all its bodies.
        scenario: The lift.
        rigging: Who carries whom.
        lifted: The load with what is lumped on it; None for none.
        under: Its supports.
    """
    load = scenario.load
    if lifted is None or load is None or scenario.hinges:
        return
    if ropes_ending_at(scenario, load.name) or ropes_over(scenario, load.name):
        return
    set_down = _set_down(scenario, rigging)
    if set_down is None:
        return
    place, hook = set_down
    found = _first_lost(parts, scenario, lifted, under)
    if found is None:
        return
    turn, lost = found
    inertia = float(lifted.inertia[2, 2])
    arm = float(np.linalg.norm(lifted.corners[:, :2], axis=1).max())
    by = format_quantity(turn, "deg", 1)
    free = f"nothing holds the heading of {load.name} as the one hook '{hook}' sets it down"
    pushed = f"{format_quantity(_PUSH, 'N', 0)} at its end, {format_quantity(arm, 'm', 1)} out, turns it so"
    far = f"{pushed} far in {_time(inertia, turn, _PUSH * arm)} from rest"
    wind = _wind_moment(scenario, lifted)
    if wind > _LITTLE * _PUSH * arm:
        moment = format_quantity(wind, "kN m", 1)
        far = f"{far}, the wind with {moment} in {_time(inertia, turn, wind)}"
    sentence = f"{free}: turned by {by}, {lost}; {far}. Tag lines hold it"
    yield Doubt(("plan", place, "lower"), sentence)


def _set_down(scenario: Scenario, rigging: Rigging) -> tuple[int, str] | None:
    """Place of the first step by which one hook alone sets the load down, and that hook; None for none.

    One that waits for what comes of it, or with landing guides any that lowers, once the load hangs: hoisted
    before, or standing on nothing as the lift begins.
    """
    load = scenario.load
    hangs = load is not None and load.stands_on is None
    lines = {f"tag.{name}" for name in scenario.tag_lines or {}}
    for place, (step, on, cut) in enumerate(
        zip(scenario.plan, slings_on(scenario), ropes_cut(scenario), strict=True)
    ):
        hangs = hangs or isinstance(step, HoistStep)
        hooks = {rigging.slings[name].hook for name in on}
        if not hangs or len(hooks) != 1 or lines - cut or not isinstance(step, LowerStep):
            continue
        [hook] = hooks
        if hook in full_names(step.lower, scenario.hooks) and (scenario.guides or _waits(step)):
            return place, str(hook)
    return None


def _waits(step: Step) -> bool:
    """Whether a step waits for what comes as a load is set down."""
    until = step.until
    return until is not None and (
        until.supports == "touched" or until.load_transferred is not None or until.slings == "slack"
    )


def _first_lost(
    parts: Parts, scenario: Scenario, lifted: LiftedLoad, under: Sequence[UnderLoad]
) -> tuple[float, str] | None:
    """By how much the load may turn to either side until it is off its place [rad], and what is lost then."""
    load = scenario.load
    assert load is not None  # it is lifted
    centre = parts.pose(load.name)[0]
    along = is_taken_along(scenario)
    stands = [] if along else [one for one in under if one.place is not None]
    level = sides_in_world(load, lifted.body.sides).outlines if stands else ()
    before = {name for name, fit in guide_fits(parts, scenario).items() if not along and misses(fit)}
    for turn in _TURNS:
        for by in (turn, -turn):
            turned = Turned(centre, by, comes_down_on_it=along)
            fits = guide_fits(parts, scenario, turned)
            missed = [name for name, fit in fits.items() if misses(fit) and name not in before]
            if missed:
                return turn, f"it misses guide {missed[0]}"
            rotation = rotation_matrix(about_axis((0.0, 0.0, 1.0), by))
            sides = Sides(tuple((side - centre) @ rotation.T + centre for side in level))
            off = [one.support.name for one in stands if sides.over(one.pad) is None]
            if off:
                return turn, f"it is off {off[0]}"
    return None


def _wind_moment(scenario: Scenario, lifted: LiftedLoad) -> float:
    """Moment of the mean wind about plumb through the centre of gravity, still and level, by (WC1) [N m]."""
    load, wind = scenario.load, scenario.wind
    if load is None or not isinstance(wind, Wind):
        return 0.0
    aside = wind.direction - load.heading
    way = {"x": math.cos(aside), "y": math.sin(aside)}
    moment = 0.0
    for area in load.areas_in("wind").values():
        if area.along in way:
            speed = wind.speed * scenario.wind_share(load.position[2] + area.at[2])
            pressure = 0.5 * wind.density * speed**2 * area.coefficient * area.area
            force = pressure * way[area.along]
            x, y, _ = (float(part) for part in np.array(area.at) - lifted.centre)
            moment += x * force if area.along == "y" else -y * force
    return abs(moment)


def _time(inertia: float, turn: float, moment: float) -> str:
    return format_quantity(math.sqrt(2.0 * inertia * turn / moment), "s", 0)
