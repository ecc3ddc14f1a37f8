"""Long steps: a chain of masses 1,000,000 : 1 on ropes of EA = 1e10 N, `del` at h = 0.1 s."""

from __future__ import annotations

import numpy as np
import pytest

from chain import DISTURBANCE, EA, HEAVY, LENGTH, LIGHT, NODES, STEP, shake
from mechanics import G

WEIGHT = HEAVY * G
#: h² T/(m ℓ): how far beyond its reach the step is for the sideways motion of a light mass.
BEYOND = STEP**2 * WEIGHT / (LIGHT * LENGTH * (1 + WEIGHT / EA))


def test_the_step_is_far_too_long_for_the_sideways_motion() -> None:
    """h ω = √(4 h² T/(m ℓ)) = 280, where an explicit step must stay below 2."""
    assert 2 * np.sqrt(BEYOND) == pytest.approx(280, rel=0.01)


def test_chain_is_stable_with_geometric_stiffness() -> None:
    """600 steps: never further to the side than at the start, 1 µm, and at rest in the end; T = m g."""
    chain = shake(60.0, geometric_stiffness=True)
    assert chain.largest.max() <= DISTURBANCE * (1 + 1e-9)
    assert chain.largest[-1] < 1e-3 * DISTURBANCE
    weight = WEIGHT + NODES * LIGHT * G
    assert chain.tension == pytest.approx(weight, rel=1e-5)
    assert np.ptp(chain.height, axis=0).max() < 1e-4


def test_chain_shakes_sideways_without_it() -> None:
    """The first step throws the inner masses to 1 − 4 h² T/(m ℓ) = −78,000 times their displacement."""
    chain = shake(2.0, geometric_stiffness=False)
    inner = chain.sideways[:, 2:4]
    assert inner[1] / inner[0] == pytest.approx(1 - 4 * BEYOND, rel=1e-3)
    assert chain.largest.max() > 1.0, "m, from 1 µm"
    assert chain.tension.min() < 1e-3 * WEIGHT, "a chain that should carry 1,000 t no longer does"
