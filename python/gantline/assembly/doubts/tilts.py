"""Steps that wait for a tilt to which no hook can bring the load, or that a limit does not allow.

A load whose lugs of one end are hoisted over those of the other turns until it hangs from the higher ones
alone, with its centre of gravity plumb below them: the slings of the lower end then bear nothing, and slings
do not push. With c the way from these lugs, or from the line through them, square to the centre of gravity,
the tilt there is the angle between -c and the load's own z axis.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import numpy as np

from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.spatial import Array
from gantline.scenario import Rigging, Scenario
from gantline.scenario.cranes.hooks import full_names
from gantline.scenario.cranes.kept_plumb import slings_under
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.plan import Step
from gantline.scenario.plan.slinging import slings_on
from gantline.scenario.plan.steps import AlongStep, HookStep
from gantline.units import format_quantity

__all__ = ["balance", "doubtful_tilt_limit", "doubtful_tilts", "lugs_under"]

#: How far beyond its balance a step has to wait before that is told [rad]: lines of lugs are not quite level.
_BEYOND = math.radians(0.5)
#: How far lugs may be from one line [m], how steep that may be in the load [1], and how far the centre of
#: gravity has to be from it [m] for the load to hang as a pendulum does.
_OFF_LINE, _STEEP, _NEAR = 0.05, 0.1, 0.2


def doubtful_tilts(scenario: Scenario, rigging: Rigging, lifted: LiftedLoad | None) -> Iterator[Doubt]:
    """Each step that hoists or lowers one end of a load, and waits for more tilt than it hangs with then.

    Nothing is said where something else turns the load: water, hinges, tanks, `mechanics`, cranes that have
    gone elsewhere than above their lugs, other slings than those of the start.

    Args:
        scenario: The lift.
        rigging: Who carries whom.
        lifted: The load.
    """
    load = scenario.load
    others = (scenario.mechanics, scenario.hinges, scenario.tag_lines, scenario.waves, scenario.vessels)
    if load is None or lifted is None or load.in_water is not None or load.tanks or any(others):
        return
    stages = [*slings_on(scenario)]
    for place, step in enumerate(scenario.plan):
        if (isinstance(step, AlongStep) and not step.keep_plumb) or stages[place] != stages[0]:
            return
        holding = {hook for hook in scenario.hooks if lugs_under(scenario, rigging, [hook], stages[place])}
        if isinstance(step, LeadStep) and holding - set(full_names(step.lead, scenario.hooks)):
            return  # hooks that lead together keep their distances
        if not isinstance(step, HookStep) or step.until is None or step.until.load_tilt is None:
            continue
        asked, moved = step.until.load_tilt.above, set(full_names(step.moved, scenario.hooks))
        higher = holding & moved if step.sign > 0 else holding - moved
        if asked is None or not higher or higher == holding:
            continue
        most = balance(lugs_under(scenario, rigging, higher, stages[place]), lifted.body.centre)
        if most is not None and asked > most + _BEYOND:
            waits = f"step '{step.step}' waits for a tilt above {format_quantity(asked, 'deg', 1)}"
            alone = f"from {' and '.join(sorted(higher))} alone"
            hangs = f"{alone} the load hangs at {format_quantity(most, 'deg', 1)}"
            slack = "the slings of its other end hang slack from there on, and the step does not end by it"
            yield Doubt(("plan", place, "until"), f"{waits}, and {hangs}: {slack}")


def doubtful_tilt_limit(scenario: Scenario) -> Iterator[Doubt]:
    """A limit of the tilt over the whole lift, of a load that a step of its plan is to tilt farther."""
    limit = None if scenario.limits is None else scenario.limits.load_tilt
    if limit is None:
        return
    beyond = next((step for step in scenario.plan if _tilts_to(step) > limit), None)
    if beyond is None:
        return
    asked, most = (format_quantity(one, "deg", 1) for one in (_tilts_to(beyond), limit))
    sentence = (
        f"{most} hold over the whole lift, and step '{beyond.step}' tilts the load to {asked}: it fails"
    )
    right = "leave it out, and let steps at whose end the load hangs level 'require' it"
    yield Doubt(("limits", "load_tilt"), f"{sentence}; {right}")


def _tilts_to(step: Step) -> float:
    """Tilt beyond which the load has to come by the end of a step [rad]; 0 of others."""
    until = getattr(step, "until", None)
    waits = None if until is None or until.load_tilt is None else until.load_tilt.above
    bound = None if step.require is None else step.require.load_tilt
    requires = bound.value if bound is not None and bound.relation == "above" else 0.0
    return max(waits or 0.0, requires)


def lugs_under(
    scenario: Scenario, rigging: Rigging, hooks: Iterable[str], on: frozenset[str]
) -> list[tuple[float, float, float]]:
    """Lugs of the load to which slings that are on lead from some hooks, in its axes [m]."""
    assert scenario.load is not None  # slings have been checked to lead to its lugs
    slings = [sling for hook in hooks for sling in slings_under(rigging, hook) if sling.name in on]
    return [scenario.load.lugs[lug].at for sling in slings for lug in sling.lugs]


def balance(lugs: list[tuple[float, float, float]], centre: Array) -> float | None:
    """Tilt with which a load hangs from lugs on one line alone [rad]; None where they do not say it.

    Args:
        lugs: Where they are, axes of the load [m].
        centre: Its centre of gravity, the same (3,) [m].
    """
    places = np.array(lugs)
    middle = places.mean(axis=0)
    _, sizes, axes = np.linalg.svd(places - middle)
    if len(sizes) > 1 and sizes[1] > _OFF_LINE:
        return None
    way = np.asarray(centre) - middle
    if sizes[0] > _OFF_LINE:
        if abs(axes[0][2]) > _STEEP:
            return None
        way = way - (way @ axes[0]) * axes[0]
    size = float(np.linalg.norm(way))
    return None if size < _NEAR else math.acos(max(-1.0, min(-float(way[2]) / size, 1.0)))
