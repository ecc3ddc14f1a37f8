"""Motion of vessels that their wave forces, which follow slow places and headings, do not follow."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import combinations
from typing import Any

import numpy as np

from gantline.hydro.side_by_side import ELSEWHERE
from gantline.results.rotation import axes, heading
from gantline.results.variable import BoolArray, Columns, FloatArray, Names

__all__ = ["parted_neighbours", "unfollowed"]

#: Speed of a vessel over that of the waves, from which its speed counts.
_FAST = 0.1
#: By how much the slow heading may be behind [rad], and the phase of the waves at the slow place.
_BEHIND, _LATE = math.radians(10.0), math.pi / 2
#: Slow places and headings are 10 ü/ω_c² behind, ω_c = 0.2 ω (`CUT_OFF` of the core's `build/trains.rs`): of
#: the second difference over a period 2π/ω.
_BEND = 10.0 / (0.2 * 2 * math.pi) ** 2
#: Directions that are further apart have nothing to say of what is between them [deg].
_WIDEST = 60.0

_Json = Mapping[str, Any]


def unfollowed(document: _Json, columns: Columns, names: Names) -> list[str]:
    """A sentence for each way in which a vessel moves that its wave forces do not follow.

    Looked at are means over a period of the slowest wave; of less than three periods nothing is said.

    Args:
        document: What has been assembled of the lift.
        columns: What was recorded: `time`, `body_position`, `body_orientation`.
        names: Names along their dimensions.
    """
    sentences = []
    for force in (one for one in document.get("forces", ()) if one["type"] == "wave"):
        waves = document["sea"]["components"]
        period = 2 * math.pi / min(wave["frequency"] for wave in waves)
        if columns["time"][-1] - columns["time"][0] < 3 * period:
            continue
        arm = _arm(document, force)
        time, slow = _means(columns, list(names["body"]).index(force["body"]), arm, period)
        for sentence, moments, is_so in (
            *_of_motion(waves, time, slow, period),
            _of_directions(force["directions"], waves, time, slow),
        ):
            if is_so.any():
                since = float(moments[int(np.argmax(is_so))])
                sentences.append(f"wave forces of {force['body']}: from {since:.0f} s on it {sentence}")
    return sentences


def parted_neighbours(
    document: _Json,
    columns: Columns,
    names: Names,
    together: Sequence[Collection[str]],
    hulls: Mapping[str, FloatArray],
) -> list[str]:
    """A sentence for each two vessels that part or close in a run while their waves are those side by side.

    Looked at are means over a period of the slowest wave; of less than three periods nothing is said.

    Args:
        document: What has been assembled of the lift.
        columns: What was recorded: `time`, `body_position`, `body_orientation`.
        names: Names along their dimensions.
        together: Names of the vessels of each file of several.
        hulls: Vertices of the hulls of vessels by their names, vessel axes (vertices, 3) [m].
    """
    forces = {one["body"]: one for one in document.get("forces", ()) if one["type"] == "wave"}
    if not forces or not together:
        return []
    period = 2 * math.pi / min(wave["frequency"] for wave in document["sea"]["components"])
    if columns["time"][-1] - columns["time"][0] < 3 * period:
        return []
    sentences = []
    for one, other in (pair for vessels in together for pair in combinations(sorted(vessels), 2)):
        (time, first), (_, second) = (
            _means(columns, list(names["body"]).index(body), _arm(document, forces[body]), period)
            for body in (one, other)
        )
        between, turned = (second - first)[:, :2], (second - first)[:, 2]
        cos, sin = np.cos(first[:, 2]), np.sin(first[:, 2])
        lies = np.stack(
            [cos * between[:, 0] + sin * between[:, 1], cos * between[:, 1] - sin * between[:, 0]]
        )
        moved, askew = np.hypot(*(lies - lies[:, :1])), np.abs(turned - turned[0])
        narrow = min(float(np.ptp(hulls[name][:, 1])) for name in (one, other))
        is_so = (moved > ELSEWHERE.of_breadth * narrow) | (askew > ELSEWHERE.askew)
        if is_so.any():
            since = float(time[int(np.argmax(is_so))])
            by = f"by up to {moved.max():.1f} m and {math.degrees(askew.max()):.1f} deg"
            sentences.append(
                f"wave forces of {one} and {other}: from {since:.0f} s on they lie elsewhere beside each "
                f"other than at the start, {by}, and feel waves as if they still lay there"
            )
    return sentences


def _arm(document: _Json, force: _Json) -> FloatArray:
    """The point that phases of a wave force count from, from the centre of gravity of its body (3,) [m]."""
    body = next(one for one in document["bodies"] if one["name"] == force["body"])
    arm: FloatArray = np.array(force["origin"]) - np.array(body.get("centre_of_gravity", (0.0, 0.0, 0.0)))
    return arm


def _of_motion(
    waves: Sequence[_Json], time: FloatArray, slow: FloatArray, period: float
) -> Iterator[tuple[str, FloatArray, BoolArray]]:
    """Of speed, turns and ways: the rest of a sentence, moments, and at which of them it is so."""
    energy = np.array([wave["amplitude"] ** 2 for wave in waves])
    energy /= energy.sum()
    size = np.array([math.hypot(*wave["wave_number"]) for wave in waves])
    slowness = float(energy @ (size / [wave["frequency"] for wave in waves]))
    speed = np.hypot(*(slow[2:, :2] - slow[:-2, :2]).T) / period
    yield (
        f"moves at up to {speed.max():.2g} m/s, more than a tenth as fast as they run; they are those of a "
        "vessel without speed",
        time[1:-1],
        speed * slowness > _FAST,
    )
    bend = _BEND * np.abs(slow[4:] - 2 * slow[2:-2] + slow[:-4])
    # What turns or shifts at once is behind by no more than all of that.
    behind = np.minimum(bend, np.ptp(slow, axis=0))
    turn, way = behind[:, 2], np.hypot(behind[:, 0], behind[:, 1])
    degrees = f"{math.degrees(turn.max()):.2g} deg"
    yield f"turns so fast that they feel a heading up to {degrees} behind", time[2:-2], turn > _BEHIND
    late = way * float(energy @ size) > _LATE
    yield f"gathers way so fast that they feel a place up to {way.max():.2g} m behind", time[2:-2], late


def _of_directions(
    directions: Sequence[float], waves: Sequence[_Json], time: FloatArray, slow: FloatArray
) -> tuple[str, FloatArray, BoolArray]:
    """The same of waves from where the file has none."""
    known = np.array(directions)
    gaps = np.diff(known, append=known[0] + math.tau)
    found = np.zeros(len(time), dtype=np.bool_)
    for towards in {math.atan2(wave["wave_number"][1], wave["wave_number"][0]) for wave in waves}:
        turned = (towards - slow[:, 2] - known[0]) % math.tau + known[0]
        found |= gaps[np.searchsorted(known, turned, side="right") - 1] > math.radians(_WIDEST + 1e-3)
    sentence = (
        f"turns to where their file has no waves, in a gap of more than {_WIDEST:.0f} deg; between its two "
        "ends forces are taken as linear"
    )
    return sentence, time, found


def _means(columns: Columns, body: int, arm: FloatArray, period: float) -> tuple[FloatArray, FloatArray]:
    """Moments half a period apart (n,) [s]; x, y [m] and heading [rad] as means over a period (n, 3).

    Args:
        columns: What was recorded.
        body: Place of the body.
        arm: Point of it from its centre of gravity (3,) [m].
        period: [s].
    """
    time, orientation = columns["time"], columns["body_orientation"][:, body]
    place = columns["body_position"][:, body] + axes(orientation) @ arm
    values = np.column_stack([place[:, :2], np.unwrap(heading(orientation))])
    pieces = np.diff(time)[:, None] * (values[1:] + values[:-1]) / 2
    total = np.vstack([np.zeros(3), np.cumsum(pieces, axis=0)])
    moments = np.arange(time[0] + period / 2, time[-1] - period / 2, period / 2)

    def until(when: FloatArray) -> FloatArray:
        return np.column_stack([np.interp(when, time, column) for column in total.T])

    return moments, (until(moments + period / 2) - until(moments - period / 2)) / period
