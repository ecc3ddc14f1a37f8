"""A crane that slews and luffs while it hoists, against Lagrange's equations of its points.

A base turns freely about a plumb axis, with friction of its bearing; a boom is hinged on it and held by a
luffing rope: from a drum over a sheave at the top of the A-frame to the boom head and in four parts
between both. The hoist rope runs from a drum over a sheave at the boom head, askew, to a load that is held
off its centre of gravity and swings. Both drums turn. `lagrange` knows where points are and how long ropes
are: with centre c, axis a and radius r of a sheave, w the way to a point less its part along a,

    u = (r w ± sqrt(w² − r²) a × w)/w²      length = |p₁ − (c + r u₁)| + r β + |p₂ − (c + r u₂)|

β the angle from u₁ to u₂ about a. What goes over the rim of a drum at the speed s' is stretched: L' =
s'/(1 + ε), of the rope as it is where it winds up, as it was at the start where that comes off again.
"""

from __future__ import annotations

from functools import partial

import numpy as np
from scipy.integrate import solve_ivp

from lagrange import (
    Batch,
    Lagrange,
    at,
    derivative,
    distance,
    of_bodies,
    six_points,
    spin,
    turned,
    yaw_pitch_roll,
)
from mechanics import (
    Floats,
    G,
    Json,
    adaptive,
    body,
    document,
    drum,
    end,
    eye,
    flow,
    free,
    hinge,
    rope,
    sheave,
)

NAMES = ("base", "boom", "load")
MASSES = (30e3, 8e3, 20e3)
CENTRES = np.array([[-1.5, 0.2, 2.0], [11.0, 0.1, 0.3], [0.0, 0.0, 0.0]])
INERTIAS = ((2e5, 2e5, 3e5), (5e3, 4.2e5, 4.2e5), (4e4, 7e4, 8e4))
PIN = (1.0, 0.0, 2.0)
TOP, TOP_EYE, HEAD_EYE = (-3.0, 0.2, 14.0), (-3.0, 0.2, 14.8), (24.5, 0.2, 0.6)
HEAD, SHACKLE = (25.0, 0.0, 0.0), (0.2, -0.1, 1.5)
DRUMS = {"hoist": (0.0, -0.3, 4.0), "luff": (-2.0, 0.2, 3.0)}
RADII = {"hoist": 0.6, "luff": 0.5}
EA = np.array([2e7, 4e7])
#: Tensions at the start [N].
TENSION = np.array([MASSES[2] * G * 1.02, 9e4])
#: Rope paid out by the drums of hoist and luffing [m/s], reached after `RAMP` [s]; bearing of the base [N m
#: s].
SPEED, RAMP, BEARING = np.array([-0.8, 0.5]), 0.2, 1e4
DURATION = 1.0
#: Slewing, luffing, place of the load and three angles of it.
START = np.array([0.3, 0.9, 0, 0, 0, 0.2, 0.1, -0.1])
VELOCITY = np.array([0.05, 0.01, 0.3, -0.2, 0.0, 0.05, 0.1, 0.02])


def frames(q: Batch) -> list[tuple[Batch, Batch]]:
    """Rotations and origins of base, boom and load over q (k, 8)."""
    base = (turned([0, 0, 1], q[:, 0]), np.zeros((len(q), 3)))
    boom = (base[0] @ turned([0, -1, 0], q[:, 1]), at([base], 0, PIN))
    return [base, boom, (yaw_pitch_roll(q[:, 5:]), q[:, 2:5])]


START[2:5] = at(frames(START[None]), 1, HEAD)[0] + [1.0, 1.5, -15.0]
POINTS = [six_points(m, c, np.diag(i)) for m, c, i in zip(MASSES, CENTRES, INERTIAS, strict=True)]


def points(q: Batch) -> Batch:
    """Six of each body (k, 18, 3) [m]."""
    return of_bodies(frames(q), POINTS)


def over(first: Batch, sheave_at: Batch, axis: Batch, radius: float, last: Batch) -> Batch:
    """Length from a point over a sheave to a point (k,) [m], wrapped by less than π."""

    def touching(place: Batch, sign: float) -> Batch:
        way = place - sheave_at
        way = way - (way * axis).sum(-1)[:, None] * axis
        square = (way * way).sum(-1)[:, None]
        tangent = sign * np.sqrt(square - radius**2) * np.cross(axis, way)
        return np.asarray((radius * way + tangent) / square)

    on, off = touching(first, 1.0), touching(last, -1.0)
    cosine = (on * off).sum(-1)
    ends = distance(first, sheave_at + radius * on) + distance(sheave_at + radius * off, last)
    return np.asarray(ends + radius * np.arccos(cosine))


def lengths(q: Batch) -> Batch:
    """Of the ways of hoist and luffing rope (k, 2) [m]."""
    placed = frames(q)
    axis = placed[0][0][:, :, 1]
    head, top_eye, head_eye = at(placed, 1, HEAD), at(placed, 0, TOP_EYE), at(placed, 1, HEAD_EYE)
    hoist = over(at(placed, 0, DRUMS["hoist"]), head, axis, RADII["hoist"], at(placed, 2, SHACKLE))
    luff = over(at(placed, 0, DRUMS["luff"]), at(placed, 0, TOP), axis, RADII["luff"], head_eye)
    return np.stack([hoist, luff + 3 * distance(head_eye, top_eye)], axis=1)


def force(_: float, q: Floats, v: Floats, unstretched: Floats) -> Floats:
    """Of ropes and of the bearing of the base."""
    length, gradient = derivative(lengths, q)
    pull = -(EA * (length / unstretched - 1.0)) @ gradient
    pull[0] -= BEARING * v[0]
    return np.asarray(pull)


def rates(time: float, state: Floats) -> Floats:
    """Of q, q̇ and unstretched lengths."""
    unstretched = state[16:]
    own = Lagrange(np.repeat(MASSES, 6) / 6, points, partial(force, unstretched=unstretched))
    wound = lengths(state[None, :8])[0] / unstretched
    wound[1] = 1.0 + TENSION[1] / EA[1]
    supply = SPEED * min(time / RAMP, 1.0) / wound
    return np.concatenate([own.rates(time, state[:16]), supply])


def system(unstretched: Floats) -> Json:
    """The same as a document."""
    turn, spinning = spin(yaw_pitch_roll, START[5:], VELOCITY[5:])
    joints = [
        hinge((0, 0, 1), position=START[0], velocity=VELOCITY[0], damping=BEARING),
        hinge((0, -1, 0), position=START[1], velocity=VELOCITY[1]),
        free(
            START[2:5].tolist(), velocity=VELOCITY[2:5].tolist(), orientation=turn, angular_velocity=spinning
        ),
    ]
    bodies = [
        body(
            name,
            joints[k],
            MASSES[k],
            parent="base" if name == "boom" else None,
            position=PIN if name == "boom" else (0, 0, 0),
            centre_of_gravity=CENTRES[k].tolist(),
            inertia=INERTIAS[k],
        )
        for k, name in enumerate(NAMES)
    ]
    routes = {
        "hoist": [sheave("boom", HEAD, (0, 1, 0), RADII["hoist"]), end("load", SHACKLE)],
        "luff": [
            sheave("base", TOP, (0, 1, 0), RADII["luff"]),
            eye("boom", HEAD_EYE),
            eye("base", TOP_EYE),
            eye("boom", HEAD_EYE),
            end("base", TOP_EYE),
        ],
    }
    ropes = [
        rope(name, float(length), [drum("base", DRUMS[name], f"{name}.drum"), *routes[name]], float(ea))
        for name, length, ea in zip(routes, unstretched, EA, strict=True)
    ]
    drives = [
        {"name": name, "ramps": [{"at": 0.0, "duration": RAMP, "velocity": float(speed)}]}
        for name, speed in zip(routes, SPEED, strict=True)
    ]
    turning = [flow(f"{name}.drum", 1.0, drive=name) for name in routes]
    return document([*bodies, *turning], ropes=ropes, drives=drives)


def test_a_crane_that_slews_luffs_and_hoists_moves_as_lagrange_says() -> None:
    """Centres of gravity, tensions, and the turning of the base that the load swings along with it."""
    unstretched = lengths(START[None])[0] / (1.0 + TENSION / EA)
    times = np.linspace(0, DURATION, 11)
    state = np.concatenate([START, VELOCITY, unstretched])
    own = []
    # The speed of the drums has a kink at the end of the ramp.
    for begin, stop in ((0.0, RAMP), (RAMP, DURATION)):
        within = times[(times > begin + 1e-9) & (times <= stop + 1e-9)].clip(max=stop)
        found = solve_ivp(rates, (begin, stop), state, "DOP853", within, rtol=1e-8, atol=1e-10)
        own.append(found.y.T)
        state = found.y[:, -1]
    course = np.concatenate(own)
    run = adaptive(
        system(unstretched),
        DURATION,
        tension_tolerance=1e-1,
        position_tolerance=1e-8,
        sample_interval=DURATION / 10,
    )
    placed = frames(course[:, :8])
    for k, name in enumerate(NAMES):
        # Tolerances of 10 nm and 0.1 N in a step; found is 1e-8 m.
        assert np.abs(at(placed, k, CENTRES[k]) - run.body(name)[1:]).max() < 1e-7
    tension = EA * (lengths(course[:, :8]) / course[:, 16:] - 1.0)
    for k, name in enumerate(DRUMS):
        # 0.1 µm of 2e5 N/m, and the tolerance.
        assert np.abs(tension[:, k] - run.tension(name)[1:]).max() < 1.0
    assert tension.min() > 0.0, "ropes must stay taut, slack is not in the law above"
    fleet = np.abs(run.columns["fleet_angle"]).max()
    assert fleet > 0.01, "the hoist rope must run askew"
    assert run.energy_remainder < 1e-11
