"""The adjustment of three moving sheaves, Fig. 6 of Ham, Roh and Lee (2016), against its closed form.

The derivation stands in `tests/support/adjustment.py`.
"""

from __future__ import annotations

import numpy as np
import pytest

from adjustment import DURATION, GAP, PULLS, STIFFNESS, course, system
from mechanics import Run, adaptive


@pytest.fixture(scope="module")
def run() -> Run:
    return adaptive(system(), DURATION, tension_tolerance=1e-2, position_tolerance=1e-8, sample_interval=0.05)


def went_taut(run: Run) -> dict[str, float]:
    """When each sling went taut [s], in order."""
    return {name: when for when, name in run.events("taut") if name != "equalizing"}


def test_the_sequence_of_fig_6(run: Run) -> None:
    """Forces and travels over all of it, and when each sling goes taut.

    Left out of the closed form are inertia, k m/c² = 2.5e-6 of a force, the stretch of the equalizing rope,
    k · 5e3 N · 25 m/1e12 N = 0.01 N, and that lugs start to move within a time, 0.04 N: a hundred-thousandth
    of the largest force, 0.35 N, bounds them.
    """
    exact = course(run.time)
    force = np.stack([run.tension(f"f{i}") for i in range(3)], axis=1)
    travel = np.stack([run.joint(f"p{i}") for i in range(3)], axis=1)
    largest = exact.force.max()
    assert np.abs(force - exact.force).max() < 1e-5 * largest
    assert np.abs(travel - exact.travel).max() < 1e-5 * largest / STIFFNESS
    taut = went_taut(run)
    assert list(taut) == ["f1", "f0", "f2"]
    assert list(taut.values()) == pytest.approx([exact.taut[i] for i in (1, 0, 2)], abs=1e-4)
    assert run.energy_remainder < 1e-6


def test_what_the_paper_says_of_it(run: Run) -> None:
    """(a) f₁ alone: p1 goes down, the others up alike. (b) f₀ > f₁ > f₂ = 0: p0 down, p2 further up than p1.

    (c) all forces equal, k/3 Σ (y − g), and every sheave at rest at its own y − g less the mean.
    """
    time = run.time
    force = np.stack([run.tension(f"f{i}") for i in range(3)], axis=1)
    travel = np.stack([run.joint(f"p{i}") for i in range(3)], axis=1)
    taut = went_taut(run)
    first = (time > taut["f1"] + 0.1) & (time < taut["f0"])
    assert (force[first][:, 1] > 0).all()
    assert (force[first][:, [0, 2]] == 0).all()
    moved = np.diff(travel[first], axis=0)
    assert (moved[:, 1] > 0).all()
    assert np.allclose(moved[:, [0, 2]], -0.5 * moved[:, [1]], rtol=0, atol=1e-7)
    second = (time > taut["f0"] + 0.3) & (time < taut["f2"])
    assert second.any()
    assert (force[second][:, 0] > force[second][:, 1]).all()
    assert (force[second][:, 1] > 0).all()
    assert (force[second][:, 2] == 0).all()
    down = travel[second][-1] - travel[second][0]
    assert down[0] > 0 > down[1] > down[2]
    pulled = np.zeros(3)
    for lug, start, stop, speed in PULLS:
        pulled[lug] += speed * (stop - start)
    reach = pulled - np.array(GAP)
    # (24 s − 7.5 s)/(c/k) = 8.2 time constants: e^−8.2 of the first difference, 3e-4, is left.
    assert force[-1] == pytest.approx([STIFFNESS * reach.sum() / 3] * 3, rel=1e-3)
    assert travel[-1] == pytest.approx(reach - reach.mean(), abs=1e-4)
