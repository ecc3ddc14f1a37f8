"""What each drive does as cranes lead a load: a Chebyshev series over the share of the way, to rounding.

The core knows no crane. Inverse kinematics is analytic along a way, so that its Chebyshev series converges
faster than any power of the number of terms (Trefethen, Approximation Theory and Approximation Practice,
chapter 8).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.polynomial import chebyshev

from gantline.scenario import Scenario
from gantline.scenario.plan.lead import LeadStep
from gantline.scenario.plan.leading import LedHook, Pose, Way, led_hooks, pose_before, way_of
from gantline.scenario.plan.movers import Mover
from gantline.scenario.plan.positions import Places

__all__ = ["Leading", "leading"]

#: Terms to begin with, and the most: a way that needs more goes by where a crane has to slew at once.
_FIRST, _MOST = 32, 1024
#: What the last quarter of the terms may be [m, rad]: rounding of the places of hooks a hundred metres away.
_ROUNDING = 1e-13
#: The same where rounding is coarser, as far from the origin; no series follows what leaves more [m, rad].
_COARSE = 1e-9


@dataclass(frozen=True)
class Leading:
    """A way as drives go it.

    Attributes:
        rate: highest rate of the share of the way [1/s].
        acceleration: its acceleration [1/s^2].
        movers: what moves.
        series: of each the coefficients of what its drive does [m, rad].
    """

    rate: float
    acceleration: float
    movers: Sequence[Mover]
    series: Sequence[list[float]]


def leading(scenario: Scenario, place: int, before: Places) -> Leading:
    """The drives of a step that leads.

    Args:
        scenario: The lift.
        place: of the step in the plan; it has been checked.
        before: Where cranes are before it.

    Raises:
        ScenarioError: where a hook comes so near to the edge of its crane's reach that no series follows.
    """
    step = scenario.plan[place]
    assert isinstance(step, LeadStep)
    hooks = led_hooks(scenario, step)
    way = way_of(step, hooks, before)
    movers, series = [], []
    for index, led in enumerate(hooks):
        movers += led.movers
        found, missed = _series(partial(_drives, way, index, led, before))
        if missed > _COARSE:
            edge = "its boom square to the way of its tracks" if led.travels else "its boom flat"
            sentence = f"'{led.name}' would come to the very edge of what '{led.crane}' reaches, {edge}"
            right = "its drives would have to move all at once there; a way that keeps off that is right"
            raise scenario.error(("plan", place, "turn" if step.turn else "by"), f"{sentence}: {right}")
        series += found
    return Leading(step.speed / way.length, step.acceleration / way.length, movers, series)


def _drives(way: Way, index: int, led: LedHook, before: Places, shares: Sequence[float]) -> np.ndarray:
    """How far each drive of a crane has gone at rising shares of the way, shape (shares, 3) [m, rad]."""
    begin = pose_before(led, before)
    poses = list(way.poses(index, led, begin, shares))
    first = _second(led, begin)
    return np.array(
        [
            (pose.slew - begin.slew, _second(led, pose) - first, way.hoisted(led, begin, pose, share))
            for pose, share in zip(poses, shares, strict=True)
        ]
    )


def _second(led: LedHook, pose: Pose) -> float:
    """What the drive counts that luffs the boom, or travels in its place [m, rad]."""
    if led.travels:
        return pose.travel
    return pose.angle if led.boom.gear is None else led.boom.gear.taken_up(pose.angle)


def _series(drives: Callable[[Sequence[float]], np.ndarray]) -> tuple[list[list[float]], float]:
    """Coefficients of each drive, as many as it needs, and the largest of the last quarter."""
    terms = _FIRST
    while True:
        nodes = chebyshev.chebpts1(terms)  # rising
        # Polynomials are orthogonal over these nodes.
        found = (
            2.0
            / terms
            * (drives([float(one) for one in (nodes + 1.0) / 2.0]).T @ chebyshev.chebvander(nodes, terms - 1))
        )
        found[:, 0] /= 2.0
        tail = float(np.abs(found[:, 3 * terms // 4 :]).max())
        if tail <= _ROUNDING or terms >= _MOST:
            return [_without_noise(one) for one in found], tail
        terms *= 2


def _without_noise(coefficients: np.ndarray) -> list[float]:
    """The coefficients up to the last that is more than rounding, which derivatives have many times over."""
    told = np.flatnonzero(np.abs(coefficients) > _ROUNDING / 4)
    last = int(told[-1]) + 1 if len(told) else 1
    return [float(one) for one in coefficients[:last]]
