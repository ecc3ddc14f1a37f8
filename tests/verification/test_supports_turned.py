"""Loads on supports that have been turned: on their ends, on their heads, and over an edge."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from box_on_tops import DAMPED, INERTIA, MASS, SIZE, STIFFNESS, force, support, turn
from hull_lift import shares_of_springs
from mechanics import Floats, G, Run, adaptive, body, document, free, simulate

#: Which side is down: quaternions that take it there.
DOWN = {
    "-z": turn(0, 0.0),
    "+z": turn(0, math.pi),
    "+x": turn(1, math.pi / 2),
    "-x": turn(1, -math.pi / 2),
    "-y": turn(0, math.pi / 2),
    "+y": turn(0, -math.pi / 2),
}


@pytest.mark.parametrize("run", [adaptive, simulate])
@pytest.mark.parametrize("side", DOWN)
def test_a_load_stands_on_each_of_its_sides(side: str, run: Callable[..., Run]) -> None:
    """Four supports of unlike stiffness under the side that is down share the weight as a rigid plate does.

    It starts 1 mm above them and has settled after 3 s: sinking is damped by √(Σk/m) τ/2 = 0.9 of critical,
    tilting, over levers of 0.8 m, by more than half of that. Tilts are of 0.2 mrad: what they move is below
    1e-3 of the forces.
    """
    places = np.array([(-0.9, -0.8), (0.7, -0.9), (1.0, 0.6), (-0.6, 1.0)])
    stiffness = STIFFNESS * np.array([1.0, 0.5, 1.5, 1.0])
    names = [f"p{number}" for number in range(len(places))]
    supports = [support(name, *at, stiffness=k) for name, at, k in zip(names, places, stiffness, strict=True)]
    high = SIZE["xyz".index(side[1])] / 2 + 1e-3
    box = body("box", free((0, 0, high), orientation=DOWN[side]), mass=MASS, inertia=INERTIA)
    done = run(document([box], supports=supports), 3.0)
    expected = shares_of_springs(places, stiffness, np.zeros(4), MASS * G, np.zeros(2))
    assert [force(done, name)[-1] for name in names] == pytest.approx(expected, rel=1e-3)
    assert (expected > 0).all()


def tumbling(t: float, y: Floats) -> Floats:
    """Rates of place, angle and their speeds, and of the spring along the ground, of a box on its edge."""
    (_, z, angle), (vx, vz, spin), stretched = y[:3], y[3:6], y[6]
    # The edge from the centre of gravity, turned about y: x' = x cos + z sin, z' = z cos − x sin.
    x0, z0 = SIZE[0] / 2, -SIZE[2] / 2
    arm = np.array([x0 * math.cos(angle) + z0 * math.sin(angle), z0 * math.cos(angle) - x0 * math.sin(angle)])
    slides, sinks = vx + spin * arm[1], vz - spin * arm[0]
    stiff = 2 * STIFFNESS
    pressed = stiff * (-(z + arm[1]) - DAMPED * sinks)
    along = -stiff * (stretched + DAMPED * slides)
    assert pressed > 0 and abs(along) < 2.0 * pressed  # it neither lifts nor slips
    moment = arm[1] * along - arm[0] * pressed
    return np.array([vx, vz, spin, along / MASS, pressed / MASS - G, moment / INERTIA[1], slides])


def tumbled(run: Callable[..., Run]) -> float:
    """By how much place [m] or angle [rad] of a box that turns over an edge on supports are off at most."""
    edge = np.array([SIZE[0] / 2, 0.0, -SIZE[2] / 2])
    start, spin = math.radians(30), 1.0
    c, s = math.cos(start), math.sin(start)
    arm = np.array([edge[0] * c + edge[2] * s, 0.0, edge[2] * c - edge[0] * s])
    place = -arm - (0.0, 0.0, MASS * G / (2 * STIFFNESS))
    velocity = np.array([-spin * arm[2], 0.0, spin * arm[0]])
    joint = free(
        (place[0], place[1], place[2]),
        orientation=turn(1, start),
        velocity=velocity.tolist(),
        angular_velocity=[0.0, spin, 0.0],
    )
    supports = [support("left", 0.0, 1.2, friction=2.0), support("right", 0.0, -1.2, friction=2.0)]
    box = body("box", joint, mass=MASS, inertia=INERTIA)
    done = run(document([box], supports=supports), 1.0)
    y = np.array([place[0], place[2], start, velocity[0], velocity[2], spin, 0.0])
    own = solve_ivp(tumbling, (0, 1.0), y, "LSODA", done.time, rtol=1e-10, atol=1e-12).y
    assert math.degrees(own[2, -1]) > 62.0
    w, _, turned, _ = done.body("box", "body_orientation").T
    ours = np.stack([*done.body("box")[:, [0, 2]].T, 2 * np.arctan2(turned, w)])
    return float(np.abs(ours - own[:3]).max())


def test_a_load_turns_over_an_edge_that_stands_on_supports() -> None:
    """From 30° to over 60°, over the top at atan(3.0/2.6) = 49°, against its equations of motion.

    Steeper than 60° a side lies on nothing: at 30° the other side comes under it, at 60° the first goes. The
    edge is where it is at every angle, so that no place is behind: what is left is the integrator's error.
    """
    assert tumbled(adaptive) < 1e-4


def test_del_comes_nearer_with_its_step() -> None:
    """Contacts that damp are of first order in its step: half of the step has half of the error."""
    coarse, fine = (tumbled(partial(simulate, step=step)) for step in (1e-3, 5e-4))
    assert coarse / fine == pytest.approx(2.0, abs=0.1)
    assert abs(2 * fine - coarse) < 1e-4
