"""The integrator `explicit` against closed forms."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from mechanics import (
    G,
    Json,
    adaptive,
    body,
    contact,
    document,
    drum,
    end,
    finished,
    flow,
    hinge,
    rope,
    simulate,
    simulation,
    slider,
)

MASS, EA, LENGTH = 1000.0, 1e7, 10.0
K = EA / LENGTH
OMEGA = math.sqrt(K / MASS)
DROPPED = Path(__file__).resolve().parents[2] / "crates" / "gantline-core" / "tests" / "dropped_load.json"


def hanging(damping_time: float, speed: float = 0.01) -> Json:
    """A mass at rest on a rope, set off with a speed [m/s]."""
    return document(
        [body("m", slider(velocity=speed), MASS, position=(0, 0, -MASS * G / K))],
        ropes=[rope("r", LENGTH, [end(None, (0, 0, LENGTH)), end("m")], EA, damping_time)],
    )


def limit(damping_time: float) -> float:
    """Longest stable step [s]: h²ω² + 2hω²τ = 4."""
    return -damping_time + math.sqrt(damping_time**2 + 4 / OMEGA**2)


def test_the_map_of_a_step() -> None:
    """v₊ = v - hω²(y + τv), y₊ = y + h v₊, y the stretch beyond that at rest: rounding of 10 m is all."""
    h, tau = 5e-3, 2e-3
    run = simulate(hanging(tau), 1.0, step=h, type="explicit")
    y, v, wanted = 0.0, 0.01, []
    for _ in run.time:
        wanted.append(y)
        v -= h * OMEGA**2 * (y + tau * v)
        y += h * v
    assert run.tension("r").min() > 0
    assert np.abs(run.joint("m") - wanted).max() < 1e-9 * np.abs(wanted).max()
    assert run.energy_remainder < 1e-12


@pytest.mark.parametrize("damping_time", [0.0, 0.01])
def test_stable_below_the_limit_unstable_above(damping_time: float) -> None:
    """λ = -1 at the limit h²ω² + 2hω²τ = 4. Below it the motion stays bounded: undamped by

    1/√(1 - (hω/2)²) times that of the mass, 7 times at 1 % below. 1 % above it it grows past that, and
    the run ends before 200 steps: the method has put in half as much energy as the rope holds.
    """
    h = limit(damping_time)
    below = simulate(hanging(damping_time), 200 * h, step=0.99 * h, type="explicit")
    bound = 0.01 / OMEGA / math.sqrt(1 - 0.99**2)
    assert np.abs(below.joint("m")).max() <= 1.001 * bound
    begun = simulation(hanging(damping_time, 1e-3), 200 * h, step=1.01 * h, type="explicit")
    status = begun.run()
    assert status["status"] == "failed" and status["element"] == "m"
    assert "the method has put in" in status["cause"]
    above = finished(begun, status)
    assert np.abs(above.joint("m")).max() > bound
    assert above.energy("method")[-1] < 0, "the books say that the method feeds it"


def test_the_frequency_of_the_scheme() -> None:
    """Undamped, y = h v₀ sin(nθ)/sin θ with cos θ = 1 - (hω)²/2: higher than ω, and no amplitude is lost."""
    h = 0.3 / OMEGA
    run = simulate(hanging(0.0), 2000 * h, step=h, type="explicit")
    theta = math.acos(1 - (h * OMEGA) ** 2 / 2)
    wanted = h * 0.01 * np.sin(theta * np.arange(len(run.time))) / math.sin(theta)
    # Rounding of 10 m in 0.3 mm, and what 2000 steps make of it.
    assert np.abs(run.joint("m") - wanted).max() < 1e-9 * np.abs(wanted).max()


def test_a_step_that_is_far_too_long_ends_the_run_with_its_cause() -> None:
    """The mass is thrown ever higher, until it passes all bounds."""
    run = simulation(hanging(0.01), 1e4, step=10 * limit(0.01), sample_interval=100.0, type="explicit")
    status = run.run()
    assert status["status"] == "failed"
    assert status["element"] == "m"
    assert "too long for an explicit method" in status["cause"]


def test_books_close_with_the_square_of_the_step() -> None:
    """Ropes go slack, a drive hoists, corners slide: the remainder falls by 4 when h halves."""
    system = json.loads(DROPPED.read_text())
    remainders = []
    for step in (1e-3, 5e-4):
        run = simulate(system, 3.0, step=step, type="explicit")
        remainders.append(run.energy_remainder)
        assert np.all(np.diff(run.energy("friction")) > -1e-3 * run.energy("friction")[-1])
        assert run.energy("friction")[-1] > 100
    assert remainders[0] < 1e-7
    assert remainders[0] / remainders[1] == pytest.approx(4, rel=0.2)


def test_the_dropped_load_agrees_with_adaptive() -> None:
    """First order: the load's place at the end is off by less than 2 mm at 0.25 ms, less than by 0.5 ms."""
    system = json.loads(DROPPED.read_text())
    exact = adaptive(system, 1.0, tension_tolerance=None, position_tolerance=None)
    name = exact.names["body"][-1]
    apart = []
    for step in (5e-4, 2.5e-4):
        run = simulate(system, 1.0, step=step, type="explicit")
        apart.append(float(np.linalg.norm(run.body(name)[-1] - exact.body(name)[-1])))
    assert apart[1] < 2e-3
    assert apart[1] < 0.75 * apart[0]


def test_a_double_pendulum_swings_like_that_of_adaptive() -> None:
    """Velocity terms of a tree: first order in the step."""
    system = document(
        [
            body("upper", hinge(position=1.0), 3.0, centre_of_gravity=(0, 0, -0.5), inertia=(0.3, 0.3, 0.1)),
            body(
                "lower",
                hinge(position=0.5),
                2.0,
                parent="upper",
                position=(0, 0, -1.0),
                centre_of_gravity=(0, 0, -0.4),
                inertia=(0.2, 0.2, 0.1),
            ),
        ]
    )
    exact = adaptive(system, 2.0, sample_interval=0.1)
    errors = []
    for step in (1e-3, 5e-4):
        run = simulate(system, 2.0, step=step, sample_interval=0.1, type="explicit")
        errors.append(np.abs(run.joint("lower") - exact.joint("lower")).max())
        assert run.energy_remainder < 2e-6
    assert errors[0] / errors[1] == pytest.approx(2, rel=0.1)


def test_a_driven_joint_is_where_its_drive_is() -> None:
    """A hook that hoists a hanging mass: place by the ramp, work of the drive what the mass gains."""
    system = document(
        [
            body("hook", slider(drive="hoist"), 0.0, position=(0, 0, LENGTH)),
            body("m", slider(), MASS, position=(0, 0, -MASS * G / K)),
        ],
        ropes=[rope("r", LENGTH, [end("hook"), end("m")], EA, 2e-3)],
        drives=[{"name": "hoist", "ramps": [{"at": 0.0, "duration": 1.0, "velocity": 0.5}]}],
    )
    run = simulate(system, 3.0, type="explicit")
    assert run.joint("hook")[-1] == pytest.approx(0.25 + 2 * 0.5, abs=1e-12)
    gained = run.energy("kinetic")[-1] + run.energy("gravity")[-1] + np.ptp(run.energy("elastic")[[0, -1]])
    lost = run.energy("rope_damping")[-1] + run.energy("method")[-1]
    assert run.energy("drive_work")[-1] == pytest.approx(gained + lost, rel=1e-4)
    assert run.energy_remainder < 1e-9


def test_friction_holds_by_its_anchor_and_slides_by_coulomb() -> None:
    """On the level, pushed off at v: it comes to rest after v²/(2μg), first order in the step."""
    friction, speed = 0.4, 2.0
    system = document(
        [
            {
                **body(
                    "sledge",
                    {"type": "point", "position": [0, 0, -G * 10 / 1e6], "velocity": [speed, 0, 0]},
                    10.0,
                ),
            }
        ],
        contacts=[contact("c", "sledge", (0, 0, 0), stiffness=1e6, damping_time=1e-3, friction=friction)],
    )
    run = simulate(system, 1.0, step=1e-4, type="explicit")
    way = speed**2 / (2 * friction * G)
    assert run.body("sledge")[-1, 0] == pytest.approx(way, rel=1e-3)
    assert np.abs(run.body("sledge", "body_velocity")[-1]).max() < 1e-6, "it sticks, and does not creep"
    assert run.energy("friction")[-1] == pytest.approx(0.5 * 10 * speed**2, rel=1e-2)
    assert [kind for kind in run.names["event_kind"]] == ["slip", "stick"]


def test_a_saved_run_goes_on_with_the_same_bytes() -> None:
    """Nothing but the state says how a run goes on."""
    system = json.loads(DROPPED.read_text())
    whole = simulation(system, 2.0, type="explicit")
    whole.run()
    first, second = (simulation(system, 2.0, type="explicit") for _ in range(2))
    first.run(None, 0.7)
    second.restore(first.save())
    second.run()
    for name, values in whole.columns().items():
        assert np.array_equal(values, second.columns()[name]), name


def test_what_it_cannot_do_is_refused() -> None:
    """Inextensible ropes and brakes, by name and with what would be right."""
    system = hanging(0.0)
    system["ropes"][0]["material"] = {"type": "inextensible"}
    system["ropes"][0]["length"] = LENGTH + 1
    with pytest.raises(
        ValueError, match="r is inextensible; give it an axial stiffness, or use adaptive or del"
    ):
        simulate(system, 1.0, type="explicit")
    braked = document(
        [body("m", slider(), MASS), flow("winch", 10.0, brake=1e5)],
        ropes=[rope("r", LENGTH, [drum(None, (0, 0, LENGTH), "winch"), end("m")], EA)],
    )
    with pytest.raises(
        ValueError, match="no friction of sheaves, drums and joints, such as that of winch; use adaptive"
    ):
        simulate(braked, 1.0, type="explicit")
