"""The cases of a lift file: statics of each, and the worst of them for each element."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from gantline.scenario import Scenario, ScenarioError, load_scenario
from gantline.scenario.case import TOLERANCE
from gantline.scenario.variants import (
    tolerances,
    variants_of,
    with_lengths,
    with_ropes_cut,
    without_cases,
)
from gantline.statics import Losses, NoEquilibriumError, Statics
from gantline.study.moment import begin_of_step
from gantline.study.state import State, Worst, settled, worst_of
from gantline.units import format_quantity

__all__ = ["CasesResult", "run_cases"]

_BOUNDS: tuple[Losses, ...] = ("forward", "backward")
#: Changes of tension that differ by less than this share of the largest are alike.
_ALIKE = 1e-6


@dataclass(frozen=True)
class CasesResult:
    """Statics of a lift and of all its cases.

    Attributes:
        title: Title of the lift.
        given: The lift as it is given.
        states: That, then every variant of every case, in the order of the file; of lifts with losses of
            sheaves each with its two bounds.
    """

    title: str
    given: State
    states: Sequence[State]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the cases; the lift as it is given is the first and has an empty one."""
        return tuple(dict.fromkeys(state.case for state in self.states))

    def of(self, case: str) -> list[State]:
        """All states of a case."""
        return [state for state in self.states if state.case == case]

    @property
    def worst(self) -> list[Worst]:
        """The worst case of each element."""
        return worst_of(self.states, self.given)

    @property
    def has_equilibria(self) -> bool:
        """Whether every state has an equilibrium."""
        return all(state.rest is not None for state in self.states)

    @property
    def is_sound(self) -> bool:
        """Whether every state has a stable equilibrium in which no check failed."""
        return all(state.is_sound for state in self.states)

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units; the lift as it is given is the case with the name ''."""
        return {
            "title": self.title,
            "sound": self.is_sound,
            "cases": [
                {"case": name, "states": [state.to_json() for state in self.of(name)]} for name in self.names
            ],
            "worst": [
                {
                    "quantity": one.quantity,
                    "element": one.element,
                    "given": one.given,
                    "value": one.value,
                    "case": one.state.case,
                    "variant": one.state.variant,
                    "losses": one.state.losses,
                }
                for one in self.worst
            ],
        }


def run_cases(lift: str | Path | Scenario, time: float | None = None) -> CasesResult:
    """Statics of a lift as it is given and of each of its cases.

    No equilibrium is a result. Where sheaves have losses each variant has two states more, with all of them
    slipping along the rope and against it.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        time: Time of the plan [s]; None for the end of the lift. A cut that says when has its own.

    Raises:
        ScenarioError: If the lift file is not right, or a case asks for what cannot be.
    """
    scenario = lift if isinstance(lift, Scenario) else load_scenario(lift)
    base = without_cases(scenario)
    states = list(_with_bounds(base, time, State("", "", "none", 0.0)))
    for name in scenario.cases or {}:
        states += _states(scenario, base, name, time)
    return CasesResult(scenario.lift.title, states[0], states)


def _states(scenario: Scenario, base: Scenario, name: str, time: float | None) -> Iterator[State]:
    """All states of a case."""
    case = (scenario.cases or {})[name]
    if case.vary == TOLERANCE:
        yield from _tolerances(scenario, base, name, time)
    elif case.cut:
        yield from _cut(scenario, base, name, time)
    else:
        for variant in variants_of(scenario, name):
            state = State(name, variant.label, "none", 0.0)
            yield from _of_case(scenario, variant.scenario, time, state)


def _of_case(scenario: Scenario, changed: Scenario, time: float | None, state: State) -> Iterator[State]:
    """States of a case's lift; what is wrong with how that is built is said at the case."""
    try:
        yield from _with_bounds(changed, time, state)
    except ScenarioError as error:
        problem = error.problems[0]
        sentence = f"{problem.path}: {problem.sentence}"
        where = f"{state.variant}: " if state.variant else ""
        raise scenario.error(("cases", state.case), f"{where}{sentence}") from None


def _with_bounds(scenario: Scenario, time: float | None, state: State) -> Iterator[State]:
    """A state settled, and with all sheaves slipping one way and the other where they have losses."""
    question = Statics(scenario)
    found = settled(question, time, state)
    yield found
    if found.rest is not None and found.rest.lossy:
        for losses in _BOUNDS:
            yield settled(question, time, replace(state, losses=losses, first_order={}))


def _cut(scenario: Scenario, base: Scenario, name: str, time: float | None) -> Iterator[State]:
    """The lift at rest once ropes have been cut; at its own time, if it says one."""
    case = (scenario.cases or {})[name]
    moment = case.at
    if case.at_step is not None:
        try:
            begin = begin_of_step(base, case.at_step)
        except NoEquilibriumError as problem:
            cause = f"{problem.cause} ({problem.element})"
            yield State(name, "", "none", problem.time, cause=cause, cut=case.cut)
            return
        if begin is None:
            sentence = f"'{case.at_step}' does not begin within the {base.duration:g} s of the lift"
            raise scenario.error(("cases", name, "at_step"), sentence)
        moment = begin + (case.after or 0.0)
        if moment > base.duration:
            sentence = f"that is at {moment:g} s, after the end of the lift at {base.duration:g} s"
            raise scenario.error(("cases", name, "after" if case.after else "at_step"), sentence)
    when = base.duration if moment is None and time is None else time if moment is None else moment
    assert when is not None
    # What is cut at a time has parted at any later one.
    question = with_ropes_cut(scenario, name, when)
    label = "" if moment is None else f"at {when:.4g} s"
    state = State(name, label, "none", 0.0, cut=case.cut)
    yield from _of_case(scenario, question, math.nextafter(when, math.inf), state)


def _tolerances(scenario: Scenario, base: Scenario, name: str, time: float | None) -> Iterator[State]:
    """Patterns of long and short slings, by sensitivities, and each solved anew."""
    case = (scenario.cases or {})[name]
    question = Statics(base)
    off = tolerances(scenario)
    given = settled(question, time, State(name, "", "none", 0.0))
    if given.rest is None:
        yield given
        return
    ropes = {sling.name: sling.rope for sling in question.rig.slings}
    slings = list(off)
    try:
        found = question.sensitivities([("length", ropes[sling]) for sling in slings])
    except (RuntimeError, ValueError, NoEquilibriumError) as problem:
        cause = ": ".join(str(part) for part in problem.args)
        sentence = f"tensions have no sensitivities to these lengths ({cause})"
        raise scenario.error(
            ("cases", name, "vary"), f"{sentence}; vary single lengths by their paths"
        ) from None
    # Change of the tension of each sling by the tolerance of each [N], shape (tensioned, varied).
    change = np.array([[one.of(ropes[sling]) * off[varied] for varied, one in zip(slings, found, strict=True)]
                       for sling in ropes])  # fmt: skip
    tension = {sling: given.rest.tension(rope) for sling, rope in ropes.items()}
    patterns = _patterns(str(case.pattern), change)
    if not patterns:
        yield replace(given, variant="lengths change no tension")
    for pattern in patterns:
        longer = {sling: sign * off[sling] for sling, sign in zip(slings, pattern, strict=True) if sign}
        first_order = dict(
            zip(tension, np.array(list(tension.values())) + change @ np.array(pattern), strict=True)
        )
        state = State(
            name, _pattern_label(longer, len(slings)), "none", 0.0,
            first_order={sling: float(value) for sling, value in first_order.items()},
        )  # fmt: skip
        yield from _of_case(scenario, with_lengths(scenario, name, longer), time, state)


def _patterns(kind: str, change: np.ndarray) -> list[tuple[int, ...]]:
    """Signs of what slings are off, +1 long, −1 short, 0 as planned, each pattern once.

    Args:
        kind: `each`, `worst` or `worst_pair`.
        change: What the tolerance of each sling changes in each tension, shape (tension, sling) [N].
    """
    count = change.shape[1]
    if kind == "each":
        single = [tuple(int(place == one) for place in range(count)) for one in range(count)]
        return [pattern for one in single for pattern in (one, _opposite(one))]
    # What is left of a sensitivity by rounding has no sign.
    known = np.where(np.abs(change) > _ALIKE * np.abs(change).max(initial=0.0), change, 0.0)
    if kind == "worst":
        rows = [tuple(int(sign) for sign in np.sign(row)) for row in known]
    else:
        rows = [_worst_pair(known)]
    both = (pattern for row in rows for pattern in (row, _opposite(row)) if any(row))
    return list(dict.fromkeys(both))


def _worst_pair(change: np.ndarray) -> tuple[int, ...]:
    """One sling long and another short by their tolerances: those that change some tension most."""
    most, pair = 0.0, (0, 0)
    for row in change:
        long, short = _first(row), _first(-row)
        spread = float(row[long] - row[short])
        if spread > most * (1.0 + _ALIKE):
            most, pair = spread, (long, short)
    return tuple(int(place == pair[0]) - int(place == pair[1]) for place in range(change.shape[1]))


def _first(row: np.ndarray) -> int:
    """Place of the largest, of those alike the first."""
    return int(np.flatnonzero(row >= row.max() - _ALIKE * np.abs(row).max())[0])


def _opposite(pattern: Sequence[int]) -> tuple[int, ...]:
    return tuple(-sign for sign in pattern)


def _pattern_label(longer: Mapping[str, float], count: int) -> str:
    """Which slings are long and short; by how much, if they are few."""
    if len(longer) > 2 or (len(longer) == count and count > 2):
        signs = {
            "+": [s for s, more in longer.items() if more > 0],
            "−": [s for s, more in longer.items() if more < 0],
        }
        return " ".join(f"{sign}{','.join(names)}" for sign, names in signs.items() if names)
    return ", ".join(
        f"{sling} {'+' if more > 0 else '−'}{format_quantity(abs(more), 'mm', 1)}"
        for sling, more in longer.items()
    )
