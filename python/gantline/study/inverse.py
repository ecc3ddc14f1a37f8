"""Inverse questions: what lengths of slings, or places of hooks, make a load hang as it is wanted."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gantline.results.rotation import heading as heading_of
from gantline.scenario import Scenario, load_scenario
from gantline.scenario.errors import join_path, nearest
from gantline.scenario.hooks import Hook
from gantline.scenario.rigging import resolve
from gantline.scenario.variants import without_cases
from gantline.statics import Equilibrium, Statics
from gantline.study.hanging import Hanging, Row
from gantline.study.newton import CannotBeError, Search, Unknown

__all__ = ["AdjustError", "CannotBeError", "HookAnswer", "LengthAnswer", "adjust_lengths", "plumb_hooks"]

Floats = npt.NDArray[np.float64]

#: Most by which a length may change where it is not said, of the length.
_MOST = 0.1
#: A drift counts like a slope over this height [m].
_HEIGHT = 10.0


class AdjustError(ValueError):
    """A sling or hook that may change is none."""


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
        shares: Wanted vertical force of slings over that of all beside them [1], by name: of all that end
            on the load, or of all that hang in hooks for one above spreaders and extension sheaves.
        slings: Slings that may change; all if not given.
        most: Largest change of a length [m]; a tenth of it if not given.
        time: Time of the plan [s] at which the load hangs; None for the end of the lift.

    Raises:
        AdjustError: If what may change is no sling.
        CannotBeError: If it cannot be had, with the reason.
        NoEquilibriumError: If the lift as it is given has no equilibrium.
        ScenarioError: If the lift file is not right.
        ValueError: If nothing is wanted, or a sling is asked for that there is not.
    """
    scenario = without_cases(lift if isinstance(lift, Scenario) else load_scenario(lift))
    known = {name: one.length for name, one in resolve(scenario).slings.items()}
    chosen = list(known) if slings is None else list(slings)
    for names, error in ((chosen, AdjustError), (shares or {}, ValueError)):
        for name in names:
            if name not in known:
                raise error(f"'{name}' is not a sling; {nearest(name, known)}")
    for name, share in (shares or {}).items():
        if not 0.0 <= share <= 1.0:
            sentence = f"{name}: {100.0 * share:g} % is no share of what all slings carry"
            raise ValueError(f"{sentence}; one is written like '30 %' or '0.3'")
    if slopes is None and heading is None and not shares:
        raise ValueError("nothing is wanted of the load: slopes, a heading or shares are")
    limit = {name: _MOST * known[name] if most is None else most for name in chosen}
    unknowns = [
        Unknown(f"slings.{name}.length", ("length", f"sling.{name}"), known[name], limit[name])
        for name in chosen
    ]

    def rows(hanging: Hanging) -> list[Row]:
        found: list[Row] = []
        if slopes is not None:
            found += [row.minus(wanted) for row, wanted in zip(hanging.slopes(), slopes, strict=True)]
        if heading is not None:
            row = hanging.heading()
            found.append(replace(row, value=math.remainder(row.value - heading, math.tau)))
        try:
            found += [hanging.share(name).minus(wanted) for name, wanted in (shares or {}).items()]
        except ValueError as problem:
            raise CannotBeError(str(problem)) from None
        return found

    search = Search(scenario, unknowns, rows, time, "lengths of slings")
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
        AdjustError: If what may move is no hook in which slings hang.
        CannotBeError: If it cannot be had, with the reason.
        NoEquilibriumError: If the lift as it is given has no equilibrium.
        ScenarioError: If the lift file is not right.
        ValueError: If a hook is asked for that there is not.
    """
    scenario = without_cases(lift if isinstance(lift, Scenario) else load_scenario(lift))
    question = Statics(scenario)
    used = Hanging(question, question.equilibrium(time)).hooks() if question.rig.loads else []
    # Not every type of crane says where its hook is.
    places = {name: getattr(crane, "at", None) for name, crane in (scenario.cranes or {}).items()}
    told = {name: at for name, at in places.items() if at is not None and name in used}
    chosen = used if hooks is None else list(hooks)
    for name in chosen:
        if name not in used:
            raise AdjustError(f"'{name}' is not a hook in which slings hang; {nearest(name, used)}")
        if name not in told:
            sentence = f"the hook '{name}' has no place of its own in the lift file that could be moved"
            sentence = f"{sentence}; only hooks of 'type: fixed_hook' have, by 'at'"
            raise ValueError(f"{sentence}. {_instead(scenario.hooks[name])}")
    unknowns = [
        Unknown(f"cranes.{name}.at.{axis}", (f"place_{axis}", name), told[name][place], math.inf)
        for name in chosen
        for place, axis in enumerate("xy")
    ]

    def rows(hanging: Hanging) -> list[Row]:
        found = [row for hook in used for row in hanging.side_pull(hook)]
        stood = _stood(hanging)
        if stood is not None:
            drift = [hanging.place(axis).minus(stood[axis]) for axis in (0, 1)]
            found += [replace(row, value=row.value / _HEIGHT, change=row.change / _HEIGHT) for row in drift]
            if len(used) > 1:
                row = hanging.heading()
                found.append(replace(row, value=math.remainder(row.value - stood[2], math.tau)))
        return found

    search = Search(scenario, unknowns, rows, time, "places of hooks")
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


def _instead(hook: Hook) -> str:
    """How else falls come to hang plumb, of a hook that a trolley or a boom bears."""
    carrier = "boom" if hook.carrier is None else hook.carrier.kind
    own = "position" if carrier == "trolley" else "boom.angle"
    path = join_path((*hook.paths[""][:-2], own))
    sentence = f"'keep_plumb' in a step of the plan lets its {carrier} follow the load"
    return f"{sentence}, and a sweep of '{path}' shows how it hangs elsewhere"


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


def _drifts(search: Search) -> tuple[float, float] | None:
    def drift(one: Hanging) -> float | None:
        stood = _stood(one)
        if stood is None:
            return None
        return math.hypot(*(one.place(axis).value - stood[axis] for axis in (0, 1)))

    before, after = drift(search.first.hanging), drift(search.now.hanging)
    return None if before is None or after is None else (before, after)
