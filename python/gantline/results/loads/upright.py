"""Whether loads and spreaders hang stably where they hang still.

A run of perfect symmetry stays where any push would end it: nothing pushes but rounding. So the stiffness
of what hangs is taken from where it hangs. With u the way up along a sling, T its tension, l its length,
k = EA/L, and J how the distance of its ends follows places and turns of bodies about their centres of
gravity, it gives

    k J^T u u^T J + T/l J^T (1 - u u^T) J,  and at a lever r  -(f r^T + r f^T)/2 + (f.r) 1

over the turns of a body that it pulls with f: (SP2) of docs/concepts/spreader.md. A sling over an extension
sheave does so with each leg, and keeps but the sum of both; the sheave is a point that it pulls. Weight acts
at centres of gravity and gives nothing. Slings of an equalizer whose sheaves move keep but the sum of their
lengths. Turning about plumb, which nothing may hold, is held here, as hooks and frames of equalizers are: all
of that makes what hangs stiffer than it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gantline.results import series
from gantline.results.cranes.chain_hoists import sling_lengths
from gantline.results.gear import Sling, Spreader
from gantline.results.loads.hinges import is_shut
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.ropes.parting import DETACHED, while_there
from gantline.results.ropes.pinned import pinned_sheaves
from gantline.results.variable import BoolArray, FloatArray

__all__ = [
    "TopHeavy",
    "borne_by_water",
    "heels_over",
    "left_to_statics",
    "top_heavy",
    "unknown_whether_upright",
]

#: Of slings of which it is not known: stiffer than steel of these lengths [N/m].
_STIFF = 1e9
#: Height by which what hangs may be too high before it is told [m]: nobody knows a centre of gravity so well.
_TOO_HIGH = 0.005
#: Share of its weight that other ropes, or water, may bear of a load before nothing is said of it [1].
_BORNE = 0.05
#: Share of its weight that slings bear of a load at least where they tell how it would hang [1].
_MOSTLY = 0.8


@dataclass(frozen=True)
class TopHeavy:
    """A load or spreader that turns over if anything pushes it.

    Attributes:
        name: Its name.
        time: When it hung still so [s].
        too_high: By how much what weighs on it is too high to hang stably [m].
    """

    name: str
    time: float
    too_high: float


def top_heavy(recording: Recording) -> list[TopHeavy]:
    """Loads and spreaders that hang still unstably: the first time of each; none where ropes are not known.

    Nor is there any where a place or tension is no number.

    Args:
        recording: Of a run, or of an equilibrium.
    """
    found: dict[str, TopHeavy] = {}
    clear = series.is_clear(recording)
    for window in series.quiet_windows(recording):
        last = int(np.flatnonzero(window)[-1])
        for one in _at(recording, last) if clear[last] else ():
            found.setdefault(one.name, one)
    return list(found.values())


def heels_over(recording: Recording) -> list[TopHeavy]:
    """Loads that hooks hoist and that never hang clear, since they would hang unstably.

    Such a load turns about its last corner on what it stands on as long as it is hoisted, and bounces on
    it. It is looked at where the run ends, with most of its weight in its slings; where steps lower hooks
    it may have been set down, and where the last that hoists stops short of lifting it, as to weigh it, it
    was never meant to hang. Nor does one stand on what holds it down from above.

    Args:
        recording: Of a run.
    """
    kinds = {step.acts_as for step in recording.rig.plan}
    if recording.is_equilibrium or "hoist" not in kinds or "lower" in kinds or not len(recording.time):
        return []
    found = []
    for load in recording.rig.loads if not series.quiet_windows(recording) else ():
        hung = recording.column("load_transferred", load.name)[-1]
        if _stops_short(recording, load) or series.borne(recording, load)[-1] < 0.0:
            continue
        if hung > _MOSTLY and not series.load_is_clear(recording, load)[-1]:
            found += [one for one in _at(recording, len(recording.time) - 1) if one.name == load.name]
    return found


def _stops_short(recording: Recording, load: Load) -> bool:
    """Whether the last step that hoists ends by its condition with a load on its supports, as wanted then."""
    ends = {name: time for time, _, name in recording.events("step_end")}
    last = [step for step in recording.rig.plan if step.acts_as == "hoist"][-1]
    if last.ends_by != "until" or last.step not in ends:
        return False
    at = min(int(np.searchsorted(recording.time, ends[last.step])), len(recording.time) - 1)
    return not series.load_is_clear(recording, load)[at]


def left_to_statics(recording: Recording) -> dict[str, list[int]]:
    """Last samples of the times at which each load hung still and slings do not tell how stably.

    It hangs in ropes that are no slings, or has liquid in its tanks.

    Args:
        recording: Of a run, or of an equilibrium.
    """
    return _last_samples(recording, _is_left_to_statics)


def borne_by_water(recording: Recording) -> dict[str, list[int]]:
    """Last samples of the times at which each load hung still, or floated, with water bearing a part of it.

    Args:
        recording: Of a run, or of an equilibrium.
    """
    return _last_samples(recording, _is_borne_by_water)


def _last_samples(
    recording: Recording, holds: Callable[[Recording, Load, int], bool]
) -> dict[str, list[int]]:
    """Last samples of the times at which loads hung still and something holds of them."""
    clear = series.is_clear(recording)
    found: dict[str, list[int]] = {}
    for window in series.quiet_windows(recording):
        last = int(np.flatnonzero(window)[-1])
        for load in recording.rig.loads if clear[last] else ():
            if holds(recording, load, last):
                found.setdefault(load.name, []).append(last)
    return found


def unknown_whether_upright(recording: Recording) -> list[Load]:
    """Loads that hung still so that slings do not tell how stably, and no equilibrium does.

    Where an equilibrium has told how it rests there, that is known.

    Args:
        recording: Of a run, or of an equilibrium.
    """
    left = left_to_statics(recording)

    def is_known(load: Load) -> bool:
        times = {float(recording.time[sample]) for sample in left[load.name]}
        return times <= {one.time for one in load.resting}

    return [load for load in recording.rig.loads if load.name in left and not is_known(load)]


def _is_left_to_statics(recording: Recording, load: Load, sample: int) -> bool:
    """Whether ropes that are no slings bear more than a little of a load, or liquid runs about in it."""
    others = (float(recording.column("rope_tension", rope)[sample]) for rope in load.other_ropes)
    weight = float(series.load_weight(recording, load)[sample])
    return sum(others) > _BORNE * weight or weight > load.weight


def _is_borne_by_water(recording: Recording, load: Load, sample: int) -> bool:
    """Whether a load is wet, and all its ropes together do not pull with nearly its weight."""
    if load.in_water is None or not recording.column("displaced_volume", load.in_water)[sample] > 0.0:
        return False
    pulls = [
        float(series.sling_tension(recording, sling)[sample])
        for sling in _pulling(recording, sample)
        for lug_of in sling.lugs_of
        if lug_of == load.name
    ]
    pulls += [float(recording.column("rope_tension", rope)[sample]) for rope in load.other_ropes]
    return sum(pulls) < (1.0 - _BORNE) * float(series.load_weight(recording, load)[sample])


def _at(recording: Recording, sample: int) -> Iterator[TopHeavy]:
    """Of all that hangs together at a sample."""
    bodies: list[Load | Spreader] = [*recording.rig.loads, *recording.rig.spreaders]
    for load in recording.rig.loads:
        if _is_left_to_statics(recording, load, sample) or _is_borne_by_water(recording, load, sample):
            return
    slings = _pulling(recording, sample)
    stiffness = _stiffness(recording, sample, bodies, slings)
    if not np.isfinite(stiffness).all():
        return
    if any(is_shut(recording, hinge)[sample] for hinge in recording.rig.hinges):
        return  # it keeps its load from turning over, but for its axis, about which slings hold it
    for number, body in enumerate(bodies):
        own = [6 * number + 3, 6 * number + 4]
        rest = [place for place in range(len(stiffness)) if place not in own]
        inner = stiffness[np.ix_(rest, rest)]
        across = stiffness[np.ix_(rest, own)]
        tilting = stiffness[np.ix_(own, own)] - across.T @ np.linalg.lstsq(inner, across, rcond=None)[0]
        height = float(np.linalg.eigvalsh((tilting + tilting.T) / 2)[0]) / _weight_on(recording, body)
        if height < -_TOO_HIGH:
            yield TopHeavy(body.name, float(recording.time[sample]), -height)


def _weight_on(recording: Recording, body: Load | Spreader) -> float:
    """What it bears: of a spreader all loads, roughly [N]."""
    return body.weight if isinstance(body, Load) else sum(load.weight for load in recording.rig.loads)


def _pulling(recording: Recording, sample: int) -> list[Sling]:
    """Slings that pull."""
    rig = recording.rig
    on: BoolArray = while_there(recording, [one.rope for one in rig.slings], [DETACHED])[:, sample]
    return [
        one
        for one, is_on in zip(rig.slings, on, strict=True)
        if is_on and series.sling_tension(recording, one)[sample] > 0.0
    ]


def _route(recording: Recording, sling: Sling, sample: int) -> list[tuple[str | None, FloatArray]]:
    """What a sling pulls, and where [m], from end to end: it runs straight between them."""
    first, last = (end[sample] for end in series.rope_ends(recording, sling.rope))
    ends = (last,) if sling.over is None else (first, last)
    lower = [
        (of if of is not None else _extension_at(recording, end, sample), end)
        for of, end in zip(sling.lugs_of, ends, strict=True)
    ]
    if sling.over is None:
        return [(sling.from_body, first), *lower]
    return [lower[0], (sling.over, recording.column("body_position", sling.over)[sample]), lower[1]]


def _extension_at(recording: Recording, point: FloatArray, sample: int) -> str | None:
    """The extension sheave that hangs where a sling ends: which one that is, recordings do not say."""
    return min(
        _extensions(recording),
        key=lambda name: float(np.linalg.norm(recording.column("body_position", name)[sample] - point)),
        default=None,
    )


def _extensions(recording: Recording) -> list[str]:
    """Names of extension sheaves."""
    return [one.over for one in recording.rig.slings if one.over is not None]


def _stiffness(
    recording: Recording, sample: int, bodies: Sequence[Load | Spreader], slings: Sequence[Sling]
) -> FloatArray:
    """Over places and turns of all bodies, then of extension sheaves (6 each), turns about plumb held."""
    names = [*(body.name for body in bodies), *_extensions(recording)]
    numbers = {name: number for number, name in enumerate(names)}
    own_names = [*(body.body for body in bodies), *_extensions(recording)]
    centres = [recording.column("body_position", name)[sample] for name in own_names]
    total = np.zeros((6 * len(names), 6 * len(names)))
    together: dict[str, list[tuple[FloatArray, float]]] = {}
    for sling in slings:
        tension = float(series.sling_tension(recording, sling)[sample])
        shortens = np.zeros(len(total))
        for upper, lower in pairwise(_route(recording, sling, sample)):
            length = float(np.linalg.norm(upper[1] - lower[1]))
            up = (upper[1] - lower[1]) / length
            moves = np.zeros((3, len(total)))
            for (name, at), sign in ((lower, 1.0), (upper, -1.0)):
                if name in numbers:
                    own = slice(6 * numbers[name], 6 * numbers[name] + 6)
                    lever = at - centres[numbers[name]]
                    moves[:, own] += sign * np.hstack([np.eye(3), _cross(lever).T])
                    slope = -sign * tension * up
                    turns = slice(own.start + 3, own.stop)
                    both = np.outer(slope, lever)
                    total[turns, turns] += 0.5 * (both + both.T) - float(slope @ lever) * np.eye(3)
            total += tension / length * moves.T @ (np.eye(3) - np.outer(up, up)) @ moves
            shortens += moves.T @ up
        length = float(sling_lengths(recording, sling)[sample])
        group, stiff = _shares(recording, sling, sample), _along(recording, sling, tension, length)
        together.setdefault(group, []).append((shortens, stiff))
    for shared in together.values():
        way = np.sum([one for one, _ in shared], axis=0)
        total += min(stiff for _, stiff in shared) * np.outer(way, way)
    for number, body in enumerate(bodies):
        total[6 * number + 5, 6 * number + 5] += _weight_on(recording, body)
    return total


def _shares(recording: Recording, sling: Sling, sample: int) -> str:
    """The equalizer whose moving sheaves let a sling share with others, or its own name."""
    equalizer = recording.rig.equalizer_of(sling)
    if equalizer is None:
        return sling.rope
    pinned = pinned_sheaves(recording, equalizer, float(recording.time[sample]))
    return sling.rope if pinned else equalizer.name


def _along(recording: Recording, sling: Sling, tension: float, length: float) -> float:
    """EA/L of a sling of a length [m], of one with a curve its slope at a tension [N]; [N/m]."""
    rope = recording.rig.rope(sling.rope)
    strain = None if rope is None else rope.strain(tension)
    if strain is None or not length:
        return _STIFF
    return 1.0 / (strain[1] * length)


def _cross(at: FloatArray) -> FloatArray:
    """The matrix of a cross product from the left (3, 3)."""
    x, y, z = at
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
