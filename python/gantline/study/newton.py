"""Newton's method for lifts that shall hang otherwise: the least changes that take a residual away.

The lift with the changed quantities is solved anew in each step, and the sensitivities of its factorised
tangent say how to change them further. Where several changes would do, the one with the least sum of squares
is taken (minimum norm), of all changes and not of each step.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gantline.results.rig import Rig
from gantline.scenario import Scenario, ScenarioError
from gantline.scenario.file.variants import with_values
from gantline.statics import NoEquilibriumError, Statics
from gantline.study.hanging import Hanging, Row
from gantline.units import format_quantity, si_text

__all__ = ["AdjustError", "CannotBeError", "Search", "SlackError", "Unknown"]

Floats = npt.NDArray[np.float64]

#: Residual that is gone for: radians, shares of the load, of hooks side pull over vertical force.
RESIDUAL = 1e-9
#: What may be left of it where changes act on it no more than so.
_LEFT = 1e-6
#: Steps of Newton's method, at most.
_STEPS = 30
#: A step is halved this often before it is given up.
_HALVINGS = 12
#: Singular values below this are none [1/m]: what a metre changes by less than 6 thousandths of a degree.
_NO_EFFECT = 1e-4
#: A step that goes so many times too far ends the search.
_FAR = 10.0


class CannotBeError(RuntimeError):
    """What is wanted cannot be had by these changes; the message is a plain sentence."""


class SlackError(CannotBeError):
    """It cannot be had, and slings are slack where the search ended or wanted to go on.

    Attributes:
        hanging: The load where it ended.
        slack: Names of the slings.
    """

    def __init__(self, sentence: str, hanging: Hanging, slack: Sequence[str]) -> None:
        super().__init__(sentence)
        self.hanging = hanging
        self.slack = slack


class _NoAnswerError(CannotBeError):
    """The lift does not answer smoothly to what is changed, as with slings that are slack there."""


class AdjustError(ValueError):
    """A sling or hook that may change is none."""


@dataclass(frozen=True)
class Unknown:
    """A quantity of the lift file that may change.

    Attributes:
        path: Its dotted path.
        parameter: Kind and name of its sensitivities.
        given: Its value in the lift file [m].
        most: Its largest change [m].
    """

    path: str
    parameter: tuple[str, str]
    given: float
    most: float


@dataclass(frozen=True)
class _Try:
    """The lift with some changes."""

    scenario: Scenario
    hanging: Hanging
    rows: Sequence[Row]

    @property
    def residual(self) -> float:
        return max((abs(row.value) for row in self.rows), default=0.0)


class Search:
    """Newton's method with the least change, halving steps that do not better it.

    Args:
        question: The lift, without cases.
        unknowns: What may change.
        rows: What is to vanish, with its derivatives over the unknowns.
        time: Time of the plan [s] at which the load hangs; None for the end of the lift.
        what: What the unknowns are, in words.

    Attributes:
        first: The lift as it is given.
        now: The lift with the changes found.
        steps: Steps made.

    Raises:
        CannotBeError: If the lift cannot be asked this.
        NoEquilibriumError: If it has no equilibrium as it is given.
    """

    def __init__(
        self,
        question: Statics,
        unknowns: Sequence[Unknown],
        rows: Callable[[Hanging], list[Row]],
        time: float | None,
        what: str,
    ) -> None:
        self._question, self._unknowns, self._rows, self._time = question, unknowns, rows, time
        self._what = what
        self.steps = 0
        self.first = self.now = self._try(np.zeros(len(unknowns)))

    def run(self, start: Floats | None = None) -> Floats:
        """Changes of the unknowns [m].

        Args:
            start: Those to set out from, if the lift has an equilibrium so; none if not given.

        Raises:
            CannotBeError: If no changes do it.
        """
        changes = np.zeros(len(self._unknowns))
        if start is not None and start.any():
            with suppress(ScenarioError, NoEquilibriumError, _NoAnswerError):
                self.now, changes = self._try(start), start
        while self.now.residual > RESIDUAL:
            if self.steps == _STEPS:
                raise self._cannot(f"no answer in {_STEPS} steps; {self._left()}")
            target = self._target(changes)
            if target is None:
                break
            self.steps += 1
            changes = self._step(changes, target)
        return changes

    def stay(self) -> Floats:
        """Take the lift as it is given for the answer: no changes [m]."""
        self.now, self.steps = self.first, 0
        return np.zeros(len(self._unknowns))

    def _target(self, changes: Floats) -> Floats | None:
        """Of all changes that do it to first order the least; None where nothing more can be done."""
        slope = np.array([row.change for row in self.now.rows])
        value = np.array([row.value for row in self.now.rows])
        left, sizes, right = np.linalg.svd(slope, full_matrices=False)
        acts = sizes > _NO_EFFECT
        wanted = left.T @ (slope @ changes - value)
        target: Floats = right[acts].T @ (wanted[acts] / sizes[acts])
        without_effect = value + slope @ (target - changes)
        if np.abs(without_effect).max() > max(RESIDUAL, 0.5 * np.abs(value).max()):
            if self.now.residual < _LEFT:
                return None
            raise self._cannot(self._no_effect(slope, value))
        self.refuse_too_far(target, _FAR)
        return target

    def _step(self, changes: Floats, target: Floats) -> Floats:
        """Towards a target, as far as it betters things; where slings are slack half as far may do."""
        cause, slack = "no change betters it any more", list[str]()
        for halving in range(_HALVINGS):
            step = changes + (target - changes) * 0.5**halving
            try:
                found = self._try(step)
            except ScenarioError as problem:
                cause = f"the lift cannot start so: {problem.problems[0].sentence}"
                continue
            except NoEquilibriumError as problem:
                cause = f"{problem.cause} ({problem.element})"
                continue
            except _NoAnswerError as problem:
                cause = str(problem)
                continue
            if found.residual < self.now.residual:
                self.now = found
                return step
            slack = slack or found.hanging.slack()
        self.refuse_too_far(target)
        raise self._cannot(f"{cause}; {self._left()}", slack)

    def _try(self, changes: Floats) -> _Try:
        texts = {
            one.path: si_text(one.given + float(more), "length")
            for one, more in zip(self._unknowns, changes, strict=True)
        }
        question = self._question
        if changes.any():
            question = Statics(with_values(question.scenario, texts))
        if len(question.rig.loads) != 1 or not question.rig.slings:
            raise CannotBeError("only a lift with a load on slings can be asked this")
        rest = question.equilibrium(self._time)
        load = question.rig.loads[0]
        if float(rest.recording.column("load_transferred", load.name)[-1]) < 1.0 - RESIDUAL:
            still = "its hinge bears it still" if question.rig.hinges else "it still stands"
            raise CannotBeError(f"{load.name} does not hang clear at {rest.time:g} s, {still}")
        try:
            hanging = Hanging(question, rest, [one.parameter for one in self._unknowns])
        except (RuntimeError, ValueError) as problem:
            cause = ": ".join(str(part) for part in problem.args)
            slack = [sling.name for sling in question.rig.slings if rest.tension(sling.rope) == 0.0]
            sentence = f"the lift has no sensitivities to these quantities ({cause})"
            if slack and changes.any():
                sentence = f"slack on the way: {', '.join(slack)}"
            raise _NoAnswerError(sentence) from None
        return _Try(question.scenario, hanging, self._rows(hanging))

    def _too_far(self, one: Unknown, more: float) -> str:
        name = one.path.split(".", 1)[1].rpartition(".")[0]
        change, most = (format_quantity(abs(size), "mm", 0) for size in (more, one.most))
        longer = "longer" if more > 0.0 else "shorter"
        return f"too far: {name} would be {change} {longer}, and may be {most}{_hint(self.now.hanging.rig)}"

    def refuse_too_far(self, changes: Floats, times: float = 1.0) -> None:
        """Refuse changes beyond so many times their limits.

        Raises:
            CannotBeError: If there is one; it names that which is farthest beyond.
        """
        beyond = [abs(more) - times * one.most for one, more in zip(self._unknowns, changes, strict=True)]
        worst = int(np.argmax(beyond))
        if beyond[worst] > 0.0:
            raise self._cannot(self._too_far(self._unknowns[worst], float(changes[worst])))

    def refuse_unsound(self) -> None:
        """Refuse an answer in which the lift cannot hang.

        Raises:
            CannotBeError: If it is unstable so, or a sling slack, or a sheave beyond its travel.
        """
        hanging = self.now.hanging
        if not hanging.rest.is_stable:
            raise CannotBeError("hung so it is unstable")
        if hanging.slack():
            raise self._cannot(f"hung so {', '.join(hanging.slack())} would be slack")
        beyond = hanging.beyond_travel()
        if beyond is not None:
            raise CannotBeError(f"hung so {beyond}")

    def _cannot(self, sentence: str, ahead: Sequence[str] = ()) -> CannotBeError:
        """Why it cannot be, with what is slack by now or ahead."""
        slack = self.now.hanging.slack() or ahead
        return SlackError(sentence, self.now.hanging, slack) if slack else CannotBeError(sentence)

    def _left(self) -> str:
        worst = max(self.now.rows, key=lambda row: abs(row.value))
        return f"{abs(worst.value):.2g} is left of {worst.name}{self._slack()}"

    def _slack(self) -> str:
        """What is slack by now: lengths of that do nothing, and it goes taut on the way."""
        slack = self.now.hanging.slack()
        return f"; slack: {', '.join(slack)}" if slack else ""

    def _no_effect(self, slope: Floats, value: Floats) -> str:
        worst = int(np.argmax(np.abs(value)))
        strongest = float(np.linalg.norm(slope, axis=1)[worst])
        name = self.now.rows[worst].name.partition(" [")[0]
        effect = f"{self._what} do not act on what is wanted: {name}"
        if strongest > _NO_EFFECT:
            effect = f"{self._what} cannot do all of what is wanted at once"
        return f"{effect}{self._slack()}{_hint(self.now.hanging.rig)}"


def _hint(rig: Rig) -> str:
    """Why lengths do little under equalizers."""
    if any(rig.equalizer_of(sling) is None for sling in rig.slings):
        return ""
    names = " and ".join(equalizer.name for equalizer in rig.equalizers)
    return (
        f"; under {names} slings pull alike whatever their lengths: move the centre of gravity, lugs or hooks"
    )
