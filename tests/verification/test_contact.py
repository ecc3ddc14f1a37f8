"""Contact with the ground and Coulomb friction against closed forms, integrator `del`."""

from __future__ import annotations

import math

import numpy as np
import pytest

from mechanics import G, Json, body, contact, document, free, simulate, slider

MASS = 2000.0
HALF = (1.0, 0.8, 0.5)
INERTIA = tuple(
    MASS / 3 * (a * a + b * b) for a, b in ((HALF[1], HALF[2]), (HALF[0], HALF[2]), (HALF[0], HALF[1]))
)


def box_on_slope(slope: float, friction: float, stiffness: float = 1e7) -> Json:
    """A box on a plane inclined by `slope` towards +x, at rest on its springs."""
    normal = (math.sin(slope), 0, math.cos(slope))
    depth = MASS * G * math.cos(slope) / (4 * stiffness)
    height = HALF[2] - depth
    turned = [math.cos(slope / 2), 0, math.sin(slope / 2), 0]
    corners = [(sx * HALF[0], sy * HALF[1], -HALF[2]) for sx in (-1, 1) for sy in (-1, 1)]
    law = {"stiffness": stiffness, "damping_time": 0.01, "friction": friction, "plane_normal": list(normal)}
    start = free([height * x for x in normal], orientation=turned)
    return document(
        [body("box", start, MASS, inertia=INERTIA)],
        contacts=[contact(f"c{k}", "box", at, **law) for k, at in enumerate(corners)],
    )


def test_box_sticks_on_a_slope_below_the_friction_angle() -> None:
    """tan 0.25 = 0.255 < μ = 0.3: after settling nothing moves, not in an hour's share of steps."""
    run = simulate(box_on_slope(0.25, 0.3), 60.0, step=5e-3, sample_interval=1.0)
    settled = run.body("box")[2:]
    assert np.abs(settled - settled[0]).max() < 1e-9
    # Statics: normal forces sum to m g cos α.
    assert run.columns["contact_force"][-1].sum() == pytest.approx(MASS * G * math.cos(0.25), rel=1e-9)


def test_box_slides_on_a_slope_above_the_friction_angle() -> None:
    """a = g (sin α − μ cos α)."""
    slope, friction = 0.4, 0.3
    run = simulate(box_on_slope(slope, friction), 3.0, sample_interval=0.01)
    along = run.body("box") @ np.array([math.cos(slope), 0, -math.sin(slope)])
    velocity = np.gradient(along, run.time)
    a = np.polyfit(run.time[50:], velocity[50:], 1)[0]
    assert a == pytest.approx(G * (math.sin(slope) - friction * math.cos(slope)), rel=1e-3)
    lost = friction * MASS * G * math.cos(slope) * (along[-1] - along[0])
    assert run.energy("friction")[-1] == pytest.approx(lost, rel=5e-3)
    assert run.energy_remainder < 1e-3


def test_sliding_box_stops_after_its_braking_distance() -> None:
    """v²/(2 μ g) on level ground, then stays."""
    friction, speed = 0.4, 1.5
    system = box_on_slope(0.0, friction)
    system["bodies"][0]["joint"]["velocity"] = [speed, 0, 0]
    run = simulate(system, 2.0, step=2e-4, sample_interval=0.01)
    x = run.body("box")[:, 0]
    assert x[-1] == pytest.approx(speed**2 / (2 * friction * G), rel=2e-3)
    assert abs(x[-1] - x[-20]) < 1e-6
    assert {kind for kind in run.names["event_kind"]} >= {"stick"}


def test_four_corners_share_a_weight_off_centre() -> None:
    """Rigid box on four equal springs: linear distribution of force, N = W/4 (1 ± e/a)."""
    system = box_on_slope(0.0, 0.5)
    offset = 0.3
    box = system["bodies"][0]
    for corner in system["contacts"]:
        corner["at"][0] -= offset  # the centre of gravity lies 0.3 m towards +x of the middle
    run = simulate(system, 20.0, step=2e-3, sample_interval=1.0)
    force = run.columns["contact_force"][-1]
    weight = box["mass"] * G
    expected = [weight / 4 * (1 + sign * offset / HALF[0]) for sign in (-1, -1, 1, 1)]
    # The tilt of 0.3 mm/m moves the centre of gravity by less than 0.02 % of the offset.
    assert force == pytest.approx(expected, rel=2e-4)


def test_dropped_mass_leaves_the_ground_again_without_loss() -> None:
    """Undamped contact: a dropped mass bounces back to where it came from, loss only by the method."""
    system = document(
        [body("m", slider(position=0.2), 10.0)],
        contacts=[contact("c", "m", (0, 0, 0), stiffness=1e5)],
    )
    rises = []
    for step in (1e-4, 5e-5):
        run = simulate(system, 0.6, step=step)
        after = run.joint("m")[run.time > math.sqrt(2 * 0.2 / G) + 0.1]
        rises.append(0.2 - after.max())
        assert run.energy_remainder < 1e-9
        assert abs(run.energy("contact_damping")[-1]) < 1e-12
    # ω = √(k/m) = 100 rad/s: half a period of contact loses h ω π of the energy.
    assert rises[1] == pytest.approx(5e-5 * 100 * math.pi * 0.2, rel=0.1)
    assert rises[0] / rises[1] == pytest.approx(2, rel=0.15)
    assert np.all(run.columns["contact_force"] >= 0)
