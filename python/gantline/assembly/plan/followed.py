"""What a trolley, crane or boom follows that keeps falls plumb, as the core reads it."""

from __future__ import annotations

import numpy as np

from gantline.assembly.cranes.reeving import upper_sheaves
from gantline.assembly.parts import Json, Parts
from gantline.assembly.plan.parting import pieces_of
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.boom import FloatingCrane
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.cranes.kept_plumb import hooks_beside, slings_under
from gantline.scenario.plan.movers import Mover, mover
from gantline.scenario.plan.steps import AlongStep
from gantline.scenario.rigging import SlingRigging

__all__ = ["followed"]

#: Time between looks, on land and about that where a crane floats [s].
_LOOKS, _LOOKS_AFLOAT = 1.0, 10.0
#: Glances of which such a look is the mean, so that vessels may pitch and loads swing in between.
_GLANCES_AFLOAT = 10


def followed(
    scenario: Scenario, rigging: Rigging, parts: Parts, step: AlongStep, hooks: tuple[str, ...]
) -> Json:
    """The end of a step that follows.

    Args:
        scenario: the lift.
        rigging: who carries whom.
        parts: the system, all but its plan.
        step: the step.
        hooks: whose falls it keeps plumb, checked with the file.
    """
    one = mover(scenario, step.kind, step.moved[0])
    assert one is not None  # checked with the file
    others = hooks_beside(scenario, rigging, one)
    own = [full_name(text, scenario.hooks) or text for text in hooks]
    every, glances = _looks(scenario, [*own, *others])
    return {
        "type": "follow",
        "way": _way(scenario, one, own),
        "every": every,
        "glances": glances,
        "own": [_lead(scenario, rigging, parts, name) for name in own],
        "others": [_lead(scenario, rigging, parts, name) for name in others],
    }


def _looks(scenario: Scenario, hooks: list[str]) -> tuple[float, int]:
    """Time between looks [s], and of how many glances each is the mean.

    Where a crane among them floats the time is longer than vessels take to pitch and roll: a boom that goes
    along with every pitch pushes its vessel a quarter of a period later, and shakes it up. In waves it is a
    whole number of periods of the highest, whose mean is none.
    """
    cranes = [(scenario.cranes or {})[scenario.hooks[name].crane] for name in hooks]
    is_afloat = any(isinstance(crane, FloatingCrane) and crane.vessel is not None for crane in cranes)
    if not is_afloat:
        return _LOOKS, 1
    waves = (scenario.waves or {}).values()
    highest = max(waves, key=lambda train: train.main_height, default=None)
    if highest is None:
        return _LOOKS_AFLOAT, _GLANCES_AFLOAT
    period = highest.main_period
    return max(round(_LOOKS_AFLOAT / period), 1) * period, _GLANCES_AFLOAT


def _way(scenario: Scenario, one: Mover, own: list[str]) -> Json:
    """How what moves takes its hooks along: at a boom where their sheave blocks are pinned to its head."""
    carriers = [hook.carrier for name in own if (hook := scenario.hooks[name]).carrier is not None]
    assert carriers[0] is not None  # what moves takes them along
    at = [0.0, 0.0, 0.0]
    if carriers[0].kind == "boom":
        at = np.mean([scenario.hooks[name].pin for name in own], axis=0).tolist()
    found: Json = {"carried": [carriers[0].name, at], "tackles": None}
    placed = next((boom for boom in scenario.booms.values() if boom.name == one.name), None)
    if placed is not None and placed.tackles is not None:
        (x, _, z), middle = placed.tackles.from_, placed.heel[1]
        top, head = [placed.base, [x, middle, z]], [placed.name, [placed.boom.length, 0.0, 0.0]]
        found["tackles"] = {"turns": placed.name, "top": top, "head": head}
    return found


def _lead(scenario: Scenario, rigging: Rigging, parts: Parts, name: str) -> Json:
    """A hook with its falls, where it has any, and all slings down to the load."""
    hook = scenario.hooks[name]
    at = [name, [0.0, 0.0, 0.0]]
    tip = at if hook.reeving is None else [upper_sheaves(name), [0.0, 0.0, 0.0]]
    levels = []
    level = slings_under(rigging, name)
    while level:
        levels.append([_strand(parts, sling) for sling in level])
        ends = [end for sling in level for end in sling.ends]
        held = {end.held for end in ends} - {None}
        level = [one for one in rigging.slings.values() if one.above in held]
    return {"tip": tip, "hook": at, "levels": levels}


def _strand(parts: Parts, sling: SlingRigging) -> Json:
    """A sling as it pulls what hangs below it; one that runs over a sheave does so with both ends."""
    pieces = pieces_of(parts, f"sling.{sling.name}")
    first, last = pieces[0]["route"], pieces[-1]["route"]
    upper = [first[0]["body"], first[0]["at"]] if sling.over is None else [sling.over, [0.0, 0.0, 0.0]]
    lower = last[-1:] if sling.over is None else [first[0], last[-1]]
    return {
        "rope": pieces[0]["name"],
        "upper": upper,
        "lower": [[end["body"], end["at"]] for end in lower],
    }
