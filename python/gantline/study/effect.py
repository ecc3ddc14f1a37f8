"""Cases that change nothing, and what they cut in vain."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from gantline.checks import Check
from gantline.results import series
from gantline.scenario import Scenario
from gantline.scenario.parting import partings
from gantline.statics import Equilibrium, NoEquilibriumError, Statics
from gantline.study.state import State, differs, values_of

__all__ = ["is_as", "with_effect"]

#: Times that differ by less are one [s]: a cut is looked at just after it.
_AT_ONCE = 1e-6
#: Values of checks that differ by less are alike: a share, and of nothing [SI].
_ALIKE, _NOTHING = 1e-9, 1e-9


def with_effect(state: State, given: State, base: Scenario) -> State:
    """A state of a case with what it asks for in vain, and whether it changes anything.

    Args:
        state: Of a case, settled.
        given: The lift as it is given, with the same losses.
        base: That lift.
    """
    if state.rest is None or given.rest is None or not state.case:
        return state
    in_vain = tuple(_in_vain(state, given, base))
    nothing = len(in_vain) == len(state.cut) if state.cut else is_as(state, given)
    return replace(state, in_vain=in_vain, changes_nothing=nothing)


def _in_vain(state: State, given: State, base: Scenario) -> Iterator[str]:
    """Of ropes that a case cuts, those that are not on then, or carry nothing."""
    ropes = {f"sling.{name}" if name in (base.slings or {}) else name: name for name in state.cut}
    before = given.rest
    if abs(state.time - given.time) > _AT_ONCE:
        before = _before(base, state.time) if any(_comes_or_goes(base, rope) for rope in ropes) else None
    if before is None:
        return
    for rope, name in ropes.items():
        if not series.is_on(before.recording, rope)[-1]:
            yield f"{name} is not on at {state.time:.4g} s"
        elif before.tension(rope) == 0.0:
            yield f"{name} carries nothing at {state.time:.4g} s as given"


def _comes_or_goes(base: Scenario, rope: str) -> bool:
    """Whether a rope is put on, taken off or cut in the lift as it is given."""
    by_steps = any(rope in (*step.attach, *step.detach, *step.cut) for step in base.plan)
    return by_steps or partings(base)[rope].cut_at is not None


def _before(base: Scenario, time: float) -> Equilibrium | None:
    """The lift as it is given at rest at a time [s]; None if it does not come to rest."""
    try:
        return Statics(base).equilibrium(min(time, base.duration))
    except NoEquilibriumError:
        return None


def is_as(state: State, given: State) -> bool:
    """Whether all values and checks of a state at rest are those of another one at rest."""
    here, there = values_of(state), values_of(given)
    if any(here[quantity].keys() != there[quantity].keys() for quantity in here):
        return False
    values = (
        differs(quantity, value, there[quantity][element])
        for quantity, of in here.items()
        for element, value in of.items()
    )
    if any(values) or len(state.checks) != len(given.checks):
        return False
    return all(_are_alike(one, other) for one, other in zip(state.checks, given.checks, strict=True))


def _are_alike(one: Check, other: Check) -> bool:
    if (one.name, one.verdict, one.limit, one.step) != (other.name, other.verdict, other.limit, other.step):
        return False
    if one.value is None or other.value is None:
        return one.value is other.value
    return math.isclose(one.value, other.value, rel_tol=_ALIKE, abs_tol=_NOTHING)
