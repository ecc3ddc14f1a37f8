"""Impacts of several inextensible ropes at one moment, against their complementarity problem.

With lengths ℓ of the ropes' ways, J = ∂ℓ/∂v, mass matrix M and velocities v before the impact, the
impulses p are those of

    0 ≤ p ⟂ J v₊ ≤ 0        v₊ = v − M⁻¹ Jᵀ p

which has one solution where ropes do not repeat each other: of all sets of ropes that might hold one fits.
"""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from mechanics import Floats, G, adaptive, body, document, end, eye, free, half_turn, point, rope, slider

MASSES = np.array([300.0, 500.0])
INERTIAS = np.array([[60.0, 90.0, 120.0], [150.0, 110.0, 190.0]])
#: When all ropes go taut [s]; how long after that is looked at.
TAUT, AFTER = 0.5, 1e-5
#: Bodies are not turned, and where they are when ropes go taut [m].
MET = np.array([[0.0, 0.0, 0.0], [3.0, 0.0, 0.0]])
#: Bodies of both ends of each rope; none is the world.
PAIRS: tuple[tuple[int, int | None], ...] = ((0, 1), (0, None), (1, None), (0, 1))


def impulses(inertia: Floats, gradient: Floats, velocity: Floats) -> tuple[Floats, Floats]:
    """The impulses that fit (ropes,) and the velocities after them (12,)."""
    count, fitting = len(gradient), []
    for held in itertools.chain.from_iterable(
        itertools.combinations(range(count), n) for n in range(count + 1)
    ):
        rows = list(held)
        pulled = gradient[rows]
        impulse = np.zeros(count)
        impulse[rows] = np.linalg.solve(pulled / inertia @ pulled.T, pulled @ velocity)
        after = velocity - gradient.T @ impulse / inertia
        if (impulse >= 0.0).all() and (gradient @ after <= 1e-9).all():
            fitting.append((impulse, after))
    [answer] = fitting
    return answer


@pytest.mark.parametrize("seed", [2, 5, 7, 13])
def test_ropes_that_go_taut_together_share_the_impact(seed: int) -> None:
    """Two free bodies and two to four ropes with arms: velocities, spins and the energy lost."""
    draws = np.random.default_rng(seed)
    velocity = np.zeros((2, 6))
    while True:
        velocity[:, :3] = 2.0 * draws.normal(size=(2, 3))
        ends = []
        for first, second in PAIRS:
            arm = 0.5 * draws.normal(size=3)
            other = MET[first] + 4.0 * draws.normal(size=3) if second is None else 0.5 * draws.normal(size=3)
            ends.append((first, second, arm, other))
        gradient = np.zeros((len(ends), 2, 6))
        lengths, chosen = [], []
        for row, (first, second, arm, other) in enumerate(ends):
            far = other if second is None else MET[second] + other
            way = MET[first] + arm - far
            along = way / np.linalg.norm(way)
            lengths.append(float(np.linalg.norm(way)))
            gradient[row, first] = np.concatenate([along, np.cross(arm, along)])
            if second is not None:
                gradient[row, second] = -np.concatenate([along, np.cross(other, along)])
            # Straight flight: a way is longest at its end where it has grown from the start.
            relative = velocity[first, :3] - (0.0 if second is None else velocity[second, :3])
            if np.linalg.norm(way - TAUT * relative) < lengths[-1] - 0.1 and along @ relative > 0.3:
                chosen.append(row)
        if len(chosen) >= 2:
            break
    inertia = np.concatenate([[m] * 3 + list(i) for m, i in zip(MASSES, INERTIAS, strict=True)])
    before = velocity.ravel()
    impulse, after = impulses(inertia, gradient[chosen].reshape(len(chosen), 12), before)
    bodies = [
        body(
            f"b{k}",
            free(MET[k] - TAUT * velocity[k, :3], velocity=velocity[k, :3].tolist()),
            MASSES[k],
            inertia=INERTIAS[k].tolist(),
        )
        for k in range(2)
    ]
    for given in bodies:
        given["joint"]["position"] = list(given["joint"]["position"])
    ropes = []
    for row in chosen:
        first, second, arm, other = ends[row]
        far = end(None if second is None else f"b{second}", other.tolist())
        ropes.append(rope(f"r{row}", lengths[row], [end(f"b{first}", arm.tolist()), far], None))
    system = {**document(bodies, ropes=ropes), "gravity": [0, 0, 0]}
    run = adaptive(system, TAUT + AFTER, position_tolerance=1e-9, sample_interval=AFTER)
    found = np.concatenate(
        [
            np.concatenate(
                [run.body(f"b{k}", column)[-1] for column in ("body_velocity", "body_angular_velocity")]
            )
            for k in range(2)
        ]
    )
    # Forces of taut ropes, of the order of m v²/ℓ, act for 10 µs; they turn what has begun to spin.
    assert np.abs(found - after).max() < 20.0 * AFTER
    lost = (before**2 - after**2) @ inertia / 2
    # Caught within 5 nm of 1 m; the way to there turns by as much.
    assert run.energy("impact")[-1] == pytest.approx(lost, rel=1e-6)
    assert (impulse > 0.0).sum() >= 1
    taut = {name for _, name in run.events("taut")}
    assert taut >= {f"r{row}" for row, share in zip(chosen, impulse, strict=True) if share > 0.0}


def test_a_rope_with_a_moving_sheave_hands_an_impact_on() -> None:
    """A load falls into the end of a rope that carries a hook block in two parts, which fell as well.

    ℓ = 2 x + y of the depths x, y: J = (2, 1), slack s: both fall g t²/2, so 3 g t²/2 = s.
    """
    moving, load, slack, radius = 100.0, 40.0, 0.5, 0.5
    route = [
        end(None, (-radius, 0, 0)),
        half_turn("hook_block", (0, 0, 0), radius, False),
        eye(None, (radius, 0, 0)),
        eye(None, (2.0, 0, 0)),
        end("load"),
    ]
    length = 2 * 3.0 + math.pi * radius + (2.0 - radius) + 3.0 + slack
    bodies = [
        body("hook_block", slider(), moving, position=(0, 0, -3)),
        body("load", slider(), load, position=(2.0, 0, -3)),
    ]
    run = adaptive(document(bodies, ropes=[rope("r", length, route, None)]), 0.6)
    [(taut, _)] = run.events("taut")
    assert taut == pytest.approx(math.sqrt(2 * slack / (3 * G)), abs=1e-9)
    gradient, masses = np.array([2.0, 1.0]), np.array([moving, load])
    before = np.full(2, G * taut)
    impulse = gradient @ before / (gradient / masses @ gradient)
    after = before - gradient * impulse / masses
    # From then on M a = m g − J T, J a = 0.
    tension = gradient.sum() * G / (gradient / masses @ gradient)
    speed = after + (G - gradient * tension / masses) * (run.time[:, None] - taut)
    late = run.time > taut
    for k, name in enumerate(("hook_block", "load")):
        assert np.abs(-run.body(name, "body_velocity")[:, 2] - speed[:, k])[late].max() < 1e-6
    assert run.tension("r")[-1] == pytest.approx(tension, rel=1e-9)
    # Caught within 0.5 µm: weights do that much work more.
    assert run.energy("impact")[-1] == pytest.approx((masses * (before**2 - after**2)).sum() / 2, abs=1e-3)


def test_a_hoist_that_stops_harder_than_gravity_throws_its_load() -> None:
    """T = m (g + a) as it speeds up; then slack, free flight, and ½ m v² is lost where it is caught."""
    mass, speed, begin, braking, stop = 10.0, 3.0, 0.1, 0.8, 0.05
    speeding = 0.5
    ramps = [
        {"at": begin, "duration": speeding, "velocity": speed},
        {"at": braking, "duration": stop, "velocity": 0.0},
    ]
    bodies = [body("trolley", slider(drive="hoist"), 2.0), body("load", point((0, 0, -1)), mass)]
    ropes = [rope("r", 1.0, [end("trolley"), end("load")], None)]
    run = adaptive(document(bodies, ropes=ropes, drives=[{"name": "hoist", "ramps": ramps}]), 2.0)
    during = (run.time > begin + 1e-9) & (run.time < begin + speeding - 1e-9)
    assert np.abs(run.tension("r")[during] - mass * (G + speed / speeding)).max() < 1e-9
    cruising = (run.time > begin + speeding + 1e-9) & (run.time < braking - 1e-9)
    assert np.abs(run.tension("r")[cruising] - mass * G).max() < 1e-9
    [(slack, _)], [(taut, _)] = run.events("slack"), run.events("taut")
    # Braking with 60 m/s² begins with a jump; the trolley rises by v d/2 more.
    flight = (speed + math.sqrt(speed**2 - 2 * G * speed * stop / 2)) / G
    assert slack == pytest.approx(braking, abs=1e-12)
    assert taut == pytest.approx(braking + flight, abs=1e-9)
    # Caught within 0.5 µm: the weight does 50 µJ more.
    assert run.energy("impact")[-1] == pytest.approx(mass * (speed - G * flight) ** 2 / 2, abs=1e-4)
