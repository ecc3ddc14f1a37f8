"""Skew load factors: what errors of length, and losses of sheaves, add to the static force of a sling.

The skew load factor of a sling is its static force over the force that it would have with perfect lengths.
Both are taken where the load hangs; slings that share are taken together:

- under an equalizer whose sheaves move, perfect means that every moving sheave bears the same force along
  its guide, which is plumb unless the frame tilts. An ideal one has 1 whatever the lengths, one with losses
  has what they leave uneven, one whose lengths are adjusted instead what that has left;
- under a hook the forces keep their sum on the hook, in three directions. Three slings have no choice. More
  share as their stiffnesses EA/L say, which is the least elastic energy;
- under an equalizer of which pins hold a sheave, slings count as parallel: what they keep is the sum of
  vertical forces and its moments about the horizontal axes;
- above and below spreaders all slings that these join count together, and keep forces and moments on each
  spreader and on the load. Spreaders are rigid. Below one that an equalizer holds, slings have a factor only
  where lengths decide nothing.

Of slings beside which ropes of `mechanics` carry the load in the same hook nothing is told.

A sling over an extension sheave shares with none: it follows the sling that its sheave hangs on, and has no
factor of its own. How slings share that carry such sheaves, where lengths decide it, depends on all that
hangs below and cannot be told.

Slings with a curve of tension over strain share such that their stretches fit, which is the least of
Σ L ∫ s dT, found in steps of their slopes.

With s = K^(-1/2) T and A = G K^(1/2), G the forces (and moments) of unit tensions, perfect lengths give
s = A+ A s. `docs/concepts/checks.md` derives it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from gantline.results import series
from gantline.results.cranes.chain_hoists import sling_lengths
from gantline.results.gear import Rope, Sling
from gantline.results.recording import Recording
from gantline.results.ropes.pinned import pinned_sheaves
from gantline.results.rotation import axes
from gantline.results.variable import BoolArray, FloatArray

#: Levers, and directions, below this share of the largest are none: lugs in one line, ropes in one plane.
_NO_LEVER = 1e-3
#: A sling that would carry less than this share of the largest has no factor.
_SLACK = 1e-3
#: Steps of the search for forces of slings with a curve, halvings of each, and the share of the largest force
#: below which a step is none.
_ROUNDS, _HALVES, _SETTLED = 100, 30, 1e-9


@dataclass(frozen=True)
class Skew:
    """A sling and its skew load factor.

    Attributes:
        sling: Its name.
        force: Its static force [N].
        perfect: The same with perfect lengths [N]; None if that cannot be told.
        lengths_decide: Whether lengths decide how it shares with others.
        reason: Why it cannot be told.
    """

    sling: str
    force: float
    perfect: float | None
    lengths_decide: bool
    reason: str = ""

    @property
    def most(self) -> float:
        """The larger of both forces [N]."""
        return max(self.force, self.perfect or 0.0)

    @property
    def factor(self) -> float | None:
        """The skew load factor [1]; None if it cannot be told."""
        return None if self.perfect is None else self.force / self.perfect


def skew_loads(recording: Recording, window: BoolArray | None = None) -> list[Skew]:
    """Skew of every sling, in groups of those that share; none where there is no static force.

    Of several times that the loads hung still that one counts at which a sling bears most, be it as it is or
    with perfect lengths.

    Args:
        recording: Of any lift.
        window: The time that counts instead, shape (time,).
    """
    found: dict[str, Skew] = {}
    windows = series.quiet_windows(recording) if window is None else [window]
    for one in reversed(windows):
        for skew in recording.kept(("skew", one.tobytes()), partial(_at, recording, one)):
            later = found.get(skew.sling)
            if later is None or series.is_more(skew.most, later.most):
                found[skew.sling] = skew
    return list(found.values())


def _at(recording: Recording, window: BoolArray) -> list[Skew]:
    """Skew of every sling that hung together over one quiet window."""
    ropes = [sling.rope for sling in recording.rig.slings]
    there = series.are_whole(recording, ropes)[:, window][:, -1]
    slings = [sling for sling, is_there in zip(recording.rig.slings, there, strict=True) if is_there]
    sharing = [sling for sling in slings if sling.over is None]
    skews = [skew for group in _groups(recording, sharing) for skew in _of_group(recording, window, group)]
    over = [sling for sling in slings if sling.over is not None]
    tension = np.array([_static(recording, window, series.sling_tension(recording, one)) for one in over])
    # Lengths decide for it what they decide for the sling above; which one that is, recordings do not say.
    decide = any(skew.lengths_decide for skew in skews)
    reason = "it follows the sling that its extension sheave hangs on"
    return [*skews, *_none(over, tension, reason, lengths_decide=decide)]


def largest_skew(recording: Recording) -> float | None:
    """Largest skew load factor of a lift [1]; None if there is none."""
    factors = [one.factor for one in skew_loads(recording)]
    return max((factor for factor in factors if factor is not None), default=None)


def _groups(recording: Recording, slings: Sequence[Sling]) -> list[list[Sling]]:
    """Slings of one equalizer, or of one hook without any, or of all that spreaders join."""
    groups: list[tuple[set[str], list[Sling]]] = []
    for sling in slings:
        equalizer = recording.rig.equalizer_of(sling)
        names = {equalizer.name} if equalizer else {sling.from_body, *_spreaders_at(recording, sling)}
        found = [place for place, (own, _) in enumerate(groups) if own & names]
        joined = [groups[place] for place in found]
        for place in reversed(found):
            del groups[place]
        merged = names.union(*(own for own, _ in joined)), [*(one for _, of in joined for one in of), sling]
        groups.insert(found[0] if found else len(groups), merged)
    return [own for _, own in groups]


def _spreaders_at(recording: Recording, sling: Sling) -> set[str]:
    """Spreaders at either end of a sling."""
    spreaders = {one.name for one in recording.rig.spreaders}
    return {of for _, of, _ in sling.at_lugs() if of in spreaders}


def _of_group(recording: Recording, window: BoolArray, slings: Sequence[Sling]) -> Iterator[Skew]:
    equalizer = recording.rig.equalizer_of(slings[0])
    tension = np.array([_static(recording, window, series.sling_tension(recording, one)) for one in slings])
    directions = [series.sling_direction(recording, one) for one in slings]
    unit = np.array([[_static(recording, window, part) for part in one.T] for one in directions])
    if (unit[:, 2] <= _NO_LEVER).any() or tension.max(initial=0.0) <= 0.0:
        yield from _none(slings, tension, "its slings do not hang")
        return
    end = float(recording.time[window][-1])
    if equalizer is not None and not pinned_sheaves(recording, equalizer, end):
        guide = axes(recording.column("body_orientation", equalizer.body))[:, :, 2]
        along = unit @ [_static(recording, window, part) for part in guide.T]
        perfect = np.mean(tension * along) / along
        yield from _all(slings, tension, perfect, lengths_decide=False)
        return
    joined = (
        set[str]()
        if equalizer is not None
        else set().union(*(_spreaders_at(recording, one) for one in slings))
    )
    if others := _share_with(recording, window, slings, float(tension.max())):
        yield from _none(slings, tension, f"ropes of 'mechanics' in their hook share with them: {others}")
        return
    if joined:
        gradient = _wrenches(recording, window, slings, unit)
    elif equalizer is None:
        gradient = unit.T
    else:
        ends = [series.rope_ends(recording, one.rope)[1] for one in slings]
        lugs = np.array([[_static(recording, window, part) for part in one[:, :2].T] for one in ends])
        lever = lugs - lugs.mean(axis=0)
        size = np.sqrt(np.mean(lever**2)) or 1.0
        gradient = np.vstack([np.ones(len(slings)), lever.T / size]) * unit[:, 2]
    if np.linalg.matrix_rank(gradient, tol=_NO_LEVER * np.linalg.norm(gradient, 2)) == len(slings):
        yield from _all(slings, tension, tension, lengths_decide=False)
        return
    if any(lug is None for one in slings for lug in one.lugs):
        yield from _none(slings, tension, "how they share depends on extension sheaves below them")
        return
    if _hang_by_equalizers(recording, joined):
        yield from _none(slings, tension, "how they share depends on the equalizer that holds their spreader")
        return
    ropes = _ropes(recording, slings)
    if ropes is None:
        yield from _none(slings, tension, "axial stiffness of its slings not known")
        return
    lengths = np.array([_static(recording, window, sling_lengths(recording, one)) for one in slings])
    perfect = perfect_forces_of(ropes, lengths, gradient, tension)
    yield from _all(slings, tension, perfect, lengths_decide=True)


def _share_with(recording: Recording, window: BoolArray, slings: Sequence[Sling], most: float) -> str:
    """Ropes of `mechanics` that carry a load beside slings of a hook, by name; empty where there are none.

    Which of the ropes hang in which hook is not recorded: all count where a hook of the slings bears some.

    Args:
        recording: Of any lift.
        window: The time that counts, shape (time,).
        slings: Those that share.
        most: Largest static force of theirs [N].
    """
    hooks = {recording.rig.hook_of(one) for one in slings}
    if not any(hook.bears_mechanics for hook in recording.rig.hooks if hook.name in hooks):
        return ""
    ropes = dict.fromkeys(rope for load in recording.rig.loads for rope in load.other_ropes)
    carry = [
        rope
        for rope in ropes
        if _static(recording, window, recording.column("rope_tension", rope)) > _SLACK * most
    ]
    return ", ".join(carry)


def _wrenches(
    recording: Recording, window: BoolArray, slings: Sequence[Sling], unit: FloatArray
) -> FloatArray:
    """Forces and moments of unit tensions on each spreader and load, shape (6 bodies, slings).

    Args:
        recording: Of any lift.
        window: The time that counts, shape (time,).
        slings: Those that spreaders join.
        unit: Their directions upwards, shape (slings, 3).
    """
    pulls: dict[str, list[tuple[int, FloatArray, FloatArray]]] = {}
    for place, sling in enumerate(slings):
        upper, lower = (_place(recording, window, end) for end in series.rope_ends(recording, sling.rope))
        if sling.from_lug is not None:
            pulls.setdefault(sling.from_body, []).append((place, upper, -unit[place]))
        for of in sling.lugs_of:
            if of is not None:
                pulls.setdefault(of, []).append((place, lower, unit[place]))
    rows = []
    for own in pulls.values():
        middle = np.mean([at for _, at, _ in own], axis=0)
        size = max(float(np.linalg.norm(at - middle)) for _, at, _ in own) or 1.0
        wrench = np.zeros((6, len(slings)))
        for place, at, pull in own:
            wrench[:3, place] += pull
            wrench[3:, place] += np.cross(at - middle, pull) / size
        rows.append(wrench)
    return np.vstack(rows)


def _place(recording: Recording, window: BoolArray, points: FloatArray) -> FloatArray:
    return np.array([_static(recording, window, part) for part in points.T])


def _hang_by_equalizers(recording: Recording, spreaders: set[str]) -> bool:
    """Whether a sling of an equalizer leads to one of these."""
    slings = (one for one in recording.rig.slings if recording.rig.equalizer_of(one) is not None)
    return any(_spreaders_at(recording, one) & spreaders for one in slings)


def perfect_forces(gradient: FloatArray, stiffness: FloatArray, tension: FloatArray) -> FloatArray:
    """Forces of slings of perfect lengths that do to the load what the given ones do.

    Args:
        gradient: What unit tensions do to the load, shape (n, slings).
        stiffness: EA/L, shape (slings,) [N/m].
        tension: Forces as they are, shape (slings,) [N].

    Returns:
        The forces of least elastic energy that gradient @ tension allows, shape (slings,) [N].
    """
    root = np.sqrt(stiffness)
    forces = gradient * root
    perfect: FloatArray = root * (np.linalg.pinv(forces, rcond=_NO_LEVER) @ forces @ (tension / root))
    return perfect


def perfect_forces_of(
    ropes: Sequence[Rope], lengths: FloatArray, gradient: FloatArray, tension: FloatArray
) -> FloatArray:
    """The same of slings whose stiffness may change with their tension, as their ropes have it.

    Args:
        ropes: Rope of each sling, that stretches.
        lengths: Their lengths, shape (slings,) [m].
        gradient: What unit tensions do to the load, shape (n, slings).
        tension: Forces as they are, shape (slings,) [N].

    Returns:
        The forces whose stretches fit lugs that move as one, and that gradient @ tension allows, shape
        (slings,) [N].
    """
    stiffness = np.array([one.axial_stiffness for one in ropes]) / lengths
    perfect = perfect_forces(gradient, stiffness, tension)
    if not any(one.curve for one in ropes):
        return perfect
    free = _unfelt(gradient)

    def stretched(forces: FloatArray) -> tuple[FloatArray, FloatArray]:
        """What is left of stretches that do not fit [m], and how much softer each sling is there [m/N]."""
        strains = np.array([rope.strain(force) for rope, force in zip(ropes, forces, strict=True)])
        return free.T @ (lengths * strains[:, 0]), lengths * strains[:, 1]

    misfit, soft = stretched(perfect)
    for _ in range(_ROUNDS):
        change = -free @ np.linalg.solve((free.T * soft) @ free, misfit)
        share = 1.0
        for _ in range(_HALVES):
            left, soft = stretched(perfect + share * change)
            if np.linalg.norm(left) <= np.linalg.norm(misfit):
                break
            share /= 2
        perfect, misfit = perfect + share * change, left
        if np.abs(share * change).max() <= _SETTLED * np.abs(tension).max():
            break
    return perfect


def _unfelt(gradient: FloatArray) -> FloatArray:
    """Directions of forces that the load does not feel, shape (slings, of them)."""
    _, sizes, ways = np.linalg.svd(gradient)
    felt = int(np.count_nonzero(sizes > _NO_LEVER * sizes[0]))
    unfelt: FloatArray = ways[felt:].T
    return unfelt


def _static(recording: Recording, window: BoolArray, values: FloatArray) -> float:
    found = series.static_value(recording, values, window)
    return 0.0 if found is None else found


def _ropes(recording: Recording, slings: Sequence[Sling]) -> list[Rope] | None:
    """The rope of each sling; None if the stiffness of one is not known."""
    found = []
    for sling in slings:
        rope = recording.rig.rope(sling.rope)
        if rope is None or not rope.axial_stiffness or not sling.length:
            return None
        found.append(rope)
    return found


def _all(
    slings: Sequence[Sling], tension: FloatArray, perfect: FloatArray, *, lengths_decide: bool
) -> Iterator[Skew]:
    least = _SLACK * float(perfect.max())
    for sling, force, of in zip(slings, tension, perfect, strict=True):
        if of > least:
            yield Skew(sling.name, float(force), float(of), lengths_decide)
        else:
            reason = "with perfect lengths it would be slack"
            yield Skew(sling.name, float(force), None, lengths_decide, reason)


def _none(
    slings: Sequence[Sling], tension: FloatArray, reason: str, *, lengths_decide: bool = True
) -> Iterator[Skew]:
    for sling, force in zip(slings, tension, strict=True):
        yield Skew(sling.name, float(force), None, lengths_decide, reason)
