"""What rights vessels where a run begins and ends, where steps of its plan end, and as tanks fill.

And what contingency would do to them there.

One that is symmetrical does not show it in its motion.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np
import numpy.typing as npt

from gantline.results.afloat.vessels import AtRest, ByContingency, Heights
from gantline.results.rotation import axes
from gantline.results.variable import Columns, FloatArray, Names
from gantline.scenario.afloat.tanks import holed_tanks
from gantline.statics.answers import Equilibrium, Losses, NoEquilibriumError
from gantline.statics.contingency import by_contingency
from gantline.statics.inclining import metacentric_heights
from gantline.statics.open_tanks import with_what_has_run

if TYPE_CHECKING:
    from gantline.statics.lift import Statics

__all__ = ["Waypoint", "at_end", "at_start", "of_equilibrium", "on_the_way", "stands_aboard"]

#: How far from where it lies in a run a vessel may come to rest before it is asked what rights it there
#: [rad]. One of GM = -6 mm with BM = 20 m comes to rest by sqrt(-2 GM/BM) = 1.4 deg.
_ELSEWHERE = math.radians(1.0)
#: Slower than that it does not roll through upright but stands there [rad/s].
_STILL = 1e-4
#: What friction does where it is asked what rights vessels, in turn until they rest.
_LOSSES: Final[tuple[Losses, ...]] = ("none", "held")


def of_equilibrium(question: Statics, rest: Equilibrium) -> AtRest:
    """What it says of vessels: what rights those that nothing rights, or all of them if they have a limit.

    Args:
        question: The lift.
        rest: Its equilibrium that was found last.
    """
    try:
        heights = _righting_of(question, rest)
    except NoEquilibriumError:  # it answers to no push smoothly
        return AtRest({}, {})
    return AtRest(heights, by_contingency(question, rest, heights))


def _righting_of(question: Statics, rest: Equilibrium, *, at_level: bool = False) -> Heights:
    """Metacentric heights of those, with an error where it answers to no push smoothly."""
    limits = question.scenario.limits
    is_limited = limits is not None and limits.metacentric_height is not None
    # What runs through holes is not in the stability of an equilibrium.
    is_known = rest.is_stable and not holed_tanks(question.scenario)
    if not rest.recording.rig.vessels or (is_known and not is_limited):
        return {}
    heights = metacentric_heights(question, rest, at_level=at_level)
    both = {name: (one.transverse, one.longitudinal) for name, one in heights.items()}
    return {
        name: found
        for name, found in both.items()
        if (is_limited and math.isfinite(found[0])) or min(found) < 0.0
    }


def at_start(question: Statics) -> AtRest:
    """The same where a lift starts at rest."""
    return _without_friction_first(question, lambda losses: question.equilibrium(0.0, losses=losses))


def at_end(question: Statics, time: float, state: bytes, attitudes: Mapping[str, npt.ArrayLike]) -> AtRest:
    """The same where a run has got to; nothing of one that comes to rest nowhere.

    What rounding has moved goes on downhill: where it comes to rest elsewhere, the equilibrium of the plan
    tells what rights it, with what has run through holes by then.

    Args:
        question: The lift.
        time: To which the run has got [s].
        state: What it has saved there.
        attitudes: Of its vessels there by their bodies, world from body, shape (4,).
    """

    def rest(losses: Losses) -> Equilibrium:
        found = question.equilibrium_of(state, losses=losses)
        if found.is_stable and _is_elsewhere(found, attitudes):
            as_it_is = with_what_has_run(question, found.recording)
            return as_it_is.equilibrium(min(time, question.scenario.duration), losses=losses)
        return found

    return _without_friction_first(question, rest)


class Waypoint(NamedTuple):
    """A moment of a run, in the words of its plan."""

    #: The step that has ended, or that began last; None before any has.
    step: str | None
    #: For how long it has gone on [s]; None where it has ended.
    since: float | None
    #: Of the run [s].
    time: float
    #: What was saved there.
    state: bytes


def on_the_way(question: Statics, waypoint: Waypoint, columns: Columns, names: Names) -> AtRest:
    """The same where a step of the plan has ended in a run, or the surface in a tank has come or gone.

    One that stands where it would not come to rest, and does not move, is held by its symmetry alone: the
    equilibrium of the plan at this moment tells what rights it. One that waves roll is not.

    Within a step, all stops: what rushes through a hole then answers to no heel as it will once it is level.

    Args:
        question: The lift.
        waypoint: The moment.
        columns: What the run has recorded.
        names: Names along these.
    """
    orientations, times = columns["body_orientation"], columns["time"]
    last = max(int(np.searchsorted(times, waypoint.time, side="right")) - 1, 0)
    before = max(last - 1, 0)
    bodies = {name: number for number, name in enumerate(names["body"])}

    def stands(found: Equilibrium) -> dict[str, FloatArray]:
        """Vessels that do not move towards where they come to rest, or away from it, and how they lie."""
        still = {}
        for body in (vessel.body for vessel in question.rig.vessels):
            was, lies = (orientations[sample, bodies[body]] for sample in (before, last))
            away = _upright(found.recording.column("body_orientation", body)[-1]) - _upright(lies)
            moved = float((_upright(lies) - _upright(was)) @ away)
            if abs(moved) <= _STILL * float(np.linalg.norm(away)) * float(times[last] - times[before]):
                still[body] = lies
        return still

    def rest(losses: Losses) -> Equilibrium:
        found = question.equilibrium_of(waypoint.state, losses=losses)
        if not (found.is_stable and _is_elsewhere(found, stands(found))):
            return found
        asked = with_what_has_run(question, found.recording)
        then = _in_equilibria(asked, waypoint)
        return found if then is None else asked.equilibrium(then, losses=losses)

    return _without_friction_first(question, rest, at_level=waypoint.since is not None)


def _in_equilibria(question: Statics, waypoint: Waypoint) -> float | None:
    """When that moment is while the lift goes from rest to rest [s], whose steps take other times."""
    if waypoint.step is None:
        return waypoint.time
    ends = question.when(waypoint.step, "ends")
    if waypoint.since is None:
        return ends
    begins = question.when(waypoint.step, "begins")
    return None if begins is None else min(begins + waypoint.since, math.inf if ends is None else ends)


def _without_friction_first(
    question: Statics, rest: Callable[[Losses], Equilibrium], *, at_level: bool = False
) -> AtRest:
    """What is said of vessels where they rest without friction, with it where nothing rests without.

    Friction rights no vessel: one that fenders hold to its neighbour as long as they stick seems to have of
    its neighbour's GM. Nor do slings into which a load slides that stands aboard a vessel with heel, and that
    friction would hold: of both the least counts then.
    """
    found: Heights = {}
    changes: Mapping[str, ByContingency] = {}
    for losses in _LOSSES:
        try:
            there = rest(losses)
            heights = _righting_of(question, there, at_level=at_level)
            changes = _later(changes, by_contingency(question, there, heights))
        except NoEquilibriumError:
            continue
        for name, (heel, trim) in heights.items():
            other = found.get(name, (heel, trim))
            found[name] = min(heel, other[0]), min(trim, other[1])
        if not stands_aboard(there):
            break
    return AtRest(found, changes)


def _later(
    before: Mapping[str, ByContingency], found: Mapping[str, ByContingency]
) -> Mapping[str, ByContingency]:
    """What the design weight changes as found last, that nothing rights a vessel as found before too."""
    if not found:
        return before
    return {
        name: replace(one, least_height=before[name].least_height)
        if one.least_height is None and name in before
        else one
        for name, one in found.items()
    }


def stands_aboard(rest: Equilibrium) -> bool:
    """Whether a load is pressed against what floats or moves, by which friction may hold it."""
    recording = rest.recording
    return any(
        recording.column("contact_force", contact)[-1] > 0.0
        for load in recording.rig.loads
        for contact in load.meets
    )


def _upright(orientation: npt.ArrayLike) -> FloatArray:
    """The upright of the world in axes of a body, shape (3,)."""
    upright: FloatArray = axes(np.asarray(orientation, dtype=np.float64))[2]
    return upright


def _is_elsewhere(rest: Equilibrium, attitudes: Mapping[str, npt.ArrayLike]) -> bool:
    """Whether a vessel comes to rest with another heel or trim."""
    for body, attitude in attitudes.items():
        end = rest.recording.column("body_orientation", body)[-1]
        if float(_upright(attitude) @ _upright(end)) < math.cos(_ELSEWHERE):
            return True
    return False
