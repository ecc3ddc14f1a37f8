"""Loads that a plan lets down over a vessel which nothing lets them touch."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from gantline.assembly.afloat.vessels import vessel_hull
from gantline.assembly.doubts.levels import extent_of
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import Array
from gantline.scenario import Rigging, Scenario
from gantline.scenario.consistency.travel import Bounds, bounds_after
from gantline.scenario.cranes.crane import FixedHook
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.cranes.kept_plumb import slings_under
from gantline.scenario.errors import Doubt
from gantline.scenario.loads.structures import dock_of
from gantline.scenario.plan.condition import Condition
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import LedHook, gone_along, led_hook, pose_before
from gantline.scenario.plan.movers import Mover, mover
from gantline.scenario.plan.positions import Places, places_of_cranes
from gantline.scenario.plan.steps import HookStep, LineStep, LowerStep, PumpStep
from gantline.units import format_quantity

__all__ = ["doubtful_decks"]

#: A load that is let down by more than this below a deck goes through it for sure: slings stretch, and a deck
#: yields, by less [m].
_SURE = 0.5
#: A load that is taken aside by less comes down on what it came off [m].
_ASIDE = 1.0
#: Rounding of heights [m].
_ROUNDING = 1e-6


def doubtful_decks(parts: Parts, scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """The first step that lets the load down onto or through the deck of a vessel that it cannot touch.

    The deck is what of the hull is highest under the middle of the load. Asked as far as the plan says where
    hooks are: no farther than to a step that hauls or veers, takes slings off or puts them on. A load with a
    hinge is held by that.

    Args:
        parts: The system, with all its bodies, shapes and contacts.
        scenario: The lift.
        rigging: Who carries whom.
    """
    load = scenario.load
    if load is None or load.name not in parts.shapes or scenario.hinges:
        return
    decks = {
        name: vessel_hull(scenario, name, vessel)
        for name, vessel in (scenario.vessels or {}).items()
        if not _touch(parts, load.name, name)
    }
    low, high = extent_of(parts, parts.shapes[load.name])
    middle = np.array([*(low[:2] + high[:2]) / 2, low[2]])
    before = places_of_cranes(scenario) if decks else []
    for place, up in _let_down(scenario, rigging, before):
        step, aside = scenario.plan[place], _aside(scenario, rigging, before[place])
        if aside is None:
            continue
        is_aside = float(np.hypot(*aside)) > _ASIDE
        for name, hull in decks.items():
            origin, turn = parts.pose(name)
            x, y, under = turn.T @ (middle + np.array([*aside, 0.0]) - origin)
            deck = hull.top_at(x, y)
            if deck is None:
                continue
            over = float(under - deck)
            if not (is_aside or (load.stands_on is None and over > -_ROUNDING)):
                continue
            if _bears_higher(parts, scenario, np.array([*middle[:2] + aside, low[2] - over])):
                continue
            deep = -(over + up)
            if _waits_for_it(step.until):
                does = f"step '{step.step}' waits for {load.name} to stand on {name}"
            elif deep > _SURE:
                lets = f"step '{step.step}' lets {load.name} down over {name}"
                does = f"{lets}, to {format_quantity(deep, 'm', 2)} below her deck or deeper"
            else:
                continue
            why = "and nothing lets them touch: a load goes through hulls and decks"
            right = (
                f"'on_deck: {{between: [{load.name}, {name}], …}}' under 'body_contacts' of 'mechanics' does"
            )
            yield Doubt(("plan", place, "lower"), f"{does}, {why}; {right}")
            return


def _touch(parts: Parts, load: str, vessel: str) -> bool:
    """Whether the load may touch a vessel, or anything that goes with her."""

    def is_of_her(body: str | None) -> bool:
        while body is not None and body != vessel:
            body = parts.bodies[body]["parent"]
        return body is not None

    pairs = [{parts.shapes[shape]["body"] for shape in pair["shapes"]} for pair in parts.pairs]
    pairs += [{one["body"], one.get("plane_body")} for one in parts.contacts]
    return any(load in pair and any(map(is_of_her, pair - {load})) for pair in pairs)


def _bears_higher(parts: Parts, scenario: Scenario, place: Array) -> bool:
    """Whether what is over a place on deck (3,) lets the load touch it, such as a platform, or the ground."""
    load = "" if scenario.load is None else scenario.load.name
    if scenario.ground is not None and dock_of(scenario) is None and scenario.ground.level > place[2]:
        return True
    for pair in parts.pairs:
        shapes = [parts.shapes[shape] for shape in pair["shapes"]]
        others = [shape for shape in shapes if shape["body"] != load]
        if len(others) != 1:
            continue
        bottom, top = extent_of(parts, others[0])
        if (bottom[:2] < place[:2]).all() and (place < top).all():
            return True
    return False


def _waits_for_it(until: Condition | None) -> bool:
    """Whether a step that lowers waits for what comes as a load is set down."""
    return until is not None and (
        until.supports == "touched" or until.load_transferred is not None or until.slings == "slack"
    )


def _let_down(scenario: Scenario, rigging: Rigging, before: Sequence[Places]) -> Iterator[tuple[int, float]]:
    """Places of the steps that lower hooks of the load, and how far up the highest is then at most [m].

    Over its start: a load whose slings are slack at first is lower. Vessels that have been pumped out or full
    float elsewhere, and nobody knows how far it is over them.
    """
    holding = {name for name in scenario.hooks if slings_under(rigging, name)}
    hoists = [one for name in holding if (one := mover(scenario, "hook", name)) is not None]
    starts = {one.name: one.start for one in hoists if one.start is not None}
    where: dict[str, Bounds] = {name: (start, start) for name, start in starts.items()}
    is_pumped = False
    for place, step in enumerate(scenario.plan[: len(before)]):
        if step.attach or step.detach or step.cut or isinstance(step, LineStep):
            return
        is_pumped = is_pumped or isinstance(step, PumpStep)
        if isinstance(step, LeadStep):
            for gone in gone_along(scenario, step, before[place]):
                name, up = gone.led.hoist.name, gone.hoisted[-1]
                where |= {name: (where[name][0] + up, where[name][1] + up)} if name in where else {}
        if not isinstance(step, HookStep) or not (moved := {*full_names(step.moved, starts)}):
            continue
        rises = {one.name: _rise(one, before[place + 1]) for one in hoists}
        where |= {name: bounds_after(step, where[name], rises[name]) for name in moved}
        if isinstance(step, LowerStep):
            stays = 0.0 if len(starts) < len(holding) else -math.inf
            ups = [where[name][1] + rises[name] - start for name, start in starts.items()]
            yield place, math.inf if is_pumped else max(stays, *ups)


def _rise(hoist: Mover, places: Places) -> float:
    """How far where a hook hangs has gone up [m]; infinite where nobody knows."""
    if hoist.head is None:
        return 0.0
    angle, is_known = places[hoist.head.boom]
    return hoist.head.rise(angle) if is_known else math.inf


def _aside(scenario: Scenario, rigging: Rigging, places: Places) -> Array | None:
    """How far the hooks of the load have gone, on average, from above (2,) [m]; None where nobody knows."""
    start, gone = places_of_cranes(scenario)[0], []
    for name in scenario.hooks:
        if not slings_under(rigging, name):
            continue
        crane, led = scenario.hooks[name].crane, led_hook(scenario, name)
        if isinstance((scenario.cranes or {})[crane], FixedHook):
            gone.append(np.zeros(2))
            continue
        if led is None or not all(places[one][1] for one in _of_crane(led)):
            return None
        gone.append(np.subtract(led.place(pose_before(led, places)), led.place(pose_before(led, start))))
    return np.mean(gone, axis=0) if gone else None


def _of_crane(led: LedHook) -> list[str]:
    """What takes a hook of a crane along, by name."""
    return [one.name for one in (led.boom, led.upper, led.track) if one is not None]
