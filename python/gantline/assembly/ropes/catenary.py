"""A rope that hangs between two points as a chain of nodes with mass: where it is at rest.

The segments between the nodes are elastic and without mass; what a node weighs hangs on it. With F_0 the
force in the first segment, directed along the rope, every other follows: F_j = F_0 + W_j z, W_j the weight of
the nodes before segment j. A segment of unstretched length l_j reaches (1/EA + 1/|F_j|) l_j F_j, so that F_0
is where

    d = sum_j l_j (1/EA + 1/|F_j|) F_j,    d from the first to the last end.

The right side is the gradient of Phi(F_0) = sum_j l_j (|F_j| + |F_j|^2 / (2 EA)), which is strictly convex
and grows faster than any F_0 . d: the complementary energy Phi - F_0 . d has exactly one minimum, for any
place of the ends, slack or taut. Newton's method with halved steps finds it. It may lie where one F_j is
zero; then that segment is slack, all others are plumb, and the slack one reaches whatever is left, which is
at most its length.

As the segments become shorter this is the elastic catenary (Irvine 1981), and the sum is the midpoint rule
for its integrals. That rule errs by (h^2/24) f' at each end (Euler and Maclaurin). Moving a little mass along
the rope shifts the tension at which a segment is taken, and so takes that error away: with f' at the end
carried on from the first two segments, f' = 3/2 f'_1 - 1/2 f'_2, the first is to be taken at 1/16 of a
segment's weight nearer to the end and the second at 1/48 further in.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gantline.assembly.spatial import Array

__all__ = ["HangingRope", "NoRest", "end_mass", "hang", "node_masses"]

#: Shift of the tension at which the first and the second segment are taken, inwards positive [segments].
_END_SHIFTS = (-1 / 16, 1 / 48)

#: Of rope length and distance: a gap that counts as closed.
_ROUNDING = 1e-14
#: The same: more would be no place at rest.
_OPEN = 1e-9
_MOST_STEPS = 200
_SMALLEST_FRACTION = 2.0**-40
#: A step may end where the slope of the energy has changed its sign, at this share of its size at the most.
_OVERSHOOT = 0.1
#: The search along a line ends where its bounds are this close, as a ratio.
_NEAR = 0.9


class NoRest(ArithmeticError):
    """The rope's place at rest was not found."""


@dataclass(frozen=True)
class HangingRope:
    """A rope at rest.

    Attributes:
        points: first end, nodes, last end (segments + 1, 3) [m].
        forces: force in every segment, directed from the first to the last end (segments, 3) [N].
    """

    points: Array
    forces: Array


def node_masses(mass: float, nodes: int) -> Array:
    """Masses of the nodes of a rope (nodes,) [kg]; `mass` is that of the whole rope [kg]."""
    masses: Array = np.diff(_taken_at(nodes)) * mass / (nodes + 1)
    return masses


def end_mass(mass: float, nodes: int) -> float:
    """What each end of a rope with nodes carries of the rope's mass [kg]; `mass` is that of the rope [kg]."""
    return float(_taken_at(nodes)[0]) * mass / (nodes + 1)


def _taken_at(nodes: int) -> Array:
    """What of the rope hangs before where the tension of each segment is taken (nodes + 1,) [segments]."""
    places: Array = np.arange(nodes + 1, dtype=np.float64) + 0.5
    for place, shift in enumerate(_END_SHIFTS):
        places[place] += shift
        places[-1 - place] -= shift
    return places


def hang(first: Array, last: Array, length: float, stiffness: float, weights: Array) -> HangingRope:
    """The rope at rest between two points.

    Args:
        first: one end, z up (3,) [m].
        last: the other end (3,) [m].
        length: unstretched length, in segments of equal length [m].
        stiffness: axial stiffness EA [N].
        weights: what each node weighs, above zero (nodes,) [N].

    Returns:
        Points and forces.

    Raises:
        NoRest: if no place at rest was found to rounding.
    """
    way = last - first
    run = float(np.hypot(way[0], way[1]))
    heading = np.array([way[0] / run, way[1] / run, 0.0]) if run > 0 else np.array([1.0, 0.0, 0.0])
    segments = len(weights) + 1
    flat = _Flat(
        way=np.array([run, way[2]]),
        part=length / segments,
        stiffness=stiffness,
        below=np.concatenate(([0.0], np.cumsum(weights))),
    )
    reaches, forces = flat.solve()
    place = np.concatenate((np.zeros((1, 2)), np.cumsum(reaches, axis=0)))
    if float(np.abs(place[-1] - flat.way).max()) > _OPEN * max(length, float(np.linalg.norm(way))):
        raise NoRest
    points = first + place[:, :1] * heading + place[:, 1:] * np.array([0.0, 0.0, 1.0])
    points[-1] = last
    return HangingRope(points, forces[:, :1] * heading + forces[:, 1:] * np.array([0.0, 0.0, 1.0]))


@dataclass(frozen=True)
class _Flat:
    """The same in the vertical plane of the ends: along, up.

    Attributes:
        way: from the first to the last end (2,) [m].
        part: unstretched length of a segment [m].
        stiffness: axial stiffness EA [N].
        below: W_j, weight of the nodes before each segment (segments,) [N].
    """

    way: Array
    part: float
    stiffness: float
    below: Array

    def solve(self) -> tuple[Array, Array]:
        """What every segment reaches [m] and its force [N], each of shape (segments, 2)."""
        over = self.below[None, :] - self.below[:, None]  # force in each segment, if that of each row is zero
        reach = self.part * (over / self.stiffness + np.sign(over))
        rest = np.stack([np.full(len(self.below), self.way[0]), self.way[1] - reach.sum(axis=1)], axis=1)
        fits = np.flatnonzero(np.linalg.norm(rest, axis=1) <= self.part)
        if fits.size:
            place = int(fits[0])
            reaches = np.stack([np.zeros(len(self.below)), reach[place]], axis=1)
            reaches[place] = rest[place]
            return reaches, np.stack([np.zeros(len(self.below)), over[place]], axis=1)
        forces = self._forces(self._newton(self._start(over, rest)))
        return self._reaches(forces), forces

    def _forces(self, force: Array) -> Array:
        forces: Array = np.stack([np.full(len(self.below), force[0]), force[1] + self.below], axis=1)
        return forces

    def _reaches(self, forces: Array) -> Array:
        size = np.linalg.norm(forces, axis=1, keepdims=True)
        reaches: Array = self.part * (1 / self.stiffness + 1 / size) * forces
        return reaches

    def _start(self, over: Array, rest: Array) -> Array:
        """A force of less energy than any at which a segment is slack, where the energy has an edge.

        From there a way that only goes down meets no edge. Of the edges the lowest is left along what its
        slack segment cannot reach, the steepest way down, as far as it leads down; `over` and `rest` are the
        forces [N] at each edge and what it leaves to its slack segment [m].
        """
        energies = self.part * (np.abs(over) + over**2 / (2 * self.stiffness)).sum(axis=1)
        lowest = int(np.argmin(energies + self.below * self.way[1]))
        edge = np.array([0.0, -self.below[lowest]])
        down = rest[lowest] / np.linalg.norm(rest[lowest])
        near, far = 0.0, max(float(self.below[-1]), 1.0)
        while float(self._gap(edge + far * down) @ down) < 0:
            near, far = far, 2 * far
        while near < (middle := (near + far) / 2) < far and near < _NEAR * far:
            near, far = (middle, far) if float(self._gap(edge + middle * down) @ down) < 0 else (near, middle)
        start: Array = edge + (near if near > 0 else far) * down
        return start

    def _gap(self, force: Array) -> Array:
        """How far the last segment ends beyond the last end [m]."""
        gap: Array = self._reaches(self._forces(force)).sum(axis=0) - self.way
        return gap

    def _newton(self, force: Array) -> Array:
        """The force that closes the gap.

        On the way the energy falls: along every step its slope, gap . step, stays below zero, or ends so
        close to it that the step passed the lowest place by little.
        """
        closed = _ROUNDING * (self.part * len(self.below) + float(np.linalg.norm(self.way)))
        gap = self._gap(force)
        for _ in range(_MOST_STEPS):
            if float(np.linalg.norm(gap)) <= closed:
                break
            step = -np.linalg.solve(self._softness(force), gap)
            slope = float(gap @ step)
            fraction = 1.0
            while fraction > _SMALLEST_FRACTION:
                after = self._gap(force + fraction * step)
                if float(after @ step) <= -_OVERSHOOT * slope:
                    break
                fraction /= 2
            else:
                break  # as exact as rounding allows
            force, gap = force + fraction * step, after
        return force

    def _softness(self, force: Array) -> Array:
        """Derivative of the gap by the force (2, 2) [m/N], symmetric and positive definite."""
        forces = self._forces(force)
        size = np.linalg.norm(forces, axis=1)
        along = forces / size[:, None]
        softness: Array = self.part * np.sum(1 / self.stiffness + 1 / size) * np.eye(2)
        softness -= self.part * (along.T / size) @ along
        return softness
