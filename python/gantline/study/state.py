"""One lift at rest among many, and which of them is worst for each element."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from gantline.arguments import needed
from gantline.checks import (
    LOAD_LIFTED,
    Check,
    check_recording,
    failed_names,
    governing,
    has_failed,
    past_limits,
    verdict_of,
)
from gantline.results import alike, series
from gantline.results.file.saved import LOSSES, QUANTITIES
from gantline.results.recording import Recording
from gantline.results.rotation import axes, heading
from gantline.results.variable import FloatArray
from gantline.scenario import StartError
from gantline.statics import Equilibrium, Losses, NoEquilibriumError, Statics
from gantline.units import format_quantity

__all__ = [
    "LOSSES",
    "QUANTITIES",
    "State",
    "Worst",
    "differs",
    "free_to_slide",
    "rest_json",
    "settled",
    "stands",
    "unstartable",
    "values_of",
    "worst_of",
]

#: Shares of the weight of a load that is not lifted, of which a check tells, and of one that hangs [1].
_PARTLY = (0.05, 0.95)
#: How far an axis leans from plumb that points anywhere; searches leave 1e-9 rad or so [rad].
_UPRIGHT = 1e-6


@dataclass(frozen=True)
class State:
    """A lift at rest in one variant of a case.

    Attributes:
        case: Name of the case; empty for the lift as it is given.
        variant: What is different in it; empty where its case has only one.
        losses: What losses of sheaves do, see `Statics.equilibrium`.
        time: Time of the plan [s].
        rest: The equilibrium; None where there is none.
        starts: Whether its start can be put together; where it cannot there is no equilibrium to ask for.
        cause: Why there is none, in one sentence.
        margins: Margins of the lift file that the case varies, `load.centre_of_gravity.envelope` or
            `slings.tolerance`; empty for another.
        cut: Slings and ropes that the case cuts.
        in_vain: Of what it cuts, what is not there to be cut, and why; a sentence each.
        swings_to: How far slings go on the way there that bear more since others are cut, by their names,
            undamped [N]; nothing of a case in which a load stands.
        changes_nothing: Whether all that is asked of it is as in the lift as it is given.
        stands: Loads that something supports, which hang clear at that time in the lift as it is given.
        checks: Its checks, of slings that the case cuts none.
        first_order: Tensions of slings by sensitivities about the lift as it is given [N]; of a case that
            varies lengths of slings.
        slides: Loads that stand on contacts whose friction is left out, as `free_to_slide` has them.
    """

    case: str
    variant: str
    losses: Losses
    time: float
    rest: Equilibrium | None = None
    starts: bool = True
    cause: str = ""
    margins: str = ""
    cut: tuple[str, ...] = ()
    in_vain: tuple[str, ...] = ()
    swings_to: Mapping[str, float] = field(default_factory=dict)
    changes_nothing: bool = False
    stands: tuple[str, ...] = ()
    checks: Sequence[Check] = ()
    first_order: Mapping[str, float] = field(default_factory=dict)
    slides: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        """Variant and losses in words."""
        return ", ".join(part for part in (self.variant, LOSSES[self.losses]) if part)

    @property
    def failed(self) -> tuple[str, ...]:
        """Names of the checks that failed."""
        return failed_names(self.checks)

    @property
    def past(self) -> tuple[str, ...]:
        """Names of the checks that are past a limit and no more than a warning."""
        return tuple(dict.fromkeys(one.name for one in past_limits(self.checks)))

    @property
    def governing(self) -> Check | None:
        """The check that uses most of its limit; None without equilibrium or such a check."""
        return governing(self.checks)

    @property
    def is_sound(self) -> bool:
        """Whether there is an equilibrium, it is stable, what should hang does, and no check failed."""
        is_stable = self.rest is not None and self.rest.is_stable
        return is_stable and not self.stands and not has_failed(self.checks)

    @property
    def fails_as_it_slides(self) -> tuple[str, ...]:
        """Loads that are free to slide where a check fails, which may be all that is amiss.

        A load that has been set down on a deck that leans slides as far as its slings let it, and pulls at
        them. Of an equilibrium that is unstable more is to be said.
        """
        is_stable = self.rest is not None and self.rest.is_stable
        return self.slides if is_stable and not self.is_sound else ()

    @property
    def not_lifted(self) -> tuple[str, ...]:
        """Why nothing hangs then, a reason for each load; empty where one of them does."""
        told = tuple(check.remark for check in self.checks if check.name == LOAD_LIFTED)
        loads = () if self.rest is None else self.rest.recording.rig.loads
        return told if len(told) == len(loads) else ()

    @property
    def partly_stands(self) -> tuple[str, ...]:
        """Loads that stand then with a part of their weight, and how much of it hangs, in words.

        Of a load that a plan has set down slings and hooks carry what its last step has left in them, which
        is nothing to rely on. Loads in hinges are left out: these bear a part all along.
        """
        if self.rest is None:
            return ()
        recording = self.rest.recording
        hinged = {hinge.load for hinge in recording.rig.hinges}
        told = []
        for load in recording.rig.loads if "load_transferred" in recording else ():
            if load.name not in recording.coordinates["load"] or load.name in hinged:
                continue
            share = float(recording.column("load_transferred", load.name)[-1])
            if _PARTLY[0] <= share < _PARTLY[1]:
                hangs = format_quantity(share, "%", 0)
                told.append(f"{load.name} stands, with {hangs} of its weight in its slings")
        return tuple(told)

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        rest, check = self.rest, self.governing
        return {
            "variant": self.variant,
            "losses": self.losses,
            "time": self.time,
            "starts": self.starts,
            "equilibrium": rest is not None,
            "cause": self.cause,
            "stable": None if rest is None else rest.is_stable,
            "unstable_motions": None if rest is None else rest.unstable,
            "neutral_motions": None if rest is None else rest.neutral,
            "cut": list(self.cut),
            "changes_nothing": self.changes_nothing,
            "in_vain": list(self.in_vain),
            "stands": list(self.stands),
            "not_lifted": list(self.not_lifted),
            "partly_stands": list(self.partly_stands),
            "fails_as_it_slides": list(self.fails_as_it_slides),
            **values_of(self),
            "first_order_sling_tension": dict(self.first_order) or None,
            "failed": list(self.failed),
            "past_limits_that_warn": list(self.past),
            "governing": None
            if check is None
            else {"check": check.name, "element": check.element, "utilisation": check.utilisation},
            "verdict": verdict_of(self.checks) if rest is not None else "",
            "checks": [check.to_json() for check in self.checks],
        }


@dataclass(frozen=True)
class Worst:
    """The worst that happens to one element.

    Attributes:
        quantity: A key of `QUANTITIES`.
        element: Sling, rope, hook, load or moving sheave.
        given: Its worst value in the lift as it is given, whatever losses do [SI]; None without equilibrium
            or such an element.
        value: The worst value [SI].
        state: The state that has it.
    """

    quantity: str
    element: str
    given: float | None
    value: float
    state: State


def settled(question: Statics, time: float | None, state: State, ending: Sequence[str] = ()) -> State:
    """A state with the equilibrium at a time [s] and its checks, or the cause why there is none.

    What the steps `ending` require is held against it.
    """
    try:
        rest = question.equilibrium(time, losses=state.losses)
    except NoEquilibriumError as problem:
        cause = f"{problem.cause} ({problem.element})"
        return replace(state, time=problem.time, cause=cause, first_order={})
    checks = check_recording(_without(rest.recording, state.cut), ending)
    return replace(state, time=rest.time, rest=rest, checks=checks, slides=free_to_slide(question, rest))


def free_to_slide(question: Statics, rest: Equilibrium) -> tuple[str, ...]:
    """Loads that stand in an equilibrium on contacts that have friction in a run, and none there."""
    if rest.losses == "held":
        return ()
    document = question.assembly.document
    touching = [one for kind in ("contacts", "supports", "pairs") for one in document.get(kind, ())]
    rough = {one["name"] for one in touching if one.get("friction", 0.0) > 0.0}
    found = []
    for load in rest.recording.rig.loads:
        bears = [one for one in load.contacts if rest.recording.column("contact_force", one)[-1] > 0.0]
        if rough.intersection(one.partition("/")[0] for one in bears):
            found.append(load.name)
    return tuple(found)


def unstartable(state: State, time: float, error: StartError) -> State:
    """A state of a lift whose start cannot be put together, at a time [s]."""
    return replace(state, time=time, starts=False, cause=error.problems[0].message)


def stands(state: State, given: Equilibrium | None) -> tuple[str, ...]:
    """Loads that something supports in a state and nothing in the lift as it is given, at the same time."""
    if state.rest is None or given is None:
        return ()
    here, there = state.rest.recording, given.recording
    of_given = {load.name: load for load in there.rig.loads}
    return tuple(
        load.name
        for load in here.rig.loads
        if load.name in of_given
        and not series.load_is_clear(here, load)[-1]
        and series.load_is_clear(there, of_given[load.name])[-1]
    )


def values_of(state: State) -> dict[str, dict[str, float]]:
    """Each of `QUANTITIES` by element [SI]; empty without equilibrium.

    `sling_tension` and `smallest_sling_tension` are the same, of which the largest and the smallest is
    worst. `rope_tension` is that of all other ropes, over sheaves with losses of the tightest segment.
    `sheave_travel` is down positive, the gas of compensators no rope. What a case cuts, and what is not on,
    is left out.

    Raises:
        TypeError: If it is no state.
    """
    rest = _state(state).rest
    if rest is None:
        return {quantity: {} for quantity in QUANTITIES}
    recording, rig = rest.recording, rest.recording.rig

    def last(name: str, elements: Iterable[str]) -> dict[str, float]:
        return {element: float(recording.column(name, element)[-1]) for element in elements}

    on = series.slings_on(recording)
    slings = {one.name: rest.tension(one.rope) for one in on if one.name not in state.cut}
    of_slings = {one.rope for one in rig.slings} | set(state.cut)
    of_slings |= {one.gas for one in rig.compensators}
    others = [rope for rope in recording.coordinates.get("rope", ()) if rope not in of_slings]
    hooks = [hook.name for hook in rig.hooks]
    sheaves = [sheave for equalizer in rig.equalizers for sheave in equalizer.moving_sheaves]
    return {
        "sling_tension": slings,
        "smallest_sling_tension": dict(slings),
        "rope_tension": {rope: series.rope_peak(recording, rope)[0] for rope in others},
        "hook_load": last("hook_load", hooks),
        "hoist_load": last("hoist_load", hooks),
        "load_tilt": last("load_tilt", [load.name for load in rig.loads]),
        "sheave_travel": last("sheave_travel", sheaves),
        "rod_out": last("rod_out", [one.name for one in rig.compensators]),
        "hinge_force": last("hinge_force", [hinge.name for hinge in rig.hinges]),
    }


def rest_json(rest: Equilibrium) -> dict[str, Any]:
    """An equilibrium as a JSON object, SI units: what it is like, and values of `QUANTITIES` by element.

    The heading of loads [rad] stands beside their tilt; None of one whose own x axis is upright.
    """
    values = values_of(State("", "", rest.losses, rest.time, rest))
    of_loads = {
        load.name: _heading_of(rest.recording.column("body_orientation", load.body)[-1])
        for load in rest.recording.rig.loads
    }
    once = {key: of for key, of in values.items() if key != "smallest_sling_tension"}
    return {**rest.to_json(), **once, "load_heading": of_loads}


def _heading_of(orientation: FloatArray) -> float | None:
    """Heading of a load [rad]; None where its own x axis is upright and rounding alone would give it one."""
    forward = axes(orientation)[:, 0]
    return float(heading(orientation)) if math.hypot(forward[0], forward[1]) > _UPRIGHT else None


def worst_of(states: Sequence[State]) -> list[Worst]:
    """The worst state for each quantity of each element, in the order of the lift.

    Worst is the largest value, of `smallest_sling_tension` the smallest, of `sheave_travel` the farthest from
    the start; where several are alike, the first.

    Raises:
        TypeError: If one of them is no state.
    """
    found: dict[tuple[str, str], Worst] = {}
    # States without a case are the lift as it is given; they come first, too.
    for state in sorted(states, key=lambda one: bool(_state(one).case)):
        for quantity, values in values_of(state).items():
            for element, value in values.items():
                known = found.get((quantity, element))
                if known is not None and not _is_worse(quantity, value, known.value):
                    continue
                of = known.given if known is not None else None
                found[quantity, element] = Worst(quantity, element, of if state.case else value, value, state)
    order = list(QUANTITIES)
    return sorted(found.values(), key=lambda one: order.index(one.quantity))


def _state(value: State) -> State:
    return needed(value, State, "a state of a lift", "gantline.study.run_cases(...).states has some")


def _is_worse(quantity: str, value: float, than: float) -> bool:
    if quantity == "sheave_travel":
        value, than = abs(value), abs(than)
    elif quantity == "smallest_sling_tension":
        value, than = -value, -than
    # Of values that differ by rounding alone the first is worst, so that tables do not depend on it.
    return value > than and differs(quantity, value, than)


def differs(quantity: str, one: float, other: float) -> bool:
    """Whether two values of one of `QUANTITIES` differ by more than rounding."""
    return alike.differs(one, other, QUANTITIES[quantity][0])


def _without(recording: Recording, cut: Sequence[str]) -> Recording:
    """The same recording of a lift that never had some slings: the others have to hold it."""
    if not cut:
        return recording
    rig = dict(recording.attributes["rig"])
    gone = {sling["rope"] for sling in rig.get("slings") or () if sling["name"] in cut} | set(cut)
    rig["slings"] = [sling for sling in rig.get("slings") or () if sling["rope"] not in gone]
    rig["equalizers"] = [
        {**equalizer, "slings": [rope for rope in equalizer.get("slings") or () if rope not in gone]}
        for equalizer in rig.get("equalizers") or ()
    ]
    rig["hooks"] = [
        {**hook, "direct_slings": [one for one in hook.get("direct_slings") or () if one not in cut]}
        for hook in rig.get("hooks") or ()
    ]
    variables = {name: recording[name] for name in recording}
    return Recording(variables, recording.coordinates, {**recording.attributes, "rig": rig})
