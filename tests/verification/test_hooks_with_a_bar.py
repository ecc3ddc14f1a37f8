"""Two hook blocks on falls with a bar on slings below them: four motions across that go together."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.linalg import eigh

from mechanics import Floats, G, Json, Run, adaptive, body, document, end, free, point, rope, simulate
from resting import at_rest

FALL, SLING, HOOK, BAR, HALF = 30.0, 6.0, 2000.0, 10000.0, 5.0
#: About the bar's middle, across it; not that of a uniform bar, whose ends would move by themselves.
INERTIA = 9.0 * BAR
BELOW = BAR * G / 2
ABOVE = BELOW + HOOK * G


def matrices() -> tuple[Floats, Floats]:
    """M and K over both hooks' ways across, the bar's, and its turn about plumb.

    V = T₁/2l₁ (y₁² + y₂²) + T₂/2l₂ ((y₁ − y − b ψ)² + (y₂ − y + b ψ)²).
    """
    first, second = np.array([1.0, 0, -1, -HALF]), np.array([0, 1.0, -1, HALF])
    stiffness = ABOVE / FALL * np.diag([1.0, 1, 0, 0])
    stiffness += BELOW / SLING * (np.outer(first, first) + np.outer(second, second))
    return np.diag([HOOK, HOOK, BAR, INERTIA]), stiffness


def hooks_with_a_bar(aside: float, ea: float | None) -> Json:
    """At rest, but the first hook, which is held aside and let go of [m]."""
    bodies = [
        body("one", point((HALF, aside, -FALL)), HOOK),
        body("other", point((-HALF, 0, -FALL)), HOOK),
        body("bar", free((0, 0, -FALL - SLING)), BAR, inertia=(INERTIA, INERTIA, INERTIA)),
    ]
    # Of inextensible ropes as long as their ways.
    fall, sling = (None, None) if ea is None else (FALL / (1 + ABOVE / ea), SLING / (1 + BELOW / ea))
    ropes = []
    for name, side in (("one", HALF), ("other", -HALF)):
        ropes.append(rope(f"fall {name}", fall, [end(None, (side, 0, 0)), end(name)], ea))
        ropes.append(rope(f"sling {name}", sling, [end(name), end("bar", (side, 0, 0))], ea))
    return document(bodies, ropes=ropes)


def error(run: Run, aside: float) -> float:
    """Largest distance of hooks and bar from Σ φ cos(ω t) φᵀM y₀, of what it was held aside."""
    mass, stiffness = matrices()
    squares, shapes = eigh(stiffness, mass)
    shares = shapes.T @ mass @ [aside, 0, 0, 0]
    exactly = (shapes * shares) @ np.cos(np.sqrt(squares)[:, None] * run.time)
    turned = 2 * HALF * run.body("bar", "body_orientation")[:, 3]
    found = [*(run.body(name)[:, 1] for name in ("one", "other", "bar")), turned]
    exactly[3] *= HALF
    return float(np.abs(np.array(found) - exactly).max() / aside)


def test_periods_of_two_hooks_with_a_bar() -> None:
    """det(K − ω² M) = 0: 11.78, 8.36, 2.45 and 2.07 s across."""
    squares = eigh(*reversed(matrices()), eigvals_only=True)
    wanted = 2 * math.pi / np.sqrt(squares)
    assert wanted == pytest.approx([11.785, 8.363, 2.449, 2.070], abs=5e-4)
    rest = at_rest(hooks_with_a_bar(0.0, None))
    for period in wanted:
        assert np.abs(np.array(rest.periods) / period - 1).min() < 1e-9


@pytest.mark.parametrize(
    # Of what the hook was held aside. 0.1 mm in a step, of 50 mm, left 1.8e-2; a quarter of that is of angles
    # that are not small: 4.7e-3 at any tolerance, which falls with their square. Of 1 mm 3.6e-6 was found.
    ("aside", "tolerances", "bound"),
    [(0.05, (None, None), 3e-2), (1e-3, (1e-2, 1e-9), 1e-5)],
    ids=["default", "tight"],
)
def test_two_hooks_with_a_bar_swing_in_four_modes(
    aside: float, tolerances: tuple[float | None, float | None], bound: float
) -> None:
    """y(t) = Σ φ cos(ω t) φᵀ M y₀ of four modes, each of which has a share, over a minute."""
    force, way = tolerances
    system = hooks_with_a_bar(aside, None)
    run = adaptive(system, 60.0, tension_tolerance=force, position_tolerance=way, sample_interval=0.05)
    assert error(run, aside) < bound


def test_two_hooks_with_a_bar_converge_with_the_step() -> None:
    """y(t) = Σ φ cos(ω t) φᵀ M y₀ by `del`: half the step has half the error, 3.8e-3 at 4 ms."""
    errors = []
    for step in (8e-3, 4e-3):
        run = simulate(hooks_with_a_bar(1e-3, 4e9), 60.0, step=step, sample_interval=0.04)
        errors.append(error(run, 1e-3))
    assert errors[1] < 5e-3
    assert errors[0] / errors[1] == pytest.approx(2, abs=0.02)
