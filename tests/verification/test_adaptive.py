"""The error-controlled integrator against closed forms: tight tolerances must give tight results."""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import (
    G,
    Json,
    adaptive,
    body,
    contact,
    document,
    elliptic_k,
    end,
    free,
    hinge,
    period,
    point,
    rope,
    slider,
)
from one_rope import DROP_PEAK, GROUND, LIFT_OFF, LIFT_OFF_FACTOR, TAUT, WEIGHT, drop, lift_off, two_sheaves


def test_pulleys_are_exact() -> None:
    """T = 275 g/27, box −(2 g/27) t²/2, sheaves +(g/54) t²/2, to 1e-8."""
    run = adaptive(two_sheaves(), 5.0)
    assert run.tension("rope") == pytest.approx(np.full(len(run.time), 275 * G / 27), rel=1e-8)
    assert run.joint("box") == pytest.approx(-(G / 27) * run.time**2, rel=1e-8, abs=1e-12)
    assert run.joint("left") == pytest.approx((G / 108) * run.time**2, rel=1e-8, abs=1e-12)
    assert run.joint("right") == pytest.approx((G / 108) * run.time**2, rel=1e-8, abs=1e-12)


def pendulum_on_a_rope(ea: float | None) -> Json:
    length, amplitude = 5.0, 0.6
    start = (length * math.sin(amplitude), 0, -length * math.cos(amplitude))
    return document([body("m", point(start), 40.0)], ropes=[rope("r", length, [end(None), end("m")], ea)])


def test_pendulum_on_an_inextensible_rope() -> None:
    """Period 4 √(l/g) K(sin θ₀/2), and the length stays: no drift in 100 s."""
    exact = 4 * math.sqrt(5.0 / G) * elliptic_k(math.sin(0.3))
    run = adaptive(pendulum_on_a_rope(None), 100.0, tension_tolerance=1e-3, position_tolerance=1e-7)
    # Crossings are interpolated linearly between samples 10 ms apart: (10 ms)² ω²/8 of a sample, 1e-7.
    assert period(run.time, run.body("m")[:, 0]) == pytest.approx(exact, rel=1e-7)
    assert run.columns["residual_constraint"].max() < 1e-7
    energy = run.energy("kinetic") + run.energy("gravity")
    assert np.abs(energy).max() < 1e-5 * run.energy("kinetic").max()
    assert run.energy("method")[-1] == pytest.approx(-energy[-1], rel=0.1), "the audit knows the loss"


def test_observed_order() -> None:
    """Steps of order 5 under local error control: the error falls in proportion to the tolerance.

    Ten times the accuracy costs 10^(1/5) = 1.6 times the steps.
    """
    exact = 4 * math.sqrt(5.0 / G) * elliptic_k(math.sin(0.3))
    errors, steps = [], []
    for tolerance in (1.0, 0.1, 0.01):
        run = adaptive(
            pendulum_on_a_rope(None), 50.0, tension_tolerance=tolerance, position_tolerance=1e-4 * tolerance
        )
        errors.append(abs(period(run.time, run.body("m")[:, 0]) / exact - 1))
        steps.append(run.counters["steps"])
    assert errors[0] / errors[1] == pytest.approx(10, rel=0.3)
    assert errors[1] / errors[2] == pytest.approx(10, rel=0.3)
    assert steps[2] / steps[1] == pytest.approx(10**0.2, rel=0.1)


def test_slack_to_taut_drop() -> None:
    """A mass that falls h before an undamped rope goes taut: peak T = m g (1 + √(1 + 2 k h/(m g)))."""
    run = adaptive(drop(), 2.0, tension_tolerance=1e-2, position_tolerance=1e-8, sample_interval=1e-4)
    # Sampled peaks miss by (ω dt)²/8 = 1e-6.
    assert run.tension("r").max() == pytest.approx(DROP_PEAK, rel=2e-6)
    assert run.events("taut")[0][0] == pytest.approx(TAUT, abs=1e-7)
    # It is thrown back to where it came from.
    assert run.joint("m").max() == pytest.approx(0.0, abs=1e-6)
    assert run.energy_remainder < 1e-7


def test_impact_of_an_inextensible_rope() -> None:
    """A mass that falls h into an inextensible rope: m g h is lost in the impact, then T = m g."""
    mass, fall = 40.0, 1.0
    system = document(
        [body("m", point((0, 0, -4.0)), mass)], ropes=[rope("r", 4.0 + fall, [end(None), end("m")], None)]
    )
    run = adaptive(system, 2.0)
    ((taut, _),) = run.events("taut")
    assert taut == pytest.approx(math.sqrt(2 * fall / G), abs=1e-6)
    assert run.energy("impact")[-1] == pytest.approx(mass * G * fall, rel=1e-5)
    assert run.tension("r")[-1] == pytest.approx(mass * G, rel=1e-9)
    assert run.energy_remainder < 1e-8


def test_lift_off_at_constant_speed() -> None:
    """Hoisted off rigid ground at v by an undamped rope: dynamic factor 1 + v √(k/m)/g."""
    system = lift_off(depth=WEIGHT / GROUND)
    run = adaptive(system, 3.0, tension_tolerance=1.0, position_tolerance=1e-8, sample_interval=1e-3)
    # The ground gives way by m g/k = 1 µm: 2e-6 of the factor. The sampled peak misses by (ω dt)²/8 = 1e-5.
    assert run.tension("r").max() / WEIGHT == pytest.approx(LIFT_OFF_FACTOR, rel=2e-5)
    # The rope going taut sets the load ringing on the ground by k v/√(k_ground/m) = 237 N: 0.3 ms of lift.
    assert run.events("lift_off")[0][0] == pytest.approx(LIFT_OFF, abs=4e-4)


def test_torque_free_body() -> None:
    """Tumbling about the middle axis: energy and the angular momentum in space stay."""
    inertia = np.array([1.0, 2.0, 3.5])
    spin = [0.02, 3.0, 0.01]
    system = {
        "gravity": [0, 0, 0],
        "bodies": [body("b", free((0, 0, 0), angular_velocity=spin), 7.0, inertia=inertia.tolist())],
    }
    run = adaptive(system, 30.0, tension_tolerance=1e-6, position_tolerance=1e-9)
    kinetic = run.energy("kinetic")
    assert np.abs(kinetic / kinetic[0] - 1).max() < 1e-7
    local, momentum = run.spin("b", inertia)
    assert local[:, 1].min() < -2.5, "it must have turned over"
    assert np.abs(momentum - momentum[0]).max() < 1e-6 * np.linalg.norm(momentum[0])


def test_double_pendulum_of_hinges_keeps_its_energy() -> None:
    """A mass matrix that changes with the motion: large swings, energy kept to the tolerance."""
    system = document(
        [
            body("upper", hinge(position=1.5), 30.0, centre_of_gravity=(0, 0, -1.0), inertia=(2, 2, 1)),
            body(
                "lower",
                hinge(position=0.8),
                20.0,
                parent="upper",
                position=(0, 0, -2.0),
                centre_of_gravity=(0, 0, -1.0),
                inertia=(2, 2, 1),
            ),
        ]
    )
    run = adaptive(system, 20.0, tension_tolerance=1e-6, position_tolerance=1e-9)
    energy = run.energy("kinetic") + run.energy("gravity")
    assert np.abs(energy).max() < 1e-7 * run.energy("kinetic").max()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("tolerance", "bound"),
    [(None, 1e-2), (3e-3, 1e-5)],
    ids=["default tolerances, smooth motion", "tight tolerances, ringing ropes"],
)
def test_double_pendulum_on_elastic_ropes_for_1000_s(tolerance: float | None, bound: float) -> None:
    """30 t and 300 t on undamped ropes: loss in 1000 s against the energy above the minimum, and the audit's
    own figure of it.
    """
    ea, m1, m2, l1, l2, g = 1e9, 30e3, 300e3, 30.0, 20.0, G
    rings = 0.0 if tolerance is None else 0.01
    stretch1, stretch2 = (m1 + m2) * g * l1 / ea, m2 * g * l2 / ea
    angle = 0.1
    first = (l1 + stretch1) * np.array([math.sin(angle), 0, -math.cos(angle)])
    second = first + (l2 + stretch2 + rings) * np.array([math.sin(angle), 0, -math.cos(angle)])
    ropes = [rope("upper", l1, [end(None), end("a")], ea), rope("lower", l2, [end("a"), end("b")], ea)]
    system = document([body("a", point(first), m1), body("b", point(second), m2)], ropes=ropes)
    # Truncation: the loss follows the tolerance in metres, 1e-7: 1.1e-5, 5e-8: 5e-6, 1e-8: 5e-7 of the
    # energy.
    run = adaptive(
        system,
        1000.0,
        tension_tolerance=tolerance and tolerance * m2 * g,
        position_tolerance=tolerance and 5e-8,
        sample_interval=1.0,
    )
    stored = run.energy("kinetic") + run.energy("gravity") + run.energy("elastic")
    # Energy above that of hanging straight down at rest.
    lowest = -(m1 + m2) * g * (l1 + stretch1 / 2) - m2 * g * (l2 + stretch2 / 2)
    start = -m1 * g * -first[2] - m2 * g * -second[2] + run.energy("elastic")[0]
    above = start - lowest
    lost = stored[0] - stored[-1]
    assert abs(lost) < bound * above
    assert run.energy("method")[-1] == pytest.approx(lost, rel=0.1)


def test_box_slides_and_stops() -> None:
    """a = g (sin α − μ cos α) on a slope; v²/(2 μ g) on level ground, then it stays."""
    friction, speed, mass = 0.4, 1.5, 2000.0
    stiffness = 1e8
    half = (1.0, 0.8, 0.5)
    inertia = [
        mass / 3 * (a * a + b * b) for a, b in ((half[1], half[2]), (half[0], half[2]), (half[0], half[1]))
    ]
    law = {"stiffness": stiffness, "damping_time": 0.01, "friction": friction}
    corners = [(sx * half[0], sy * half[1], -half[2]) for sx in (-1, 1) for sy in (-1, 1)]
    start = free((0, 0, half[2] - mass * G / (4 * stiffness)), velocity=[speed, 0, 0])
    system = document(
        [body("box", start, mass, inertia=inertia)],
        contacts=[contact(f"c{k}", "box", at, **law) for k, at in enumerate(corners)],
    )
    run = adaptive(system, 2.0, tension_tolerance=0.1, position_tolerance=1e-7)
    x = run.body("box")[:, 0]
    # The box nods while it brakes and rides on tangential springs of 1e8 N/m: 0.1 % of the way.
    assert x[-1] == pytest.approx(speed**2 / (2 * friction * G), rel=2e-3)
    assert abs(x[-1] - x[-20]) < 1e-6
    assert run.energy("friction")[-1] == pytest.approx(0.5 * mass * speed**2, rel=1e-2)
    assert run.energy_remainder < 1e-4
    assert {"stick"} <= set(run.names["event_kind"])


def test_plan_conditions_are_located_exactly() -> None:
    """A step that waits for half of the weight ends when the contact carries half, not a step later."""
    mass, ea, speed, stiffness = 1e4, 1e7, 0.01, 1e7
    weight = mass * G
    system = document(
        [
            body("hook", slider(drive="hoist"), 0.0, position=(0, 0, 10.0)),
            body("load", slider(position=-weight / stiffness), mass),
        ],
        ropes=[rope("r", 10.0, [end("hook"), end("load")], ea, 0.01)],
        contacts=[contact("c", "load", (0, 0, 0), stiffness=stiffness, damping_time=0.01)],
        drives=[{"name": "hoist"}],
        plan=[
            {
                "name": "half",
                "moves": [{"drive": "hoist", "velocity": speed, "acceleration": 1.0}],
                "until": {"type": "load_transferred", "group": "load", "weight": weight, "at_least": 0.5},
            },
            {"name": "hold", "until": {"type": "end_of_run"}},
        ],
    )
    run = adaptive(system, 20.0, tension_tolerance=1e-2, position_tolerance=1e-9, sample_interval=0.01)
    (ended,) = [time for time, name in run.events("step_end") if name == "half"]
    share = 1 - run.columns["contact_force"][:, 0] / weight
    crossed = run.time[np.argmax(share >= 0.5)]
    # The drive brakes from the crossing within v/a = 10 ms, and that is the end of the step.
    assert ended - 0.01 == pytest.approx(crossed, abs=0.011)
    at_crossing = np.interp(ended - 0.01, run.time, share)
    assert at_crossing == pytest.approx(0.5, abs=1e-4)
