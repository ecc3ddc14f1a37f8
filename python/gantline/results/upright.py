"""Whether loads and spreaders hang stably where they hang still.

A run of perfect symmetry stays where any push would end it: nothing pushes but rounding. So the stiffness
of what hangs is taken from where it hangs. With u the way up along a sling, T its tension, l its length,
k = EA/L, and J how the distance of its ends follows places and turns of bodies about their centres of
gravity, it gives

    k J^T u u^T J + T/l J^T (1 - u u^T) J,  and at a lever r  -(f r^T + r f^T)/2 + (f.r) 1

over the turns of a body that it pulls with f: (SP2) of docs/concepts/spreader.md. Weight acts at centres of
gravity and gives nothing. Slings of an equalizer whose sheaves move keep but the sum of their lengths.
Turning about plumb, which nothing may hold, is held here, as hooks and frames of equalizers are: all of that
makes what hangs stiffer than it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gantline.results import series
from gantline.results.gear import Sling, Spreader
from gantline.results.parting import DETACHED, while_there
from gantline.results.pinned import pinned_sheaves
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["TopHeavy", "top_heavy"]

#: Of slings of which it is not known: stiffer than steel of these lengths [N/m].
_STIFF = 1e9
#: Height by which what hangs may be too high before it is told [m]: nobody knows a centre of gravity so well.
_TOO_HIGH = 0.005
#: Share of its weight that other ropes may bear of a load before nothing is said of it [1].
_BORNE = 0.05


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


def _at(recording: Recording, sample: int) -> Iterator[TopHeavy]:
    """Of all that hangs together at a sample."""
    bodies: list[Load | Spreader] = [*recording.rig.loads, *recording.rig.spreaders]
    slings = _pulling(recording, sample)
    if slings is None:
        return
    stiffness = _stiffness(recording, sample, bodies, slings)
    if not np.isfinite(stiffness).all():
        return
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


def _pulling(recording: Recording, sample: int) -> list[Sling] | None:
    """Slings that pull; None where others than slings from end to end hold a load."""
    rig = recording.rig
    for load in rig.loads:
        others = (float(recording.column("rope_tension", rope)[sample]) for rope in load.other_ropes)
        if sum(others) > _BORNE * load.weight:
            return None
    on: BoolArray = while_there(recording, [one.rope for one in rig.slings], [DETACHED])[:, sample]
    slings = [
        one
        for one, is_on in zip(rig.slings, on, strict=True)
        if is_on and series.sling_tension(recording, one)[sample] > 0.0
    ]
    is_plain = all(
        one.over is None and len(one.lugs_of) == 1 and one.lugs_of[0] is not None for one in slings
    )
    return slings if is_plain else None


def _stiffness(
    recording: Recording, sample: int, bodies: Sequence[Load | Spreader], slings: Sequence[Sling]
) -> FloatArray:
    """Over places and turns of all bodies (6 bodies, 6 bodies), turns about plumb held."""
    numbers = {body.name: number for number, body in enumerate(bodies)}
    centres = [recording.column("body_position", body.body)[sample] for body in bodies]
    total = np.zeros((6 * len(bodies), 6 * len(bodies)))
    together: dict[str, list[tuple[FloatArray, float]]] = {}
    for sling in slings:
        upper, lower = (end[sample] for end in series.rope_ends(recording, sling.rope))
        tension = float(series.sling_tension(recording, sling)[sample])
        length = float(np.linalg.norm(upper - lower))
        up = (upper - lower) / length
        moves = np.zeros((3, len(total)))
        for name, at, sign in ((sling.lugs_of[0], lower, 1.0), (sling.from_body, upper, -1.0)):
            if name in numbers:
                own = slice(6 * numbers[name], 6 * numbers[name] + 6)
                lever = at - centres[numbers[name]]
                moves[:, own] += sign * np.hstack([np.eye(3), _cross(lever).T])
                slope = -sign * tension * up
                turns = slice(own.start + 3, own.stop)
                both = np.outer(slope, lever)
                total[turns, turns] += 0.5 * (both + both.T) - float(slope @ lever) * np.eye(3)
        total += tension / length * moves.T @ (np.eye(3) - np.outer(up, up)) @ moves
        group, stiff = _shares(recording, sling, sample), _along(recording, sling)
        together.setdefault(group, []).append((moves.T @ up, stiff))
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


def _along(recording: Recording, sling: Sling) -> float:
    """EA/L of a sling [N/m]."""
    rope = recording.rig.rope(sling.rope)
    if rope is None or not rope.axial_stiffness or not sling.length:
        return _STIFF
    return rope.axial_stiffness / sling.length


def _cross(at: FloatArray) -> FloatArray:
    """The matrix of a cross product from the left (3, 3)."""
    x, y, z = at
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
