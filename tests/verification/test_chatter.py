"""Sticking and sliding: a bounded number of changes, and one law for both methods."""

from __future__ import annotations

import numpy as np
import pytest

from mechanics import G, Json, adaptive, body, contact, document, free, simulate


def test_a_turning_body_lands_on_a_corner() -> None:
    """One corner with damping and friction, falling 0.1 m at 0.2 rad/s: it sticks and slides a few times."""
    corner = contact("corner", "body", (1, 0, -0.5), stiffness=1e8, damping_time=0.01, friction=0.4)
    start = free((0, 0, 0.6), angular_velocity=[0, 0.2, 0])
    system = document([body("body", start, 2000.0, inertia=(800, 800, 1200))], contacts=[corner])
    run = adaptive(system, 0.118, tension_tolerance=None, position_tolerance=None)
    assert len(run.events("set_down")) == 1
    assert len(run.events("slip")) < 20
    assert run.counters["steps"] < 400


def sliding_box() -> Json:
    """A box of 2 t on four corners that slides at 1.5 m/s and turns at 1 rad/s."""
    mass, stiffness = 2000.0, 1e6
    inertia = (mass / 3 * 0.89, mass / 3 * 1.25, mass / 3 * 1.64)
    start = free((0, 0, 0.5 - mass * G / (4 * stiffness)), velocity=[1.5, 0, 0], angular_velocity=[0, 0, 1.0])
    corners = [
        contact(f"c{x}{y}", "box", (x, 0.8 * y, -0.5), stiffness=stiffness, damping_time=0.01, friction=0.4)
        for x in (-1, 1)
        for y in (-1, 1)
    ]
    return document([body("box", start, mass, inertia=inertia)], contacts=corners)


def test_a_box_slides_and_turns_alike_by_both_methods() -> None:
    """`del` at a quarter of the step ends a quarter as far from `adaptive`, which needs few steps for it."""
    exact = adaptive(sliding_box(), 1.0, tension_tolerance=1e-3, position_tolerance=1e-8)
    end = exact.body("box")[-1]
    coarse = adaptive(sliding_box(), 1.0, tension_tolerance=None, position_tolerance=None)
    assert coarse.body("box")[-1] == pytest.approx(end, abs=1e-5)
    assert coarse.counters["steps"] < 100
    assert abs(coarse.energy("method")[-1]) < 1e-5 * coarse.energy("friction")[-1]
    errors = []
    for step in (1e-3, 2.5e-4):
        run = simulate(sliding_box(), 1.0, step=step, sample_interval=0.1)
        errors.append(np.abs(run.body("box")[-1] - end).max())
        assert run.energy("friction")[-1] == pytest.approx(exact.energy("friction")[-1], rel=10 * step)
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.05)
