"""Inverse questions: what lengths of slings, or places of hooks, make a load hang as it is wanted.

Newton's method on the equilibrium: the lift with the changed quantities is solved anew, and the
sensitivities of its factorised tangent say how to change them further. Where several changes would do, the
one with the least sum of squares is taken (minimum norm), of all changes and not of each step.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.results.rig import Rig
from gantline.results.rotation import heading as heading_of
from gantline.scenario import Scenario, ScenarioError, load_scenario
from gantline.scenario.errors import nearest
from gantline.scenario.rigging import resolve
from gantline.scenario.variants import with_values, without_cases
from gantline.statics import Equilibrium, NoEquilibriumError, Statics
from gantline.study.hanging import Hanging, Row
from gantline.units import format_quantity, si_text

__all__ = ["CannotBeError", "HookAnswer", "LengthAnswer", "adjust_lengths", "plumb_hooks"]

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
#: Most by which a length may change where it is not said, of the length.
_MOST = 0.1
#: A step that goes so many times too far ends the search.
_FAR = 10.0
#: A drift counts like a slope over this height [m].
_HEIGHT = 10.0


class CannotBeError(RuntimeError):
    """What is wanted cannot be had by these changes; the message is a plain sentence."""


@dataclass(frozen=True)
class LengthAnswer:
    """Unstretched lengths of slings with which a load hangs as wanted.

    Attributes:
        lengths: New length of each sling that may change [m].
        given: Its length in the lift file [m].
        before: The lift as it is given, at rest.
        after: The same with the new lengths.
        residual: What is left of slopes, heading and shares [rad, 1]; the largest.
        steps: Steps of Newton's method.
        scenario: The lift file with the new lengths.
    """

    lengths: Mapping[str, float]
    given: Mapping[str, float]
    before: Equilibrium
    after: Equilibrium
    residual: float
    steps: int
    scenario: Scenario


@dataclass(frozen=True)
class HookAnswer:
    """Places of hooks from which no hook is pulled aside.

    Attributes:
        places: New place of each hook along world x and y [m].
        given: Its place in the lift file [m].
        side_pulls: Horizontal force on each hook before and after, along world x and y [N], shape (2, 2).
        drift: How far the load's centre of gravity moves aside when it comes off, before and after [m]; None
            of a load that stands on nothing at the start.
        before: The lift as it is given, at rest.
        after: The same with the new places.
        residual: What is left, the largest: side pull over vertical force, drift over 10 m, heading [rad].
        steps: Steps of Newton's method.
        scenario: The lift file with the new places.
    """

    places: Mapping[str, tuple[float, float]]
    given: Mapping[str, tuple[float, float]]
    side_pulls: Mapping[str, Floats]
    drift: tuple[float, float] | None
    before: Equilibrium
    after: Equilibrium
    residual: float
    steps: int
    scenario: Scenario


@dataclass(frozen=True)
class _Unknown:
    """A quantity of the lift file that may change."""

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


def adjust_lengths(
    lift: str | Path | Scenario,
    *,
    slopes: tuple[float, float] | None = None,
    heading: float | None = None,
    shares: Mapping[str, float] | None = None,
    slings: Sequence[str] | None = None,
    most: float | None = None,
    time: float | None = None,
) -> LengthAnswer:
    """Unstretched lengths of slings with which a load hangs as wanted, changed as little as can be.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        slopes: By what angle the load's own x and y axes shall rise [rad]; (0, 0) is level.
        heading: Wanted angle of its own x axis from world x [rad].
        shares: Wanted vertical force of slings over that of all slings [1], by name.
        slings: Slings that may change; all if not given.
        most: Largest change of a length [m]; a tenth of it if not given.
        time: Time of the plan [s] at which the load hangs; None for the end of the lift.

    Raises:
        CannotBeError: If it cannot be had, with the reason.
        NoEquilibriumError: If the lift as it is given has no equilibrium.
        ScenarioError: If the lift file is not right.
        ValueError: If nothing is wanted, or a sling is asked for that there is not.
    """
    scenario = without_cases(lift if isinstance(lift, Scenario) else load_scenario(lift))
    known = {name: one.length for name, one in resolve(scenario).slings.items()}
    chosen = list(known) if slings is None else list(slings)
    for name in (*chosen, *(shares or {})):
        if name not in known:
            raise ValueError(f"'{name}' is not a sling; {nearest(name, known)}")
    if slopes is None and heading is None and not shares:
        raise ValueError("nothing is wanted of the load: slopes, a heading or shares are")
    limit = {name: _MOST * known[name] if most is None else most for name in chosen}
    unknowns = [
        _Unknown(f"slings.{name}.length", ("length", f"sling.{name}"), known[name], limit[name])
        for name in chosen
    ]

    def rows(hanging: Hanging) -> list[Row]:
        found: list[Row] = []
        if slopes is not None:
            found += [row.minus(wanted) for row, wanted in zip(hanging.slopes(), slopes, strict=True)]
        if heading is not None:
            row = hanging.heading()
            found.append(replace(row, value=math.remainder(row.value - heading, math.tau)))
        by_name = {sling.name: sling for sling in hanging.slings}
        found += [hanging.share(by_name[name]).minus(wanted) for name, wanted in (shares or {}).items()]
        return found

    search = _Search(scenario, unknowns, rows, time, "lengths of slings")
    changes = search.run()
    search.refuse_too_far(changes)
    _refuse_unsound(search.now.hanging)
    lengths = {name: known[name] + float(more) for name, more in zip(chosen, changes, strict=True)}
    return LengthAnswer(
        lengths=lengths,
        given={name: known[name] for name in chosen},
        before=search.first.hanging.rest,
        after=search.now.hanging.rest,
        residual=search.now.residual,
        steps=search.steps,
        scenario=search.now.scenario,
    )


def plumb_hooks(
    lift: str | Path | Scenario, *, hooks: Sequence[str] | None = None, time: float | None = None
) -> HookAnswer:
    """Places of hooks from which no hook is pulled aside, so that falls hang plumb.

    A load that stands at the start shall also come off without drift, so that a single hook ends over its
    centre of gravity, and several keep its heading.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        hooks: Hooks that may move; all that slings hang in if not given.
        time: Time of the plan [s] at which the load hangs; None for the end of the lift.

    Raises:
        CannotBeError: If it cannot be had, with the reason.
        NoEquilibriumError: If the lift as it is given has no equilibrium.
        ScenarioError: If the lift file is not right.
        ValueError: If a hook is asked for that there is not.
    """
    scenario = without_cases(lift if isinstance(lift, Scenario) else load_scenario(lift))
    question = Statics(scenario)
    used = Hanging(question, question.equilibrium(time)).hooks() if question.rig.loads else []
    told = {name: crane.at for name, crane in (scenario.cranes or {}).items() if name in used}
    chosen = used if hooks is None else list(hooks)
    for name in chosen:
        if name not in told:
            sentence = f"'{name}' is not a hook in which slings hang and whose place stands in the lift file"
            raise ValueError(f"{sentence}; {nearest(name, told)}")
    unknowns = [
        _Unknown(f"cranes.{name}.at.{axis}", (f"place_{axis}", name), told[name][place], math.inf)
        for name in chosen
        for place, axis in enumerate("xy")
    ]

    def rows(hanging: Hanging) -> list[Row]:
        found = [row for hook in used for row in hanging.side_pull(hook)]
        stood = _stood(hanging)
        if stood is not None:
            drift = [hanging.place(axis).minus(stood[axis]) for axis in (0, 1)]
            found += [Row(row.value / _HEIGHT, row.change / _HEIGHT) for row in drift]
            if len(used) > 1:
                row = hanging.heading()
                found.append(replace(row, value=math.remainder(row.value - stood[2], math.tau)))
        return found

    search = _Search(scenario, unknowns, rows, time, "places of hooks")
    changes = search.run()
    _refuse_unsound(search.now.hanging)
    pairs = {name: (2 * place, 2 * place + 1) for place, name in enumerate(chosen)}
    return HookAnswer(
        places={
            name: (told[name][0] + float(changes[x]), told[name][1] + float(changes[y]))
            for name, (x, y) in pairs.items()
        },
        given={name: (told[name][0], told[name][1]) for name in chosen},
        side_pulls={
            name: np.array([search.first.hanging.pull_on(name)[:2], search.now.hanging.pull_on(name)[:2]])
            for name in used
        },
        drift=_drifts(search),
        before=search.first.hanging.rest,
        after=search.now.hanging.rest,
        residual=search.now.residual,
        steps=search.steps,
        scenario=search.now.scenario,
    )


class _Search:
    """Newton's method with the least change, halving steps that do not better it."""

    def __init__(
        self,
        scenario: Scenario,
        unknowns: Sequence[_Unknown],
        rows: Callable[[Hanging], list[Row]],
        time: float | None,
        what: str,
    ) -> None:
        self._scenario, self._unknowns, self._rows, self._time = scenario, unknowns, rows, time
        self._what = what
        self.steps = 0
        self.first = self.now = self._try(np.zeros(len(unknowns)))

    def run(self) -> Floats:
        """Changes of the unknowns [m].

        Raises:
            CannotBeError: If no changes do it.
        """
        changes = np.zeros(len(self._unknowns))
        while self.now.residual > RESIDUAL:
            if self.steps == _STEPS:
                raise CannotBeError(f"no answer in {_STEPS} steps; {self.now.residual:.2g} is left")
            target = self._target(changes)
            if target is None:
                break
            self.steps += 1
            changes = self._step(changes, target)
        return changes

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
            raise CannotBeError(self._no_effect(slope, value))
        self.refuse_too_far(target, _FAR)
        return target

    def _step(self, changes: Floats, target: Floats) -> Floats:
        """Towards a target, as far as it betters things."""
        cause = "no change betters it any more"
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
            if found.residual < self.now.residual:
                self.now = found
                return step
        self.refuse_too_far(target)
        raise CannotBeError(f"{cause}; {self.now.residual:.2g} is left")

    def _try(self, changes: Floats) -> _Try:
        texts = {
            one.path: si_text(one.given + float(more), "length")
            for one, more in zip(self._unknowns, changes, strict=True)
        }
        scenario = with_values(self._scenario, texts) if changes.any() else self._scenario
        question = Statics(scenario)
        if len(question.rig.loads) != 1 or not question.rig.slings:
            raise CannotBeError("only a lift with a load on slings can be asked this")
        rest = question.equilibrium(self._time)
        load = question.rig.loads[0]
        if float(rest.recording.column("load_transferred", load.name)[-1]) < 1.0 - RESIDUAL:
            raise CannotBeError(f"{load.name} does not hang clear at {rest.time:g} s, it still stands")
        try:
            hanging = Hanging(question, rest, [one.parameter for one in self._unknowns])
        except (RuntimeError, ValueError) as problem:
            cause = ": ".join(str(part) for part in problem.args)
            raise CannotBeError(f"the lift has no sensitivities to these quantities ({cause})") from None
        return _Try(scenario, hanging, self._rows(hanging))

    def _too_far(self, one: _Unknown, more: float) -> str:
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
            raise CannotBeError(self._too_far(self._unknowns[worst], float(changes[worst])))

    def _no_effect(self, slope: Floats, value: Floats) -> str:
        worst = int(np.argmax(np.abs(value)))
        strongest = float(np.linalg.norm(slope, axis=1)[worst])
        effect = f"{self._what} do not act on what is wanted"
        if strongest > _NO_EFFECT:
            effect = f"{self._what} cannot do all of what is wanted at once"
        slack = ", ".join(self.now.hanging.slack())
        return f"{effect}{f'; slack: {slack}' if slack else ''}{_hint(self.now.hanging.rig)}"


def _hint(rig: Rig) -> str:
    """Why lengths do little under equalizers."""
    if any(rig.equalizer_of(sling) is None for sling in rig.slings):
        return ""
    names = " and ".join(equalizer.name for equalizer in rig.equalizers)
    return (
        f"; under {names} slings pull alike whatever their lengths: move the centre of gravity, lugs or hooks"
    )


def _refuse_unsound(hanging: Hanging) -> None:
    """Answers that a lift cannot hang in."""
    if not hanging.rest.is_stable:
        raise CannotBeError("hung so it is unstable")
    if hanging.slack():
        raise CannotBeError(f"hung so {', '.join(hanging.slack())} would be slack")
    beyond = hanging.beyond_travel()
    if beyond is not None:
        raise CannotBeError(f"hung so {beyond}")


def _stood(hanging: Hanging) -> Floats | None:
    """Place and heading of a load that stands at the start: x, y [m], angle [rad]; else None."""
    recording = hanging.rest.recording
    if len(recording.time) < 2 or not hanging.load.contacts:
        return None
    at = recording.column("body_position", hanging.load.body)[0]
    turned = float(heading_of(recording.column("body_orientation", hanging.load.body)[0]))
    return np.array([at[0], at[1], turned])


def _drifts(search: _Search) -> tuple[float, float] | None:
    def drift(one: Hanging) -> float | None:
        stood = _stood(one)
        if stood is None:
            return None
        return math.hypot(*(one.place(axis).value - stood[axis] for axis in (0, 1)))

    before, after = drift(search.first.hanging), drift(search.now.hanging)
    return None if before is None or after is None else (before, after)
