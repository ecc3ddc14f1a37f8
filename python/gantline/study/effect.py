"""Cases that change nothing, and what they cut in vain."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache

from gantline.checks import Check
from gantline.results import series
from gantline.scenario import Scenario
from gantline.statics import Equilibrium, NoEquilibriumError, Statics
from gantline.study.state import State, differs, stands, values_of

__all__ = ["as_given_at", "is_as", "with_effect"]

#: Times that differ by less are one [s]: a cut is looked at just after it.
_AT_ONCE = 1e-6
#: Values of checks that differ by less are alike: a share, and of nothing [SI].
_ALIKE, _NOTHING = 1e-9, 1e-9
#: Share of its tension by which a sling bears more at least that has something of what is cut [1].
_GROWN = 0.01


def with_effect(state: State, given: State, earlier: Callable[[float], Equilibrium | None]) -> State:
    """A state of a case with what it asks for in vain, whether it changes anything, and what stands by it.

    Args:
        state: Of a case, settled.
        given: The lift as it is given, with the same losses.
        earlier: The lift as it is given at rest at another time [s], see `as_given_at`.
    """
    if state.rest is None or given.rest is None or not state.case:
        return state
    is_then = abs(state.time - given.time) <= _AT_ONCE
    if not state.cut:
        on_ground = stands(state, given.rest) if is_then else ()
        return replace(state, in_vain=(), changes_nothing=is_as(state, given), stands=on_ground)
    before = given.rest if is_then else earlier(state.time)
    in_vain = () if before is None else tuple(_in_vain(state, before))
    nothing = len(in_vain) == len(state.cut)
    on_ground = stands(state, before)
    swings_to = {}
    if before is not None and state.losses == "none" and not on_ground:
        swings_to = _swings_to(state, before)
    return replace(state, in_vain=in_vain, changes_nothing=nothing, swings_to=swings_to, stands=on_ground)


def _swings_to(state: State, before: Equilibrium) -> dict[str, float]:
    """How far slings go that bear more as others are cut, by their names, undamped [N].

    Of loads that hang on. What comes on at once comes on twice: a load on the stiffness k of what is left
    falls as far past its new rest as it was above it.
    """
    then = values_of(replace(state, rest=before))["sling_tension"]
    now = values_of(state)["sling_tension"]
    grown = {name: force - then[name] for name, force in now.items() if name in then}
    return {name: now[name] + more for name, more in grown.items() if more > _GROWN * now[name]}


def as_given_at(base: Scenario) -> Callable[[float], Equilibrium | None]:
    """The lift as it is given at rest at a time [s], sought once for all cuts of that time.

    None where it does not come to rest then.
    """

    @cache
    def at(time: float) -> Equilibrium | None:
        try:
            return Statics(base).equilibrium(min(time, base.duration))
        except NoEquilibriumError:
            return None

    return at


def _in_vain(state: State, before: Equilibrium) -> Iterator[str]:
    """Of ropes that a case cuts, those that are not on then, or carry nothing."""
    ropes = {f"sling.{sling.name}" for sling in before.recording.rig.slings}
    when = f"{round(state.time, 6):.4g} s"  # a cut is looked at a rounding after its time
    for name in state.cut:
        rope = f"sling.{name}" if f"sling.{name}" in ropes else name
        if not series.is_on(before.recording, rope)[-1]:
            yield f"{name} is not on at {when}"
        elif before.tension(rope) == 0.0:
            yield f"{name} carries nothing at {when} as given"


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
