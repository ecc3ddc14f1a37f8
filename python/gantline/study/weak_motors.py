"""Motors of winches and hoists that cannot hold what hangs on them at rest, by statics alone."""

from __future__ import annotations

import math

from gantline.scenario import Scenario, ScenarioError, resolve
from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.cranes.reeving import hoist_drum
from gantline.scenario.errors import Doubt
from gantline.statics import Statics
from gantline.study.drum_pulls import OfDrum, pull_at, when, without_stops
from gantline.study.steps import StepAtRest, run_steps
from gantline.units import format_by_size

__all__ = ["weak_motors"]

#: Share of what it can from which on a motor pulls all of it [1]; the search for rest leaves as much.
_ALL = 1.0 - 1e-6
#: What hangs in all may be more by slings, shackles and falls [1].
_AND_ROPES = 1.25


def weak_motors(scenario: Scenario) -> list[Doubt]:
    """Each motor that pulls all it can where the lift rests, and does not move what hangs there.

    The lift is looked at where each step of its plan ends, as if no emergency stop came before, with sheaves
    that lose nothing. A motor that could hold all that is lifted by itself is not looked at. What
    accelerating takes beside that only a run tells, and of what comes to rest nowhere nothing is known.

    Args:
        scenario: The lift.

    Returns:
        Of each such motor when it is so first; none of a lift without statics.
    """
    motors = _motors(scenario)
    if not motors:
        return []
    first: dict[str, StepAtRest] = {}
    try:
        question = Statics(without_stops(scenario))
        for one in run_steps(question):
            rest = one.state.rest
            if rest is None:
                continue
            for motor in motors:
                if pull_at(question, rest.recording, motor) >= _ALL * motor.holds:
                    first.setdefault(motor.drum, one)
    except ScenarioError:  # lengths that are adjusted have no statics
        return []
    return [Doubt(motor.path, _told(motor, first[motor.drum])) for motor in motors if motor.drum in first]


def _motors(scenario: Scenario) -> list[OfDrum]:
    """Those that may be too weak for what they hoist."""
    found = []
    weight = _AND_ROPES * _lifted(scenario) * scenario.simulation.gravity
    for name, hook in scenario.hooks.items():
        capacity = hook.hoist.capacity
        if hook.reeving is None or capacity is None:
            continue
        if capacity * hook.reeving.parts < weight * _outermost(scenario, hook):
            path = (*hook.paths[""], "hoist", "capacity")
            found.append(OfDrum(name, hoist_drum(name), path, capacity, hook.reeving.parts))
    drums = scenario.mechanics.drums if scenario.mechanics is not None else None
    for name, drum in (drums or {}).items():
        if drum.drive is not None and drum.drive.capacity is not None:
            path = ("mechanics", "drums", name, "drive", "capacity")
            found.append(OfDrum(name, name, path, drum.drive.capacity))
    return found


def _lifted(scenario: Scenario) -> float:
    """Mass of what hangs from hooks but for ropes [kg]; infinite where bodies of `mechanics` may hang."""
    if scenario.mechanics is not None and scenario.mechanics.bodies:
        return math.inf
    frames = (one.frame.mass for one in resolve(scenario).equalizers.values())
    spreaders = (one.mass for one in (scenario.spreaders or {}).values())
    compensators = (one.mass for one in (scenario.compensators or {}).values())
    hung = (one.hook_block_mass for one in scenario.hooks.values())
    load = 0.0 if scenario.load is None else scenario.load.weight.simulated + scenario.load.room
    return math.fsum((load, *frames, *spreaders, *compensators, *hung))


def _outermost(scenario: Scenario, hook: Hook) -> float:
    """Pitch diameter of the last layer of its drum over that of the first [1]."""
    drum, reeving = hook.drum, hook.reeving
    if drum is None or reeving is None:
        return 1.0
    step = drum.step((scenario.ropes or {})[reeving.rope].diameter)
    return 1.0 + 2.0 * step * (drum.layers - 1) / drum.diameter


def _told(motor: OfDrum, one: StepAtRest) -> str:
    each = " of each rope" if motor.ropes > 1 else ""
    pulls = f"the motor of {motor.name} pulls at most {format_by_size(motor.holds, 'force', 4)}{each}"
    short = f"and at rest {when(one)} it pulls all of that"
    heavy = "what hangs there is too heavy for it, it does not hoist it or lets it down"
    if motor.path[0] == "mechanics":  # hooks hang in hoists, while drums hold what they are meant to
        heavy = f"a winch of constant tension is meant to; for any other {heavy}"
    return f"{pulls}, {short}: {heavy}"
