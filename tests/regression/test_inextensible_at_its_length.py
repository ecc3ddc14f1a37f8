"""Inextensible ropes that are at their length at the start while their ends come closer or move apart.

They began as taut whatever their ends did. One whose ends came closer held its load like a rod, which took
the velocity along the rope at once, and the books called that the method's; one whose ends moved apart got
longer by 1 mm in the first step, and the impact was the method's too.

10 kg hang 2 m below the end of a rope and start at 3 m/s aside.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from mechanics import G, Json, Run, adaptive, body, document, end, free, point, rope, simulate

MASS, LENGTH, ASIDE = 10.0, 2.0, 3.0
#: How far beyond its length a rope gets before it is caught: five tolerances of position [m].
CAUGHT = 5e-9


def pendulum(up: float) -> Json:
    bob = body("load", point((0, 0, -LENGTH), (ASIDE, 0, up)), MASS)
    return document([bob], ropes=[rope("r", None, [end(None), end("load")], None)])


def tight(system: Json, duration: float) -> Run:
    return adaptive(system, duration, position_tolerance=CAUGHT / 5, sample_interval=1e-3)


def fallen(time: float) -> tuple[float, float]:
    """Where a load thrown up at 1 m/s is in free flight [m]."""
    return ASIDE * time, -LENGTH + time - G * time**2 / 2


def test_a_load_thrown_towards_its_anchor_flies() -> None:
    """Free flight until |x| = L; there it loses ½ m (v·n)², n along the rope."""
    taut = brentq(lambda t: math.hypot(*fallen(t)) - LENGTH, 0.05, 0.5, xtol=1e-15)
    x, z = fallen(taut)
    along = (ASIDE * x + (1 - G * taut) * z) / LENGTH
    run = tight(pendulum(1.0), 0.2)
    [(time, _)] = run.events("taut")
    # Caught within 5 nm at (v·n) = 0.98 m/s.
    assert time == pytest.approx(taut, abs=2 * CAUGHT)
    # On those 5 nm (v·n) grows by less than 20 m/s² · 5 ns.
    assert run.energy("impact")[-1] == pytest.approx(MASS * along**2 / 2, rel=1e-6)
    assert abs(run.energy("method")[-1]) < 1e-6
    before = run.time < taut
    flight = np.array([fallen(t) for t in run.time[before]])
    assert run.body("load")[before][:, [0, 2]] == pytest.approx(flight, abs=1e-9)
    assert run.tension("r")[before].max() == 0.0


def test_a_load_thrown_away_from_its_anchor_is_caught_at_once() -> None:
    """½ m v² of the velocity along the rope is lost as impact, and the rope gets no longer than it may."""
    run = tight(pendulum(-1.0), 0.1)
    assert run.energy("impact")[-1] == pytest.approx(MASS / 2, rel=1e-6)
    assert abs(run.energy("method")[-1]) < 1e-6
    assert run.columns["residual_constraint"].max() < CAUGHT
    # T = m (v²/L + g) right after.
    assert run.tension("r")[1] == pytest.approx(MASS * (ASIDE**2 / LENGTH + G), rel=1e-3)


def test_fixed_steps_book_it_alike() -> None:
    """`del` loses ½ m v² as impact, to the order of its step of 0.1 ms: (v·n) grows by 14 m/s² within it."""
    run = simulate(pendulum(-1.0), 0.1, step=1e-4)
    assert run.energy("impact")[-1] == pytest.approx(MASS / 2, rel=3e-3)


def test_a_load_that_swings_starts_taut() -> None:
    """Across the rope alone nothing is lost and nothing told."""
    run = tight(pendulum(0.0), 0.1)
    assert run.energy("impact")[-1] == 0.0
    assert not run.events("taut") and not run.events("slack")
    assert run.tension("r")[0] == pytest.approx(MASS * (ASIDE**2 / LENGTH + G), rel=1e-9)


def test_two_slings_catch_a_load_together() -> None:
    """Both slings act: v₊ = v − M⁻¹Gᵀ(G M⁻¹Gᵀ)⁻¹ G v, with G of the two lugs and the least of energy lost."""
    inertia = np.array([100.0, 160.0, 200.0])
    lugs = np.array([[1.0, 0.2, 0.5], [-1.0, -0.3, 0.6]])
    tops = np.array([[1.5, 0.0, 6.0], [-1.2, 0.4, 6.0]])
    start = np.array([0.3, -0.4, -3.0, 0.5, -0.3, 0.2])
    mass = np.array([500.0, 500.0, 500.0, *inertia])
    along = (lugs - tops) / np.linalg.norm(lugs - tops, axis=1)[:, None]
    rows = np.hstack([along, np.cross(lugs, along)])
    impulse = np.linalg.solve(rows / mass @ rows.T, rows @ start)
    assert impulse.min() > 0, "both must act"
    after = start - rows.T @ impulse / mass
    load = body(
        "load",
        free((0, 0, 0), velocity=start[:3].tolist(), angular_velocity=start[3:].tolist()),
        500.0,
        inertia=inertia.tolist(),
    )
    ropes = [
        rope(f"r{k}", None, [end(None, top), end("load", lug)], None)
        for k, (top, lug) in enumerate(zip(tops.tolist(), lugs.tolist(), strict=True))
    ]
    run = adaptive(
        {"gravity": [0, 0, 0], "bodies": [load], "ropes": ropes},
        1e-6,
        position_tolerance=CAUGHT / 5,
        sample_interval=1e-6,
    )
    found = [*run.body("load", "body_velocity")[-1], *run.body("load", "body_angular_velocity")[-1]]
    # Within 1 µs velocities of 3 m/s turn by some 1e-6 of themselves.
    assert found == pytest.approx(after, abs=1e-5)
    lost = (mass * start**2).sum() / 2 - (mass * after**2).sum() / 2
    assert run.energy("impact")[-1] == pytest.approx(lost, rel=1e-6)
