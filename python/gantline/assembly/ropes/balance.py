"""Where points and bodies that hang on elastic lines are at rest: least energy, by Newton's method.

Energy is weight times height and what stretched lines hold; slack lines hold none. Let f be the slope of the
energy over the place of a point at s from the origin of its body, world axes. A small turn t moves that point
by t x s + t x (t x s)/2: s x f is the slope over t, and (f s' + s f')/2 - (f . s) 1 adds to its curvature.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gantline.assembly.spatial import Array, rotation_matrix, rotation_vector
from gantline.scenario.gear import RopeMaterial

__all__ = ["Hung", "Line", "Pose", "balance"]

#: Rounds of Newton's method; a few are enough where there is a place at rest.
_ROUNDS = 500
#: What may be missing from balance, of the lightest weight.
_BALANCED = 1e-9
#: And where no step betters that, of what rounding of places makes.
_ROUNDED = 4.0
#: Where steps have to be damped more than this, there is no better place nearby [N/m].
_STIFFEST = 1e20
#: A point this close to another end of its line has nowhere to hang [m].
_CLOSEST = 1e-3
#: The largest turn of one step [rad].
_TURN = 0.5


@dataclass(frozen=True)
class Hung:
    """A point or body that hangs on lines.

    Attributes:
        weight: [N].
        centre: of gravity, in its frame (3,) [m].
        turns: whether it turns; a point does not.
    """

    weight: float
    centre: Array
    turns: bool


@dataclass(frozen=True)
class Line:
    """An elastic line through points, each on a hung body by its number, in its frame, or in the world."""

    points: tuple[tuple[int | None, Array], ...]
    length: float
    kind: RopeMaterial

    def pull(self, stretch: float) -> tuple[float, float, float]:
        """Tension [N], its slope over the stretch [N/m] and energy [J] at a stretch of 0 or more [m]."""
        tension, slope, energy = self.kind.pull(stretch / self.length)
        return tension, slope / self.length, energy * self.length


@dataclass(frozen=True)
class Pose:
    """Places (bodies, 3) [m] and rotation matrices (bodies, 3, 3)."""

    places: Array
    turns: Array

    def point(self, body: int | None, at: Array) -> Array:
        """Where a point is in the world (3,) [m]."""
        return at if body is None else self.places[body] + self.turns[body] @ at

    def moved(self, step: Array) -> Pose:
        """After a step (bodies, 6): each place along, each body turned about its origin [m, rad]."""
        turned = [
            rotation_matrix(rotation_vector([float(part) for part in turn])) @ own
            for turn, own in zip(step[:, 3:], self.turns, strict=True)
        ]
        return Pose(self.places + step[:, :3], np.array(turned))


def balance(hung: Sequence[Hung], lines: Sequence[Line], start: Pose) -> Pose | None:
    """Where all hang at rest; None if nowhere.

    Of points alone the energy is convex in their places, as stretched lengths are, and only what is stretched
    holds any: there is one least value, and no other place at rest. Bodies that turn come to rest near their
    start.
    """
    pose, damping = start, 1.0
    free = np.array([place < 3 or one.turns for one in hung for place in range(6)])
    lightest = min(one.weight for one in hung)
    energy, slope, curve = _energy(hung, lines, pose)
    for _ in range(_ROUNDS):
        if damping > _STIFFEST:
            break
        left = slope[free]
        if np.abs(left).max() <= _BALANCED * lightest:
            return pose
        own = curve[np.ix_(free, free)]
        # Downhill also where the energy curves downwards, as of a body above what it hangs on.
        shift = damping + max(0.0, -2.0 * float(np.linalg.eigvalsh(own)[0]))
        step = np.zeros(len(slope))
        step[free] = np.linalg.solve(own + shift * np.eye(len(left)), -left)
        moved = pose.moved(step.reshape(-1, 6))
        if _too_close(lines, moved) or np.abs(step.reshape(-1, 6)[:, 3:]).max() > _TURN:
            damping *= 10.0
            continue
        trial = _energy(hung, lines, moved)
        # Near the end the energy no longer tells; the slope does.
        if trial[0] < energy or np.abs(trial[1][free]).max() < np.abs(left).max():
            pose, (energy, slope, curve), damping = moved, trial, damping / 10.0
        else:
            damping *= 10.0
    is_rounding = np.abs(slope[free]).max() <= _ROUNDED * _rounding(lines, pose)
    return pose if is_rounding else None


def _rounding(lines: Sequence[Line], pose: Pose) -> float:
    """What rounding of places makes of the slope of the energy, more in stiff lines far away [N, N m]."""
    places = [np.array([pose.point(*one) for one in line.points]) for line in lines]
    arms = [float(np.linalg.norm(at)) for line in lines for body, at in line.points if body is not None]
    pulls = (line.pull(0.0)[1] * float(np.abs(one).max()) for line, one in zip(lines, places, strict=True))
    return float(np.finfo(float).eps) * sum(pulls) * max([1.0, *arms])


def _too_close(lines: Sequence[Line], pose: Pose) -> bool:
    return any(np.linalg.norm(way) < _CLOSEST for line in lines for way in _ways(line, pose))


def _ways(line: Line, pose: Pose) -> Array:
    """From each point of a line to the next (parts, 3) [m]."""
    return np.diff(np.array([pose.point(*one) for one in line.points]), axis=0)


def _energy(hung: Sequence[Hung], lines: Sequence[Line], pose: Pose) -> tuple[float, Array, Array]:
    """Energy [J], its slope and its curvature over places [m] and turns [rad] of all bodies."""
    slope, curve = np.zeros(6 * len(hung)), np.zeros((6 * len(hung), 6 * len(hung)))
    energy = 0.0
    for number, one in enumerate(hung):
        up = np.array([0.0, 0.0, one.weight])
        energy += float(up @ pose.point(number, one.centre))
        _add_force(slope, curve, number, pose.turns[number] @ one.centre, up)
    for line in lines:
        ways = _ways(line, pose)
        sizes = np.linalg.norm(ways, axis=1)
        stretch = float(sizes.sum()) - line.length
        if stretch <= 0:
            continue
        tension, stiffness, stored = line.pull(stretch)
        energy += stored
        longer = np.zeros(len(slope))
        for part, (way, size) in enumerate(zip(ways, sizes, strict=True)):
            along = way / size
            turning = tension * (np.eye(3) - np.outer(along, along)) / size
            ends = [
                (body, sign, pose.turns[body] @ at)
                for (body, at), sign in ((line.points[part], -1.0), (line.points[part + 1], 1.0))
                if body is not None
            ]
            for body, sign, arm in ends:
                moves = _moves(arm)
                longer[_own(body)] += sign * (along @ moves)
                _add_force(slope, curve, body, arm, sign * tension * along)
                for other, other_sign, other_arm in ends:
                    curve[_own(body), _own(other)] += (
                        sign * other_sign * (moves.T @ turning @ _moves(other_arm))
                    )
        curve += stiffness * np.outer(longer, longer)
    return energy, slope, curve


def _own(body: int) -> slice:
    return slice(6 * body, 6 * body + 6)


def _moves(arm: Array) -> Array:
    """How a point at an arm from a body's origin moves with its place and turn (3, 6)."""
    x, y, z = arm
    return np.hstack([np.eye(3), [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]])


def _add_force(slope: Array, curve: Array, body: int, arm: Array, gradient: Array) -> None:
    """Add to slope and curvature of a body what an energy with this gradient at one of its points does."""
    slope[_own(body)] += gradient @ _moves(arm)
    both = np.outer(gradient, arm)
    turn = slice(6 * body + 3, 6 * body + 6)
    curve[turn, turn] += 0.5 * (both + both.T) - float(gradient @ arm) * np.eye(3)
