"""When a step of a plan begins, in a lift that is followed from rest to rest."""

from __future__ import annotations

from gantline.scenario import Scenario
from gantline.scenario.from_tree import from_tree
from gantline.scenario.plan import MovingStep
from gantline.scenario.tree import ListNode, Node
from gantline.scenario.tree_path import map_node, put
from gantline.statics import Statics
from gantline.units import si_text

__all__ = ["begin_of_step"]

#: So slow that a hook stays where it is for a load, and fast enough to tell nanoseconds [m/s].
_SPEED = 1e-5


def begin_of_step(scenario: Scenario, name: str) -> float | None:
    """When a step of the plan begins [s]; None if that is not before the end of the lift.

    The lift itself tells: once it is followed with the plan up to that step, and once with a hook that is
    hoisted in place of it, at hardly any speed. How far that comes until the end says how long it has been
    going.

    Args:
        scenario: A lift without cases.
        name: Name of the step.

    Raises:
        NoEquilibriumError: If the lift cannot be followed.
        ScenarioError: If no hook moves as told.
    """
    place = [step.step for step in scenario.plan].index(name)
    step = scenario.plan[place]
    start = step.start_at if isinstance(step, MovingStep) else None
    if start is not None or place == 0:
        return start or 0.0
    told = [name for name, hook in scenario.hooks.items() if hook.reeving is None]
    if not told:
        sentence = "when this step begins is not known in a lift without a hook that moves as told"
        raise scenario.error(("plan", place), sentence)
    hook, end = told[0], scenario.duration
    acceleration = scenario.hooks[hook].hoist.acceleration
    steps = scenario.tree["plan"]
    probe = map_node(
        {
            "step": name,
            "hoist": hook,
            "speed": si_text(_SPEED, "speed"),
            "acceleration": si_text(acceleration, "acceleration"),
            "brake_from": si_text(end, "time"),
        },
        steps[place].line,
    )
    without, with_it = (_height(_with_plan(scenario, steps, [*steps[:place], *more]), hook, end)
                        for more in ([], [probe]))  # fmt: skip
    risen = with_it - without
    if risen <= 0.0:
        return None
    # v t − v²/2a, or while it still speeds up ½ a t².
    ramp = _SPEED / acceleration
    lasted = risen / _SPEED + ramp / 2 if risen >= _SPEED * ramp / 2 else (2 * risen / acceleration) ** 0.5
    return max(0.0, end - lasted)


def _with_plan(scenario: Scenario, steps: ListNode, chosen: list[Node]) -> Scenario:
    plan = ListNode(chosen)
    plan.line = steps.line
    return from_tree(put(scenario.tree, "plan", plan), scenario.source, scenario.text)


def _height(scenario: Scenario, hook: str, time: float) -> float:
    """Where a hook is at a time [m]."""
    recording = Statics(scenario).equilibrium(time).recording
    return float(recording.column("body_position", hook)[-1, 2])
