"""What lengths of slings make a load hang as it is wanted."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from gantline.arguments import number
from gantline.results import series
from gantline.results.rotation import axes
from gantline.scenario import Scenario, load_scenario
from gantline.scenario.errors import nearest
from gantline.scenario.file.variants import without_cases
from gantline.scenario.rigging import SlingRigging, resolve
from gantline.statics import Equilibrium, Statics
from gantline.study.asked import names_of
from gantline.study.hanging import Hanging, Row
from gantline.study.newton import AdjustError, CannotBeError, Search, SlackError, Unknown
from gantline.study.put_in import refused_at_the_start
from gantline.study.state import rest_json

__all__ = ["LengthAnswer", "adjust_lengths"]

#: Most by which a length may change where it is not said, of the length.
_MOST = 0.1
#: What changes, in words.
_WHAT = "lengths of slings"


@dataclass(frozen=True)
class LengthAnswer:
    """Unstretched lengths of slings with which a load hangs as wanted.

    Attributes:
        lengths: New length of each sling that may change [m].
        given: Its length in the lift file [m].
        chain_hoists: What the chain hoist of a sling that has one pays out from there to the new length [m],
            less than 0 where it hauls in; stretched as the chain is meanwhile, in the mean.
        before: The lift as it is given, at rest.
        after: The same with the new lengths.
        slack_by_least_change: Slings that the least change would leave slack, where slopes were wanted and no
            shares: of all changes with the slopes that is taken then whose shares are as even as can be.
        cannot_start: What keeps a run of the lift file with the new lengths from starting, such as slings too
            short for the load where it stands; nothing where it starts. As a case they hang it all the same.
        residual: What is left of slopes, heading and shares [rad, 1]; the largest.
        steps: Steps of Newton's method.
        scenario: The lift file with the new lengths.
    """

    lengths: Mapping[str, float]
    given: Mapping[str, float]
    chain_hoists: Mapping[str, float]
    before: Equilibrium
    after: Equilibrium
    slack_by_least_change: Sequence[str]
    cannot_start: Sequence[str]
    residual: float
    steps: int
    scenario: Scenario

    @property
    def values(self) -> dict[str, float]:
        """New lengths in the lift file, by path [m]."""
        return _values(self.lengths)

    def to_json(self) -> dict[str, Any]:
        """All but the lift file as a JSON object, SI units."""
        return {
            "values": self.values,
            "lengths": dict(self.lengths),
            "given": dict(self.given),
            "chain_hoists": dict(self.chain_hoists),
            "before": rest_json(self.before),
            "after": rest_json(self.after),
            "slack_by_least_change": list(self.slack_by_least_change),
            "cannot_start": list(self.cannot_start),
            "residual": self.residual,
            "steps": self.steps,
        }


def _values(lengths: Mapping[str, float]) -> dict[str, float]:
    return {f"slings.{name}.length": length for name, length in lengths.items()}


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

    Where slopes are wanted, no shares, and the least change would leave slings slack of those that go from
    one hook to the load, they are changed so that these share it as evenly as can be.

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
        TypeError: If an angle, a share or `most` is no number, such as a text with a unit, or shares have no
            names.
        ValueError: If nothing is wanted, nothing may change, or a sling is asked for that there is not.
    """
    scenario = without_cases(lift if isinstance(lift, Scenario) else load_scenario(lift))
    slung = resolve(scenario).slings
    known = {name: one.length for name, one in slung.items()}
    chosen = list(known) if slings is None else names_of("slings", slings)
    if shares is not None and not isinstance(shares, Mapping):
        raise TypeError(f"shares: a dictionary by slings is needed, not {type(shares).__name__}")
    _refuse(chosen, shares or {}, known)
    if slopes is None and heading is None and not shares:
        raise ValueError("nothing is wanted of the load: slopes, a heading or shares are")
    _check_angles(slopes, heading)
    if most is not None and not number(most, "most", "metres") > 0.0:
        raise ValueError(f"most: {most:g} m is no change; one above zero is needed")
    limit = {name: _MOST * known[name] if most is None else most for name in chosen}
    unknowns = [
        Unknown(f"slings.{name}.length", ("length", f"sling.{name}"), known[name], limit[name])
        for name in chosen
    ]

    def search_for(wanted: Mapping[str, float]) -> tuple[Search, npt.NDArray[np.float64]]:
        search = Search(
            question, unknowns, lambda hanging: _rows(hanging, slopes, heading, wanted), time, _WHAT
        )
        changes = search.run(
            _taut(search.first.hanging, [slung[name] for name in chosen]) if wanted else None
        )
        search.refuse_too_far(changes)
        search.refuse_unsound()
        return search, changes

    question = Statics(scenario)
    slack: Sequence[str] = ()
    try:
        search, changes = search_for(shares or {})
    except SlackError as problem:
        slack = problem.slack
        evenly = None if shares or slopes is None else _even_shares(problem.hanging, slopes)
        if evenly is None:
            raise
        try:
            search, changes = search_for(evenly)
        except CannotBeError:
            raise problem from None
    lengths = {name: known[name] + float(more) for name, more in zip(chosen, changes, strict=True)}
    before, after = search.first.hanging.rest, search.now.hanging.rest
    return LengthAnswer(
        lengths=lengths,
        given={name: known[name] for name in chosen},
        chain_hoists={
            name: (lengths[name] - known[name]) * (1.0 + _mean_strain(slung[name], before, after))
            for name in chosen
            if slung[name].chain_hoist is not None
        },
        before=before,
        after=after,
        slack_by_least_change=slack,
        cannot_start=refused_at_the_start(scenario, _values(lengths)),
        residual=search.now.residual,
        steps=search.steps,
        scenario=search.now.scenario,
    )


def _check_angles(slopes: tuple[float, float] | None, heading: float | None) -> None:
    """Refuse wanted angles that are none.

    Raises:
        TypeError: If one is no number, or slopes are not two.
    """
    if slopes is not None and np.shape(slopes) != (2,):
        raise TypeError(f"slopes: {slopes!r} are no two angles in radians, such as (0.0, 0.0)")
    for angle in () if slopes is None else slopes:
        number(angle, "slopes", "radians")
    if heading is not None:
        number(heading, "heading", "radians")


def _refuse(chosen: Sequence[str], shares: Mapping[str, float], known: Collection[str]) -> None:
    """Refuse names that are no slings, and shares that are none.

    Raises:
        AdjustError: If what may change is no sling.
        ValueError: If a share is none, or that of no sling.
    """
    for names, error in ((chosen, AdjustError), (shares, ValueError)):
        for name in names:
            if name not in known:
                raise error(f"'{name}' is not a sling; {nearest(name, known)}")
    for name, share in shares.items():
        if not 0.0 <= number(share, f"shares: {name}", "parts of one") <= 1.0:
            sentence = f"{name}: {100.0 * share:g} % is no share of what all slings carry"
            raise ValueError(f"{sentence}; one is written like '30 %' or '0.3'")


def _rows(
    hanging: Hanging,
    slopes: tuple[float, float] | None,
    heading: float | None,
    shares: Mapping[str, float],
) -> list[Row]:
    """What is to vanish.

    Raises:
        CannotBeError: If a sling has no share.
    """
    found: list[Row] = []
    if slopes is not None:
        found += [row.minus(wanted) for row, wanted in zip(hanging.slopes(), slopes, strict=True)]
    if heading is not None:
        row = hanging.heading()
        found.append(replace(row, value=math.remainder(row.value - heading, math.tau)))
    try:
        found += [hanging.share(name).minus(wanted) for name, wanted in shares.items()]
    except ValueError as problem:
        raise CannotBeError(str(problem)) from None
    return found


def _even_shares(hanging: Hanging, slopes: tuple[float, float]) -> dict[str, float] | None:
    """Shares of slings from one hook to the load that are as even as can be, of all but three [1].

    Of shares V that keep the balance under a hook over the centre of gravity, Σ V = 1 and Σ V p/(h − z) = 0
    with lugs p beside it and z above it and the hook h above it, those with the least Σ V². The three others,
    whose lugs are farthest from being in a line, follow.

    Args:
        hanging: The load, some slings slack.
        slopes: By what angle its own axes shall rise [rad].

    Returns:
        None where slings hang otherwise, are three or fewer, or one could bear nothing even so.
    """
    recording = hanging.rest.recording
    slings = [sling for sling in hanging.slings if sling.to_load is not None]
    if len(hanging.hooks()) != 1 or len(slings) != len(series.slings_on(recording)) or len(slings) < 4:
        return None
    ends = np.array([[end[-1] for end in series.rope_ends(recording, sling.rope)] for sling in slings])
    centre = recording.column("body_position", hanging.load.body)[-1]
    own = (ends[:, 1] - centre) @ axes(recording.column("body_orientation", hanging.load.body)[-1])
    lugs = own @ _leant(slopes)
    heights = (ends[:, 0, 2] - centre[2]).mean() - lugs[:, 2]
    if heights.min() <= 0.0:
        return None
    balance = np.column_stack([np.ones(len(slings)), lugs[:, :2] / heights[:, np.newaxis]]).T
    shares = np.linalg.pinv(balance) @ np.array([1.0, 0.0, 0.0])
    if shares.min() <= 0.0:
        return None
    apart = [
        (abs(float(np.linalg.det(balance[:, three]))), three)
        for three in (list(some) for some in itertools.combinations(range(len(slings)), 3))
    ]
    follow = max(apart)[1]
    return {
        sling.name: float(share)
        for index, (sling, share) in enumerate(zip(slings, shares, strict=True))
        if index not in follow
    }


def _leant(slopes: tuple[float, float]) -> npt.NDArray[np.float64]:
    """The world's axes in those of a load that leans so, level, level and up, at any heading, as columns.

    Returns:
        Shape (3, 3).
    """
    up = np.array([math.sin(slopes[0]), math.sin(slopes[1]), 0.0])
    up[2] = math.sqrt(max(0.0, 1.0 - up @ up))
    ahead = np.array([up[2], 0.0, -up[0]]) / math.hypot(up[0], up[2])
    return np.column_stack([ahead, np.cross(up, ahead), up])


def _taut(hanging: Hanging, slings: Sequence[SlingRigging]) -> npt.NDArray[np.float64]:
    """Changes of lengths by which slings that are slack come to bear [m]: until then they act on no share."""
    recording, slack = hanging.rest.recording, hanging.slack()
    pulls = [hanging.rest.tension(sling.rope) for sling in hanging.slings if sling.name not in slack]
    changes = np.zeros(len(slings))
    for index, sling in enumerate(slings):
        if sling.name in slack and pulls:
            top, bottom = (end[-1] for end in series.rope_ends(recording, f"sling.{sling.name}"))
            stretch = 1.0 + sling.rope.strain_under(sum(pulls) / len(pulls))
            changes[index] = float(np.linalg.norm(top - bottom)) / stretch - sling.length
    return changes


def _mean_strain(sling: SlingRigging, before: Equilibrium, after: Equilibrium) -> float:
    """Strain of a sling that stretches [1], the mean of that in two equilibria."""
    pulls = (rest.tension(f"sling.{sling.name}") for rest in (before, after))
    return sum(0.5 * sling.rope.strain_under(pull) for pull in pulls)
