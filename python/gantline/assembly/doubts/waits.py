"""Steps that wait for what cannot come, a hoist load beyond all weight, or for next to no time."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.cranes.reeving import falls_on_upper_sheaves, reeved_hooks
from gantline.assembly.parts import Parts
from gantline.scenario import Scenario
from gantline.scenario.cranes.hooks import full_name
from gantline.scenario.errors import Doubt
from gantline.scenario.plan.condition import Weighing
from gantline.scenario.plan.steps import HoldStep, MovingStep
from gantline.units import format_quantity

__all__ = ["doubtful_waits"]

#: Nobody holds a lift for less to look at it [s]; loads swing and rope stretches for seconds.
_SHORTEST = 0.1
#: What a step does as it begins, for which it need not last.
_AT_ONCE = (
    *("cut", "detach", "attach", "remove_supports", "pull_pins", "put_in_pins"),
    *("open_hinges", "open_holes", "close_holes"),
)


def doubtful_waits(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """Each step whose hoist load cannot be reached by weight alone, and each hold of no length.

    Holds that do something as they begin, such as taking slings off, may be as short as they like. Nothing is
    said of hoist loads where something else may pull: bodies and ropes of `mechanics`, waves.

    Args:
        parts: The system with all its bodies and ropes.
        scenario: The lift.
    """
    for place, step in enumerate(scenario.plan):
        if any(getattr(step, key) for key in _AT_ONCE):
            continue
        if isinstance(step, HoldStep) and isinstance(step.hold, float) and step.hold < _SHORTEST:
            sentence = f"step '{step.step}' holds for {1e3 * step.hold:g} ms: nobody sees anything in that"
            yield Doubt(("plan", place, "hold"), f"{sentence}; a unit has slipped, ms for s")
    if scenario.mechanics is not None or scenario.waves:
        return
    gravity = scenario.simulation.gravity
    for place, step in enumerate(scenario.plan):
        reached = step.until.hoist_load if step.until is not None else None
        if reached is None:
            continue
        name = full_name(reached.hook, scenario.hooks) or ""
        hook = next(one for one in reeved_hooks(scenario) if one.name == name)  # checked with the file
        empty = parts.bodies[name]["mass"] + falls_on_upper_sheaves(parts, scenario, hook)
        most = empty + _hangable(parts, scenario, name)
        goes_on = "the step does not end by it" if isinstance(step, MovingStep) else "it is never met"
        if reached.above is not None and reached.above.newtons(gravity) > most * gravity:
            waits = f"waits for a hoist load above {_shown(reached.above)} at {reached.hook}"
            weighs = f"all that can hang there weighs {_shown(_like(reached.above, most, gravity))}"
            sentence = f"step '{step.step}' {waits}; {weighs} with hook block and falls, and {goes_on}"
            yield Doubt(("plan", place, "until"), sentence)
        if reached.below is not None and reached.below.newtons(gravity) < empty * gravity:
            waits = f"waits for a hoist load below {_shown(reached.below)} at {reached.hook}"
            weighs = f"hook block and falls alone weigh {_shown(_like(reached.below, empty, gravity))}"
            yield Doubt(("plan", place, "until"), f"step '{step.step}' {waits}; {weighs}, and {goes_on}")


def _hangable(parts: Parts, scenario: Scenario, hook: str) -> float:
    """Mass of all that is neither of a crane nor of a vessel: the load and its gear [kg]."""
    fixed = (*(scenario.cranes or {}), *(scenario.vessels or {}))

    def is_fixed(body: str) -> bool:
        return body == hook or any(body == one or body.startswith((f"{one}.", f"{one}/")) for one in fixed)

    bodies = sum(body["mass"] for name, body in parts.bodies.items() if not is_fixed(name))
    return float(bodies) + (0.0 if scenario.load is None else scenario.load.room)


def _like(said: Weighing, mass: float, gravity: float) -> Weighing:
    """What a mass weighs, said as something else is."""
    return Weighing(0.0, mass) if said.mass else Weighing(mass * gravity, 0.0)


def _shown(weighing: Weighing) -> str:
    if weighing.mass:
        return format_quantity(weighing.mass, "t", 1)
    return format_quantity(weighing.force, "kN", 0)
