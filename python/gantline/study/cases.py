"""The cases of a lift file: statics of each, and the worst of them for each element."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from gantline.arguments import told
from gantline.results import series
from gantline.results.file.saved import digest_of
from gantline.scenario import Scenario, ScenarioError, StartError, load_scenario
from gantline.scenario.file.case import TOLERANCE
from gantline.scenario.file.variants import (
    tolerances,
    variants_of,
    with_lengths,
    with_ropes_cut,
    without_cases,
)
from gantline.statics import Losses, NoEquilibriumError, Statics
from gantline.study.effect import as_given_at, with_effect
from gantline.study.moment import begin_of_step
from gantline.study.pattern import (
    Floats,
    changes_of_tension,
    pattern_label,
    single_patterns,
    worst_patterns,
)
from gantline.study.side_by_side import SideBySide
from gantline.study.state import State, Worst, settled, unstartable, worst_of

__all__ = ["CasesResult", "run_cases"]

_BOUNDS: tuple[Losses, ...] = ("forward", "backward")


@dataclass(frozen=True)
class CasesResult:
    """Statics of a lift and of all its cases.

    Attributes:
        title: Title of the lift.
        scenario: Text of its lift file.
        given: The lift as it is given.
        states: That, then every variant of every case, in the order of the file; of lifts with losses of
            sheaves each with its two bounds.
        left_out: Sentences on what equilibria leave out of it.
        not_done: Names of cases of which Ctrl-C kept variants from being worked out; `states` has the others.
    """

    title: str
    scenario: str
    given: State
    states: Sequence[State]
    left_out: Sequence[str] = ()
    not_done: Sequence[str] = ()

    def __repr__(self) -> str:
        cases = len(self.names) - 1
        return f"<CasesResult {self.title!r}: {cases} cases, {len(self.states)} states in all>"

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the cases; the lift as it is given is the first and has an empty one."""
        return tuple(dict.fromkeys(state.case for state in self.states))

    def of(self, case: str) -> list[State]:
        """All states of a case; '' is the lift as it is given.

        Raises:
            KeyError: If there is no such case.
        """
        if case not in self.names:
            raise KeyError(f"there is no case {case!r}; there are {', '.join(map(repr, self.names))}")
        return [state for state in self.states if state.case == case]

    @property
    def worst(self) -> list[Worst]:
        """The worst case of each element."""
        return worst_of(self.states)

    @property
    def has_losses(self) -> bool:
        """Whether sheaves have losses in any state, so that there are bounds of what they do."""
        return any(state.losses != "none" for state in self.states)

    @property
    def has_equilibria(self) -> bool:
        """Whether every state that can start has an equilibrium."""
        return all(state.rest is not None for state in self.states if state.starts)

    @property
    def is_sound(self) -> bool:
        """Whether every state can start, is stable at rest, what should hang does and no check failed.

        Where Ctrl-C kept some from being found it is False. Of a time at which nothing hangs as given, that
        says little: `State.not_lifted` tells of it.
        """
        return not self.not_done and all(state.is_sound for state in self.states)

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units; the lift as it is given is the case with the name ''."""
        return {
            "title": self.title,
            "scenario_sha256": digest_of(self.scenario),
            "sound": self.is_sound,
            "left_out": list(self.left_out),
            "not_done": list(self.not_done),
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


def run_cases(
    lift: str | Path | Scenario,
    time: float | None = None,
    *,
    workers: int | None = None,
    on_progress: Callable[[str], None] | None = None,
) -> CasesResult:
    """Statics of a lift as it is given and of each of its cases.

    No equilibrium is a result, and so is a case whose start cannot be put together. Where sheaves have losses
    each variant has two states more, with all of them slipping along the rope and against it. Variants are
    worked on side by side; what is found does not depend on how many at a time. Ctrl-C gives up what is not
    found by then, unless that is the lift as it is given; `CasesResult.not_done` says of which cases.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        time: Time of the plan [s]; None for the end of the lift. A cut that says when has its own.
        workers: Variants at a time; None for as many as there are processors.
        on_progress: Is told in words what is looked for next.

    Raises:
        ScenarioError: If the lift file is not right, or a case asks for what cannot be.
    """
    tell = told(on_progress) or (lambda _: None)
    scenario = lift if isinstance(lift, Scenario) else load_scenario(lift)
    base = without_cases(scenario)
    pending: list[tuple[str, _Pending]] = []
    whole: list[str] = []
    with SideBySide(workers) as pool:
        try:
            tell("preparing the lift as it is given")
            pending.append(("", _with_bounds(pool, base, time, State("", "", "none", 0.0))))
            for name in scenario.cases or {}:
                about = partial(_tell_about, tell, name, pending)
                about("")
                pending += ((name, one) for one in _states(pool, scenario, base, name, time, about))
                whole.append(name)
            for done, (_, one) in enumerate(pending):
                tell(f"{done} of {len(pending)} variants")
                one.result()
        except KeyboardInterrupt:
            # What is still worked on is given up now, and finds no equilibrium because of that alone.
            lacking = {name for name, one in pending if not one.done()}
            pending = [(name, one) for name, one in pending if one.done()]
            if "" in lacking or not pending:
                raise
            whole = [name for name in whole if name not in lacking]
    states = [state for _, one in pending for state in one.result()]
    given = states[0]
    as_given = {state.losses: state for state in states if not state.case}
    earlier = as_given_at(base)
    states = [with_effect(state, as_given.get(state.losses, given), earlier) for state in states]
    not_done = [name for name in scenario.cases or {} if name not in whole]
    left_out = scenario.left_out_at_rest
    return CasesResult(scenario.lift.title, scenario.text, given, states, left_out, not_done)


#: States of a variant, which may still be worked on.
_Pending = Future[list[State]]


def _tell_about(
    tell: Callable[[str], None], name: str, pending: Sequence[tuple[str, _Pending]], doing: str
) -> None:
    """Tell what of a case is prepared now, and how many variants are found by then."""
    found = sum(one.done() for _, one in pending)
    tell(f"preparing '{name}'{doing and f': {doing}'}, {found} of {len(pending)} variants so far")


def _known(state: State) -> _Pending:
    """A state that is known already."""
    found: _Pending = Future()
    found.set_result([state])
    return found


def _states(
    pool: SideBySide,
    scenario: Scenario,
    base: Scenario,
    name: str,
    time: float | None,
    about: Callable[[str], None],
) -> Iterator[_Pending]:
    """All states of a case; `about` is told what takes long."""
    case = (scenario.cases or {})[name]
    if case.vary == TOLERANCE:
        yield from _tolerances(pool, scenario, base, name, time, about)
    elif case.cut:
        yield _cut(pool, scenario, base, name, time)
    else:
        for variant in variants_of(scenario, name):
            margins = case.vary if isinstance(case.vary, str) else ""
            state = State(name, variant.label, "none", 0.0, margins=margins)
            yield _of_case(pool, scenario, variant.scenario, time, state)


def _of_case(
    pool: SideBySide, scenario: Scenario, changed: Scenario, time: float | None, state: State
) -> _Pending:
    """States of a case's lift, one that cannot start too; what else is wrong with it is said at the case."""
    try:
        return _with_bounds(pool, changed, time, state)
    except StartError as error:
        return _known(unstartable(state, scenario.duration if time is None else time, error))
    except ScenarioError as error:
        where = f"{state.variant}: " if state.variant else ""
        raise scenario.error(("cases", state.case), f"{where}{error.problems[0].message}") from None


def _with_bounds(pool: SideBySide, scenario: Scenario, time: float | None, state: State) -> _Pending:
    """A state settled, and with all sheaves slipping one way and the other where they have losses."""
    question = pool.question(scenario)

    def work() -> list[State]:
        found = settled(question, time, state)
        if found.rest is None or not found.rest.lossy:
            return [found]
        bounds = (replace(state, losses=losses, first_order={}) for losses in _BOUNDS)
        return [found, *(settled(question, time, bound) for bound in bounds)]

    return pool.submit(work)


def _cut(pool: SideBySide, scenario: Scenario, base: Scenario, name: str, time: float | None) -> _Pending:
    """The lift at rest once ropes have been cut; at its own time, if it says one."""
    case = (scenario.cases or {})[name]
    moment = case.at
    if case.at_step is not None:
        try:
            begin = begin_of_step(Statics(base), case.at_step)
        except NoEquilibriumError as problem:
            cause = f"{problem.cause} ({problem.element})"
            return _known(State(name, "", "none", problem.time, cause=cause, cut=case.cut))
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
    return _of_case(pool, scenario, question, math.nextafter(when, math.inf), state)


def _tolerances(
    pool: SideBySide,
    scenario: Scenario,
    base: Scenario,
    name: str,
    time: float | None,
    about: Callable[[str], None],
) -> Iterator[_Pending]:
    """Patterns of long and short slings, by sensitivities, and each solved anew."""
    question = Statics(base)
    about("equilibrium without tolerances")
    given = settled(question, time, State(name, "", "none", 0.0))
    if given.rest is None:
        yield _known(given)
        return
    found = lengths_off(scenario, name, (question, given, time), about)
    if not found.off:
        yield _known(replace(given, variant="no sling with a tolerance is on"))
        return
    if not found.patterns:
        yield _known(replace(given, variant="lengths change no tension"))
    on = {sling.name for sling in series.slings_on(given.rest.recording)}
    for pattern in found.patterns:
        longer = found.longer(pattern)
        more = found.change @ np.array(pattern) if found.change is not None else ()
        first_order = {
            sling.name: given.rest.tension(sling.rope) + float(one)
            for sling, one in zip(question.rig.slings, more, strict=found.change is not None)
            if sling.name in on
        }
        state = State(name, pattern_label(longer), "none", 0.0, margins=TOLERANCE, first_order=first_order)
        yield _of_case(pool, scenario, with_lengths(scenario, name, longer), time, state)


@dataclass(frozen=True)
class LengthsOff:
    """Patterns of long and short slings.

    Attributes:
        off: What the length of each sling that is on may be off [m].
        patterns: Signs of what they are off, +1 long, −1 short, 0 as planned.
        change: What these amounts change in tensions [N], see `changes_of_tension`; None if not known.
    """

    off: Mapping[str, float]
    patterns: Sequence[tuple[int, ...]] = ()
    change: Floats | None = None

    def longer(self, pattern: Sequence[int]) -> dict[str, float]:
        """By how much slings are longer in a pattern [m], those that are not as planned."""
        return {sling: sign * self.off[sling] for sling, sign in zip(self.off, pattern, strict=True) if sign}


def lengths_off(
    scenario: Scenario,
    name: str,
    rest: tuple[Statics, State, float | None],
    about: Callable[[str], None],
) -> LengthsOff:
    """The patterns that a case of tolerances asks for.

    Args:
        scenario: The lift.
        name: Of the case.
        rest: The lift without cases, its equilibrium, and the time of that [s].
        about: Is told what takes long.

    Raises:
        ScenarioError: If the patterns need sensitivities, and there are none.
    """
    case = (scenario.cases or {})[name]
    question, given, time = rest
    on = set() if given.rest is None else {sling.name for sling in series.slings_on(given.rest.recording)}
    off = {sling: amount for sling, amount in tolerances(scenario).items() if sling in on}
    if not off:
        return LengthsOff(off)
    about("how lengths change tensions")
    change = _changes(scenario, name, question, off)
    if change is None or case.pattern == "each":
        return LengthsOff(off, single_patterns(len(off)), change)
    if given.rest is not None and given.rest.lossy:
        about("how lengths change tensions with losses of sheaves")
    changes = [change, *_changes_by_losses(question, time, given, off)]
    found = (pattern for one in changes for pattern in worst_patterns(str(case.pattern), one))
    return LengthsOff(off, list(dict.fromkeys(found)), change)


def _changes_by_losses(
    question: Statics, time: float | None, given: State, off: Mapping[str, float]
) -> Iterator[Floats]:
    """What tolerances change in tensions where all sheaves slip one way, and the other."""
    if given.rest is None or not given.rest.lossy:
        return
    for losses in _BOUNDS:
        if settled(question, time, replace(given, losses=losses)).rest is not None:
            yield changes_of_tension(question, off)


def _changes(scenario: Scenario, name: str, question: Statics, off: Mapping[str, float]) -> Floats | None:
    """What tolerances change in tensions; None of a case that can do without."""
    try:
        return changes_of_tension(question, off)
    except (RuntimeError, ValueError) as problem:
        if (scenario.cases or {})[name].pattern == "each":
            return None
        cause = ": ".join(str(part) for part in problem.args)
        sentence = f"tensions have no sensitivities to these lengths ({cause})"
        raise scenario.error(("cases", name, "vary"), f"{sentence}; 'pattern: each' needs none") from None
