"""Changes of modes that follow each other: a run must get through them in a bounded number of steps."""

from __future__ import annotations

from mechanics import adaptive, body, contact, document, free


def test_a_turning_body_lands_on_a_corner() -> None:
    """One corner with damping and friction, falling 0.1 m at 0.2 rad/s: it sticks and slides a few times."""
    corner = contact("corner", "body", (1, 0, -0.5), stiffness=1e8, damping_time=0.01, friction=0.4)
    start = free((0, 0, 0.6), angular_velocity=[0, 0.2, 0])
    system = document([body("body", start, 2000.0, inertia=(800, 800, 1200))], contacts=[corner])
    run = adaptive(system, 0.118, tension_tolerance=None, position_tolerance=None)
    assert len(run.events("set_down")) == 1
    assert len(run.events("slip")) < 20
    assert run.counters["steps"] < 400
