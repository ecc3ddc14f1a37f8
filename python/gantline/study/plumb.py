"""At what places of hooks, trolleys and cranes no fall is pulled aside."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Self

import numpy as np
import numpy.typing as npt

from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.results.rotation import heading as heading_of
from gantline.scenario import Scenario, load_scenario
from gantline.scenario.afloat.stream import Stream
from gantline.scenario.cranes.hooks import Hook
from gantline.scenario.errors import nearest
from gantline.scenario.file.variants import without_cases
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.steps import TravelStep, TraverseStep
from gantline.statics import Equilibrium, Statics
from gantline.study.asked import names_of
from gantline.study.bearers import Bearer, bearers_of, why_not
from gantline.study.hanging import Hanging, Row
from gantline.study.newton import AdjustError, CannotBeError, Search, Unknown
from gantline.study.put_in import refused_at_the_start
from gantline.study.state import rest_json
from gantline.units import format_by_size, format_quantity

__all__ = ["HookAnswer", "plumb_hooks"]

Floats = npt.NDArray[np.float64]

#: A drift counts like a slope over this height [m].
_HEIGHT = 10.0
#: What bears hooks has gone equally far if it has to this [m].
_ALIKE = 1e-3
#: What keeps falls plumb by itself is behind by no more: 0.006 deg of side pull over vertical force [1].
_PLUMB = 1e-4
#: A crane that leans on its ground turns by less than this, one that slews or luffs by more [rad].
_LEANS = 0.02


@dataclass(frozen=True)
class HookAnswer:
    """Places of hooks from which no hook is pulled aside, or no trolley and no crane that bears several.

    Attributes:
        values: New places in the lift file, by path [m].
        places: New place of each hook that moves at the start, along world x and y [m].
        given: Its place in the lift file [m].
        side_pulls: Horizontal force on each hook before and after, along world x and y [N], shape (2, 2).
        drift: How far the load's centre of gravity moves aside when it comes off, before and after, against
            what bears its hooks [m]; None of a load that stands on nothing at the start, or whose hooks go
            different ways, as cranes slew and luff.
        before: The lift as it is given, at rest.
        after: The same with the new places.
        cannot_start: What keeps a run of the lift file with the new places from starting, such as slings too
            short for the load where it stands; nothing where it starts. As a case they hang it all the same.
        residual: What is left, the largest: side pull over vertical force, drift over 10 m, heading [rad].
        steps: Steps of Newton's method; 0 where falls are plumb as it is given.
        scenario: The lift file with the new places.
    """

    values: Mapping[str, float]
    places: Mapping[str, tuple[float, float]]
    given: Mapping[str, tuple[float, float]]
    side_pulls: Mapping[str, Floats]
    drift: tuple[float, float] | None
    before: Equilibrium
    after: Equilibrium
    cannot_start: Sequence[str]
    residual: float
    steps: int
    scenario: Scenario

    def to_json(self) -> dict[str, Any]:
        """All but the lift file as a JSON object, SI units."""
        return {
            "values": dict(self.values),
            "places": {name: list(place) for name, place in self.places.items()},
            "given": {name: list(place) for name, place in self.given.items()},
            "side_pulls": {name: pulls.tolist() for name, pulls in self.side_pulls.items()},
            "drift": None if self.drift is None else list(self.drift),
            "before": rest_json(self.before),
            "after": rest_json(self.after),
            "cannot_start": list(self.cannot_start),
            "residual": self.residual,
            "steps": self.steps,
        }


def plumb_hooks(
    lift: str | Path | Scenario, *, hooks: Sequence[str] | None = None, time: float | None = None
) -> HookAnswer:
    """Places of hooks from which no hook is pulled aside, so that falls hang plumb.

    A fixed hook and a crawler crane may stand elsewhere along x and y, a trolley along its girder, a Goliath
    crane along its rails; those that bear several hooks are not pulled aside by all of them together. A load
    that stands at the start shall also come off without drift, so that a single hook ends over its centre of
    gravity, and keep its heading under several cranes.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        hooks: Hooks that may move, with their trolleys; a crane moves if all its hooks may. All that slings
            hang in if not given.
        time: Time of the plan [s] at which the load hangs; None for the end of the lift.

    Raises:
        AdjustError: If what may move is no hook in which slings hang.
        CannotBeError: If it cannot be had, with the reason.
        NoEquilibriumError: If the lift as it is given has no equilibrium.
        ScenarioError: If the lift file is not right.
        ValueError: If a hook is asked for that there is not, or one that floats.
    """
    scenario = without_cases(lift if isinstance(lift, Scenario) else load_scenario(lift))
    question = Statics(scenario)
    used = Hanging(question, question.equilibrium(time)).hooks() if question.rig.loads else []
    bearers = bearers_of(scenario, used)
    borne = {hook for one in bearers for hook in one.hooks}
    chosen = _may_move(scenario, used if hooks is None else names_of("hooks", hooks), used, borne)
    placed = _placed(question, bearers)
    moving = [one for one in bearers if one.may_move(chosen) and one not in placed]
    unknowns = [
        Unknown(one.path, (f"place_{'xy'[one.axis]}", one.body), one.given, math.inf) for one in moving
    ]
    wanted = _Wanted.of(scenario, used, bearers, drifts=not placed)
    search = Search(question, unknowns, wanted.rows, time, "places of hooks")
    changes = _found(search, placed)
    search.refuse_unsound()
    first, now = search.first.hanging, search.now.hanging
    given = {name: _place_of(first, scenario.hooks[name]) for one in moving for name in one.hooks}
    before, after = (
        math.hypot(*(row.value for row in drift)) if drift else None
        for drift in map(wanted.drift, (first, now))
    )
    values = {one.path: one.given + change for one, change in zip(moving, changes, strict=True)}
    return HookAnswer(
        values=values,
        places=_moved(given, moving, changes),
        given=given,
        side_pulls={name: np.array([one.pull_on(name)[:2] for one in (first, now)]) for name in used},
        drift=None if before is None or after is None else (before, after),
        before=first.rest,
        after=now.rest,
        cannot_start=refused_at_the_start(scenario, values),
        residual=search.now.residual,
        steps=search.steps,
        scenario=search.now.scenario,
    )


@dataclass(frozen=True)
class _Wanted:
    """What shall be nothing of a lift that hangs.

    Attributes:
        pulled: What is not pulled aside: its name, its hooks and the axis.
        bearers: What bears the hooks.
        drifts: Whether the load shall come off without drift where that can be asked.
        turns: Whether it shall keep its heading then.
    """

    pulled: Sequence[tuple[str, Sequence[str], int]]
    bearers: Sequence[Bearer]
    drifts: bool
    turns: bool

    @classmethod
    def of(cls, scenario: Scenario, used: Sequence[str], bearers: Sequence[Bearer], *, drifts: bool) -> Self:
        """What is wanted of the hooks in which slings hang."""
        borne = {hook for one in bearers for hook in one.hooks}
        # What nothing here bears is not pulled aside either: a boom's hook that may not move, on both axes.
        free = [(name, (name,), axis) for name in used if name not in borne for axis in (0, 1)]
        turns = len({scenario.hooks[name].crane for name in used}) > 1
        return cls([*((one.name, one.hooks, one.axis) for one in bearers), *free], bearers, drifts, turns)

    def drift(self, hanging: Hanging) -> list[Row] | None:
        """How far the load has drifted [m], if that is asked."""
        return _drift(hanging, self.bearers) if self.drifts else None

    def rows(self, hanging: Hanging) -> list[Row]:
        """All that shall be nothing."""
        found = [hanging.side_pull(name, those, axis) for name, those, axis in self.pulled]
        drift = self.drift(hanging)
        if drift is not None:
            found += [replace(row, value=row.value / _HEIGHT, change=row.change / _HEIGHT) for row in drift]
            if self.turns:
                row = hanging.heading()
                stood = _heading_at_the_start(hanging)
                found.append(replace(row, value=math.remainder(row.value - stood, math.tau)))
        return found


def _found(search: Search, placed: Sequence[Bearer]) -> list[float]:
    """Changes of the places [m]; none where what the plan places is plumb as it is given.

    Raises:
        CannotBeError: If it cannot be had, with the reason.
    """
    try:
        return [float(change) for change in search.run()]
    except CannotBeError as problem:
        if not placed or search.first.residual > _PLUMB:
            why = _where_the_plan_says(placed) + _what_pulls(search.first.scenario, search.first.hanging)
            raise CannotBeError(f"{problem}{why}") from None
    # What the plan has made plumb no place at the start makes plumber.
    return [float(change) for change in search.stay()]


def _may_move(
    scenario: Scenario, chosen: Sequence[str], used: Sequence[str], borne: Collection[str]
) -> Sequence[str]:
    """The hooks chosen, of those in which slings hang and of those with a bearer that can be elsewhere.

    Raises:
        AdjustError: If slings hang in none of that name.
        ValueError: If one has no such bearer.
    """
    for name in chosen:
        if name not in used:
            raise AdjustError(f"'{name}' is not a hook in which slings hang; {nearest(name, used)}")
        if name not in borne:
            raise ValueError(why_not(scenario.hooks[name]))
    return chosen


def _moved(
    given: Mapping[str, tuple[float, float]], moving: Sequence[Bearer], changes: Sequence[float]
) -> dict[str, tuple[float, float]]:
    """Places of hooks [m] once their bearers have moved along their axes by so much [m]."""
    places = {name: list(place) for name, place in given.items()}
    for one, change in zip(moving, changes, strict=True):
        for name in one.hooks:
            places[name][one.axis] += change
    return {name: (x, y) for name, (x, y) in places.items()}


def _placed(question: Statics, bearers: Sequence[Bearer]) -> list[Bearer]:
    """What goes `to` a place, or after its load, wherever it starts, and others that bear hooks do not.

    One alone along its axis shall still come off without drift, which its start decides.
    """
    found = []
    for step in question.scenario.plan:
        if not isinstance(step, TraverseStep | TravelStep):
            continue
        began, ended = question.times_of(step.step)
        for text in step.moved:
            moved = mover(question.scenario, step.kind, text)
            for one in bearers:
                beside = [other for other in bearers if other.axis == one.axis and other != one]
                is_there = step.to is not None and ended is not None and not one.counts_from_it
                follows = step.keep_plumb is not None and began is not None
                if moved is not None and moved.name == one.name and beside and (is_there or follows):
                    found.append(one)
    return found


def _where_the_plan_says(placed: Sequence[Bearer]) -> str:
    if not placed:
        return ""
    names = [f"'{name}'" for name in dict.fromkeys(one.name for one in placed)]
    they = "is where the plan says, wherever it starts"
    if len(names) > 1:
        they = "are where the plan says, wherever they start"
    return f"; {' and '.join(names)} {they}: ask at a time before that"


def _what_pulls(scenario: Scenario, hanging: Hanging) -> str:
    """What pulls or pushes the load aside: then falls cannot all be plumb, wherever their hooks are."""
    tensions = {line.name: hanging.rest.tension(line.rope) for line in hanging.rig.tag_lines}
    pulls = [f"{name} with {format_by_size(pull, 'force')}" for name, pull in tensions.items() if pull > 0.0]
    found = f"; tag lines pull the load aside: {', '.join(pulls)}" if pulls else ""
    load = scenario.load
    for kind in ("wind", "current"):
        stream = getattr(scenario, kind)
        if isinstance(stream, Stream) and stream.speed > 0.0 and getattr(load, f"{kind}_areas", None):
            pushes = f"the {kind} of {format_quantity(stream.speed, 'm/s', 1)} pushes the load aside"
            found += f"; {pushes}"
    return found


def _place_of(hanging: Hanging, hook: Hook) -> tuple[float, float]:
    """Where a hook is at the start along world x and y [m]; at a boom, where its falls hold it."""
    if hook.carrier is None or hook.carrier.kind == "trolley":
        return hook.place
    x, y, _ = hanging.rest.recording.column("body_position", hook.name)[0]
    return float(x), float(y)


def _drift(hanging: Hanging, bearers: Sequence[Bearer]) -> list[Row] | None:
    """How far a load that stood at the start has moved along x and y, against what bears its hooks [m]."""
    recording = hanging.rest.recording
    if len(recording.time) < 2 or not hanging.load.contacts:
        return None
    if any(_turned(recording, body) > _LEANS for one in bearers for body in one.turning):
        return None
    stood = recording.column("body_position", hanging.load.body)[0]
    rows = []
    for axis in (0, 1):
        moved = [recording.column("body_position", one.body)[:, axis] for one in bearers if one.axis == axis]
        gone = [float(place[-1] - place[0]) for place in moved]
        if gone and max(gone) - min(gone) > _ALIKE:
            return None
        rows.append(hanging.place(axis).minus(float(stood[axis]) + (float(np.mean(gone)) if gone else 0.0)))
    return rows


def _turned(recording: Recording, body: str) -> float:
    """By what angle a body has turned since the start [rad]."""
    then, now = axes(recording.column("body_orientation", body)[[0, -1]])
    return float(np.arccos(np.clip((np.trace(then.T @ now) - 1.0) / 2.0, -1.0, 1.0)))


def _heading_at_the_start(hanging: Hanging) -> float:
    turned = hanging.rest.recording.column("body_orientation", hanging.load.body)
    return float(heading_of(turned[0]))
