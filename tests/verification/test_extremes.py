"""Gumbel's distribution by probability-weighted moments, on samples of known distributions."""

from __future__ import annotations

import numpy as np
import pytest

from gantline.study import Gumbel

SHARE = 0.1
SAMPLES = 20_000


def exact(location: float, scale: float) -> float:
    """What a share of 0.1 exceeds, the inverse of exp(−exp(−(x − location)/scale)) = 0.9."""
    return location - scale * float(np.log(-np.log(1.0 - SHARE)))


@pytest.mark.parametrize("count", [5, 10, 50])
def test_unbiased_and_as_sure_as_it_says(count: int) -> None:
    """Samples of Gumbel's own distribution, location 3, scale 2.

    Probability-weighted moments are unbiased for any count, so is what is linear in them: the mean of 20,000
    estimates is within four of its standard errors of the exact value (SE3). The standard error told is that
    of many values (SE4), which of few is off by a share of the order 1/count: 6, 3 and 1 % here.
    """
    draws = np.random.default_rng(47).gumbel(3.0, 2.0, (SAMPLES, count))
    found = [Gumbel.of(draw) for draw in draws]
    estimates = np.array([one.exceeded_by(SHARE) for one in found])
    spread = float(estimates.std())
    assert estimates.mean() == pytest.approx(exact(3.0, 2.0), abs=4.0 * spread / np.sqrt(SAMPLES))
    told = np.sqrt(np.mean([one.error(SHARE) ** 2 for one in found]))
    assert told == pytest.approx(spread, rel=0.3 / count + 2.0 / np.sqrt(SAMPLES))


@pytest.mark.parametrize(("waves", "off"), [(10, 0.014), (100, 0.0055), (1000, 0.0035)])
def test_of_what_follows_waves_linearly(waves: int, off: float) -> None:
    """Crests of a linear response in a narrow-banded sea have Rayleigh's distribution.

    The largest of N of them is below x with the probability (1 − exp(−x²/2))ᴺ, for which exp(−N exp(−x²/2))
    is taken, as for crossings that are rare (Cartwright and Longuet-Higgins 1956): 9 of 10 lifts stay below
    √(2 ln(N/−ln 0.9)), in standard deviations. It tends to Gumbel's distribution as slowly as 1/ln N, which
    makes the estimates 0.8, 0.2 and 0.1 % too large (of a hundred thousand samples). Four standard errors of
    the 4000 here, of ten records each, are 0.6, 0.4 and 0.3 %.
    """
    exactly = np.sqrt(2.0 * np.log(waves / -np.log(1.0 - SHARE)))
    chance = np.random.default_rng(47).random((4000, 10))
    crests = np.sqrt(2.0 * np.log(waves / -np.log(chance)).clip(0.0))
    estimates = np.array([Gumbel.of(one).exceeded_by(SHARE) for one in crests])
    assert estimates.mean() == pytest.approx(exactly, rel=off)
