"""Waves of first order: how long they are, and the regular waves that a sea is made of.

Every wave is η = a cos(k·x − ωt + ε), with ω² = g κ tanh κd, κ = |k| (Airy 1845).
"""

from __future__ import annotations

import math
import random
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

__all__ = ["Components", "group_velocity", "jonswap", "phases", "regular", "sea", "wave_number"]

Array = npt.NDArray[np.float64]

#: Shape of a JONSWAP peak below and above its frequency: Hasselmann et al. 1973.
_PEAK_WIDTH = (0.07, 0.09)
#: Frequencies of a spectrum that are looked at, in those of its peak.
_FROM, _TO, _POINTS = 0.2, 40.0, 20_001


@dataclass(frozen=True)
class Components:
    """Regular waves that run in one direction, or gusts.

    Attributes:
        frequency: ω (n,) [rad/s].
        amplitude: a (n,) [m, of gusts m/s].
        phase: ε (n,) [rad].
        direction: from world x towards y [rad].
    """

    frequency: Array
    amplitude: Array
    phase: Array
    direction: float


def wave_number(frequency: Array, gravity: float, depth: float | None) -> Array:
    """κ of waves (n,) [rad/m], by Newton's method to rounding.

    Args:
        frequency: ω (n,) [rad/s].
        gravity: g [m/s^2].
        depth: d [m]; None is deep water.
    """
    deep: Array = frequency**2 / gravity
    if depth is None:
        return deep
    wanted = deep * depth
    # x tanh x grows from x² to x: both bounds are from below, and the slope grows.
    found = np.maximum(wanted, np.sqrt(wanted))
    for _ in range(20):
        tanh = np.tanh(found)
        found = found - (found * tanh - wanted) / (tanh + found * (1.0 - tanh**2))
    number: Array = found / depth
    return number


def group_velocity(frequency: Array, gravity: float, depth: float | None) -> tuple[Array, Array]:
    """With which energy goes, c = dω/dκ (n,) [m/s], and its derivative over κ as a share of it (n,) [m].

    Args:
        frequency: ω (n,) [rad/s].
        gravity: g [m/s^2].
        depth: d [m]; None is deep water.
    """
    number = wave_number(frequency, gravity, depth)
    if depth is None:
        return gravity / (2 * frequency), -0.5 / number
    # 2κd / sinh 2κd, nothing where that is large.
    twice = np.minimum(2 * number * depth, 300.0)
    shallow = twice / np.sinh(twice)
    speed = frequency / (2 * number) * (1 + shallow)
    bend = shallow * (1 - twice / np.tanh(twice)) / (1 + shallow)
    return speed, speed / frequency + (bend - 1) / number


def jonswap(frequency: Array, significant_height: float, peak_period: float, enhancement: float) -> Array:
    """JONSWAP spectrum of the elevation S(ω), one-sided, with m₀ = H_s²/16 (n,) [m^2 s].

    Args:
        frequency: ω (n,) [rad/s].
        significant_height: H_s [m].
        peak_period: T_p [s].
        enhancement: γ; 1 is the spectrum of Pierson and Moskowitz.
    """
    peak = 2 * math.pi / peak_period
    grid = peak * np.geomspace(_FROM, _TO, _POINTS)
    scale = significant_height**2 / 16 / np.trapezoid(_shape(grid / peak, enhancement), grid)
    spectrum: Array = scale * _shape(frequency / peak, enhancement)
    return spectrum


def _shape(ratio: Array, enhancement: float) -> Array:
    width = np.where(ratio <= 1.0, *_PEAK_WIDTH)
    peakedness = np.exp(-0.5 * ((ratio - 1.0) / width) ** 2)
    shape: Array = ratio**-5.0 * np.exp(-1.25 * ratio**-4.0) * enhancement**peakedness
    return shape


def regular(height: float, period: float, direction: float, phase: float = 0.0) -> Components:
    """Waves that are all alike.

    Args:
        height: H from crest to trough [m].
        period: T [s].
        direction: In which they run, from world x towards y [rad].
        phase: ε, how late crests pass the origin of the world [rad].
    """
    one = np.array([2 * math.pi / period])
    return Components(one, np.array([height / 2]), np.array([phase]), direction)


def sea(
    significant_height: float,
    peak_period: float,
    direction: float,
    *,
    enhancement: float,
    count: int,
    seed: str,
) -> Components:
    """A sea as regular waves of the same energy, each at the middle of its share of it, phases by lot.

    Frequencies have no common measure, so that the record does not repeat, and all energies together are
    those of the spectrum, whatever the count.

    Args:
        significant_height: H_s [m].
        peak_period: T_p [s].
        direction: that it runs in, from world x towards y [rad].
        enhancement: γ.
        count: number of waves.
        seed: where the lots begin; another text is another record.
    """
    grid = 2 * math.pi / peak_period * np.geomspace(_FROM, _TO, _POINTS)
    density = jonswap(grid, significant_height, peak_period, enhancement)
    below = np.concatenate([[0.0], np.cumsum(np.diff(grid) * (density[1:] + density[:-1]) / 2)])
    middles = (np.arange(count) + 0.5) / count
    frequency = np.interp(middles, below / below[-1], grid)
    amplitude = np.full(count, significant_height / 4 * math.sqrt(2 / count))
    return Components(frequency, amplitude, phases(count, seed), direction)


def phases(count: int, seed: str) -> Array:
    """Phases by lot (count,) [rad], from 0 to 2π; another seed gives others."""
    lots = random.Random(seed)
    return np.array([2 * math.pi * lots.random() for _ in range(count)])
