"""What motors held at rest crept by rounding in `adaptive`, and what friction held beside rigid ropes.

What a brake holds had been made to stand still exactly, but for motors of limited force between their
steps: these crept on, 4e-19 m in three seconds under a load of 700 kg, and which rope a drum pays out
first when it hauls was settled by that. And where an inextensible rope is put back to its length after
each step, what that gave a joint held by its own friction was zero but for rounding, and added up to
3e-18 rad in half a second.
"""

from __future__ import annotations

import numpy as np
import pytest

from mechanics import (
    Json,
    adaptive,
    body,
    document,
    drum,
    end,
    flow,
    half_turn,
    hinge,
    point,
    rope,
    simulate,
    slider,
)

HIGH, RADIUS, EA, MASS = 10.0, 0.4, 3e6, 700.0


def hoist(ramps: list[Json]) -> Json:
    """A load that bounces on its rope and swings, over a sheave with losses, on a drum with a motor."""
    top = half_turn(None, (RADIUS, 0, HIGH), RADIUS, over=True, flow="top", ratio=1.06)
    route = [end("load"), top, drum(None, (3 * RADIUS, 0, HIGH / 2), "winch")]
    bodies = [
        body("load", point((0.6, 0, 2.0)), MASS),
        flow("winch", 60.0, capacity=60e3, drive="motor"),
        flow("top", 20.0),
    ]
    drives = [{"name": "motor", "ramps": ramps}]
    return document(bodies, ropes=[rope("r", None, route, EA, 0.002)], drives=drives)


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_a_motor_at_rest_does_not_move_its_drum_at_all(method: str) -> None:
    """|F| ≤ F₀ in (F6) with w = 0: ṡ = 0 exactly, so that s is 0."""
    system = hoist([])
    run = adaptive(system, 3.0) if method == "adaptive" else simulate(system, 3.0, step=1e-3)
    assert float(np.ptp(run.body("load")[:, 0])) > 0.1
    assert not run.joint("winch").any()


@pytest.mark.parametrize("shape", ["linear", "smooth"])
def test_it_stands_where_it_has_come_to_before_and_after_it_hauls(shape: str) -> None:
    """0.5 m/s by ramps of 0.2 s from 1 s and from 1.5 s on: 0.5 (0.5 − 0.2) + 0.5 · 0.2 = 0.25 m."""
    ramps = [
        {"at": 1.0, "duration": 0.2, "velocity": -0.5, "shape": shape},
        {"at": 1.5, "duration": 0.2, "velocity": 0.0, "shape": shape},
    ]
    run = adaptive(hoist(ramps), 3.0)
    paid = run.joint("winch")
    assert not paid[run.time <= 1.0].any()
    after = paid[run.time >= 1.71]
    assert after[0] == pytest.approx(-0.25, abs=1e-9)
    assert not np.ptp(after)


def test_what_friction_holds_stands_still_beside_a_rope_without_stretch() -> None:
    """A load snatches at an arm and then swings: M = 50 kN m holds its 100 kg at 2 m for good."""
    bodies = [
        body("arm", hinge(friction=50e3), 300.0, centre_of_gravity=(1, 0, 0), inertia=(50, 50, 50)),
        body("jib", slider((0, 1, 0), friction=50e3), 20.0, parent="arm", position=(2, 0, 0)),
        body("load", point((2.3, 0.3, -1.0)), 100.0),
    ]
    run = adaptive(document(bodies, ropes=[rope("r", 1.3, [end("jib"), end("load")], None)]), 5.0)
    late = run.time >= 1.0
    assert run.joint("arm")[-1] > 1e-3
    assert float(np.ptp(run.body("load")[late, 1])) > 0.1
    assert not np.ptp(run.joint("arm")[late]) and not np.ptp(run.joint("jib")[late])
