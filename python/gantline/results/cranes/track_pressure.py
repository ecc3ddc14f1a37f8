"""Pressure under the two tracks of a crawler crane, and how near it is to tipping, from the forces under it.

The crane is rigid and stands on two strips of elastic ground that push and never pull.
docs/concepts/crawler.md has the derivation; names of its symbols are in brackets here.
"""

from __future__ import annotations

import numpy as np

from gantline.results.variable import FloatArray

__all__ = ["CORNERS", "line_pressures", "raised_forces", "tipping_utilisation"]

#: Ends of the tracks, in the order of all arrays here: track, and end along the tracks' heading.
CORNERS = ("left.front", "left.back", "right.front", "right.back")
#: Along and across of each of them, and forces on them that are in balance with each other.
_ALONG, _ACROSS = np.array([1.0, -1.0, 1.0, -1.0]), np.array([1.0, 1.0, -1.0, -1.0])
_TWIST = _ALONG * _ACROSS
#: Halvings of the bracket of the slope: more than a float has digits.
_HALVINGS = 60


def line_pressures(corners: FloatArray, length: float, uneven: FloatArray | None = None) -> FloatArray:
    """Force per length at the ends of both tracks.

    Each track is pressed into the ground by w + s x along its length. On level ground the slope s is the
    same for both: they are parts of one crane. Ground that rises along a track towards its front adds a slope
    of that track's own. Where the force is below zero the track is clear of the ground. What each track
    carries [F] follows from the forces across, the common slope from the moment along of both.

    Args:
        corners: Forces under the ends of the tracks, in the order of `CORNERS`, shape (time, 4) [N].
        length: Length of a track on the ground [L, m].
        uneven: What the ground adds to the slope of each track [u_t, N/m^2], shape (time, 2), left and right;
            nothing on level ground.

    Returns:
        Force per length of each end, the same order and shape [N/m]; 0 where an end is clear. Where all
        force is under one end, and no strip could carry it, a hundredth of the length carries it.
    """
    carried = corners[:, 0::2] + corners[:, 1::2]  # left, right
    moment = (corners[:, 0] - corners[:, 1] + corners[:, 2] - corners[:, 3]) * length / 2
    forward = np.where(moment < 0, -1.0, 1.0)
    # Not more than what a hundredth of the length at the end can bear: a triangle of which the resultant is
    # at its third.
    most = carried.sum(axis=1) * length * (0.5 - 0.01 / 3)
    own = np.zeros_like(carried) if uneven is None else forward[:, None] * uneven
    slopes = own + _slope(carried, np.minimum(np.abs(moment), most), own, length)[:, None]
    steep = np.abs(slopes)
    mean = carried / length
    whole = steep * length <= 2 * mean  # all of the track is on the ground
    near = np.where(whole, mean + steep * length / 2, np.sqrt(2 * carried * steep))
    far = np.where(whole, mean - steep * length / 2, 0.0)
    ahead = forward[:, None] * slopes >= 0
    front, back = np.where(ahead, near, far), np.where(ahead, far, near)
    return np.stack([front[:, 0], back[:, 0], front[:, 1], back[:, 1]], axis=1)


def _slope(carried: FloatArray, moment: FloatArray, own: FloatArray, length: float) -> FloatArray:
    """Slope of the force per length [s, N/m^2] with which both tracks take a moment [N m], shape (time,).

    It comes on top of what each track has of its own, shape (time, 2).
    """
    total = carried.sum(axis=1)
    steepest = np.abs(own).max(axis=1)
    # Beyond this even the heavier track stands on less than a hundredth of its length.
    low, high = -steepest, np.maximum(2e4 * total / length**2, np.finfo(float).tiny) + steepest
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        below = _moment(carried, own + middle[:, None], length) < moment
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    slope: FloatArray = (low + high) / 2
    return slope


def _moment(carried: FloatArray, slopes: FloatArray, length: float) -> FloatArray:
    """Moment of both tracks about their middle at slopes of the force per length, shape (time,) [N m]."""
    steep = np.abs(slopes)
    on_ground = np.sqrt(2 * carried / np.maximum(steep, np.finfo(float).tiny))
    whole = steep * length**2 <= 2 * carried
    moments = np.where(whole, steep * length**3 / 12, carried * (length / 2 - on_ground / 3))
    total: FloatArray = (np.sign(slopes) * moments).sum(axis=1)
    return total


def tipping_utilisation(
    corners: FloatArray, own: FloatArray, centre: FloatArray, length: float, gauge: float
) -> FloatArray:
    """Moment of all that is not the crane's own weight over that of its own weight, about a tipping line.

    The lines are those through the ends of the tracks: over each side and each end. Of a load that hangs
    still it is the load over the load at which the crane tips; dynamics and falls out of plumb are in it.

    Args:
        corners: Forces under the ends of the tracks, in the order of `CORNERS`, shape (time, 4) [N].
        own: Weight of the crane, shape (time,) [N].
        centre: Centre of gravity of the crane from the middle of its tracks: forward and to the left, shape
            (time, 2) [m].
        length: Length of a track on the ground [m].
        gauge: Distance of the tracks, middle to middle [m].

    Where the crane's own weight lies beyond a line, as that of a counterweight may, what hangs holds it: of
    that line it is the moment of its own weight over the moment of what holds it.

    Returns:
        The worst of the four lines, shape (time,) [1]; 1 where two corners are clear.
    """
    lines = (
        (corners[:, 1] + corners[:, 3], length, 0, 1.0),  # over the front end; the back corners hold
        (corners[:, 0] + corners[:, 2], length, 0, -1.0),
        (corners[:, 2] + corners[:, 3], gauge, 1, 1.0),  # over the left track
        (corners[:, 0] + corners[:, 1], gauge, 1, -1.0),
    )
    worst = np.full(len(own), -np.inf)
    for beyond, across, axis, sign in lines:
        holds = own * (across / 2 - sign * centre[:, axis])
        presses = beyond * across
        used = 1 - presses / np.where(holds > 0, holds, 1.0)
        # Two corners that are clear leave nothing that presses: 1 there too.
        over = -holds / np.where(presses > holds, presses - holds, 1.0)
        leans = np.where(presses > 0, over, 1.0)
        worst = np.maximum(worst, np.where(holds > 0, used, leans))
    return worst


def raised_forces(
    corners: FloatArray, own: FloatArray, centre: FloatArray, size: tuple[float, float], by: FloatArray
) -> FloatArray:
    """Forces under the ends of the tracks if all but the crane's own weight were more.

    What each side and each end bears beyond the crane's own weight follows from moments alone, and is raised;
    how it comes to the corners is that of (CR1), or as of three, where one is clear.

    Args:
        corners: Forces under the ends of the tracks, in the order of `CORNERS`, shape (time, 4) [N].
        own: Weight of the crane, shape (time,) [N].
        centre: Centre of gravity of the crane from the middle of its tracks: forward and to the left, shape
            (time, 2) [m].
        size: Length of a track on the ground, and gauge [m].
        by: What all but its own weight would be over what it is, shape (time,) [1].

    Returns:
        The forces, like `corners`; a side on which nothing is left has none.
    """
    length, gauge = size
    beside = corners.sum(axis=1) - own
    along = corners @ _ALONG - own * 2.0 * centre[:, 0] / length
    across = corners @ _ACROSS - own * 2.0 * centre[:, 1] / gauge
    more = (beside[:, None] + along[:, None] * _ALONG + across[:, None] * _ACROSS) / 4.0
    raised = corners + (by - 1.0)[:, None] * more
    # A corner that is clear, or comes clear, hands what it lacks to its neighbours, and its opposite with it.
    lacks = np.where((corners <= 0.0) & (by > 1.0)[:, None], raised, np.minimum(raised, 0.0))
    worst = np.argmax(np.abs(lacks), axis=1)
    lack = np.take_along_axis(lacks, worst[:, None], axis=1)
    found: FloatArray = np.maximum(raised - lack * _TWIST[worst][:, None] * _TWIST, 0.0)
    return found
