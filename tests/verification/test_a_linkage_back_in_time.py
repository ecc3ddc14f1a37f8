"""What loses nothing goes back by the way it came: a linkage with a load on slings, turned round half-way.

Without dampers and friction the equations of motion are the same for q(t) and q(−t) (Lamb and Roberts,
Physica D 112, 1998). So a run from the end of another, all speeds the other way, has the places of that one
in reverse, tensions alike and speeds with the other sign. It needs no model of the linkage.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from mechanics import Floats, Json, Run, adaptive, body, document, end, free, hinge, rope
from rigid import axes

#: Hinges of both bars in the world, and the pins of the coupler on these [m].
HINGES = {"a": (0.0, 0.0, 3.0), "b": (2.0, 0.0, 3.0)}
PINS = {"a": (0.0, 0.0, -1.0), "b": (0.0, 0.0, -1.4)}
#: Bar, place on it, place on the load; none symmetric to another, so that the load goes every way it can.
SLINGS = (
    ("s1", "a", (0.0, 0.0, -1.0), (-0.5, 0.2, 0.2)),
    ("s2", "b", (0.0, 0.0, -1.4), (0.5, 0.1, 0.2)),
    ("s3", "a", (0.0, 0.1, -0.6), (-0.4, -0.3, 0.2)),
)
#: Of the slings [N]: 30 kg on 20 kN stretch them by some per cent.
EA = 2e4
DURATION, SAMPLE = 2.0, 0.05
#: Angles and speeds of the bars, and of the load, in its own axes its spin.
START: dict[str, Any] = {
    "a": {"position": -0.7, "velocity": 0.0},
    "b": {"position": 0.6, "velocity": 0.0},
    "load": {
        "position": [1.0, 0.15, -0.9],
        "orientation": (np.array([0.995, 0.05, 0.02, 0.08]) / math.sqrt(0.999325)).tolist(),
        "velocity": [0.0, 0.3, 0.0],
        "angular_velocity": [0.1, 0.2, -0.4],
    },
}


def length(bar: str, at: tuple[float, ...], lug: tuple[float, ...]) -> float:
    """From a place on a bar to one on the load at the start [m]."""
    angle, load = START[bar]["position"], START["load"]
    turned = np.array(
        [
            [math.cos(angle), 0.0, math.sin(angle)],
            [0.0, 1.0, 0.0],
            [-math.sin(angle), 0.0, math.cos(angle)],
        ]
    )
    below = np.array(load["position"]) + axes(np.array(load["orientation"])) @ lug
    return float(np.linalg.norm(np.array(HINGES[bar]) + turned @ at - below))


def linkage(start: dict[str, Any], damped: float) -> Json:
    """Two bars, their pins joined by a rope without stretch, and a load on slings that are a little short."""
    bodies = [
        body("a", hinge(**start["a"]), 10.0, position=HINGES["a"], centre_of_gravity=(0, 0, -0.5),
             inertia=(0.8, 0.9, 0.1)),
        body("b", hinge(**start["b"]), 8.0, position=HINGES["b"], centre_of_gravity=(0, 0, -0.7),
             inertia=(1.2, 1.3, 0.1)),
        body("load", free(**start["load"]), 30.0, inertia=(3.0, 5.0, 6.0)),
    ]  # fmt: skip
    coupler = rope("coupler", None, [end(name, at) for name, at in PINS.items()], None)
    slings = [
        rope(name, 0.997 * length(bar, at, lug), [end(bar, at), end("load", lug)], EA, damped)
        for name, bar, at, lug in SLINGS
    ]
    return document(bodies, ropes=[coupler, *slings])


def turned_round(run: Run) -> dict[str, Any]:
    """The state in which it ended, all speeds the other way."""
    attitude = run.body("load", "body_orientation")[-1]
    bars = {
        name: {
            "position": float(run.joint(name)[-1]),
            "velocity": -float(run.body(name, "body_angular_velocity")[-1, 1]),
        }
        for name in HINGES
    }
    spin = axes(attitude).T @ run.body("load", "body_angular_velocity")[-1]
    load = {
        "position": run.body("load")[-1].tolist(),
        "orientation": attitude.tolist(),
        "velocity": (-run.body("load", "body_velocity")[-1]).tolist(),
        "angular_velocity": (-spin).tolist(),
    }
    return {**bars, "load": load}


def apart(damped: float) -> tuple[Run, list[float]]:
    """A run, and how far one back from its end is off it: place [m], speed [m/s], angle [rad], force [N]."""

    def go(start: dict[str, Any]) -> Run:
        return adaptive(
            linkage(start, damped),
            DURATION,
            tension_tolerance=1e-4,
            position_tolerance=1e-8,
            sample_interval=SAMPLE,
        )

    there = go(START)
    back = go(turned_round(there))

    def off(one: Floats, other: Floats, sign: float = 1.0) -> float:
        return float(np.abs(other[::-1] - sign * one).max())

    def both(of: Any, sign: float = 1.0) -> float:
        return off(of(there), of(back), sign)

    found = [
        both(lambda run: run.body("load")),
        both(lambda run: run.body("load", "body_velocity"), -1.0),
        max(both(lambda run, name=name: run.joint(name)) for name in HINGES),
        max(both(lambda run, name=name: run.tension(name)) for name in ("coupler", "s1", "s2", "s3")),
    ]
    return there, found


def test_it_goes_back_by_the_way_it_came() -> None:
    """Two seconds there and back, in which slings get slack and taut, and the load goes half a metre.

    A step leaves 1e-8 m, which by as much in each of some hundred steps, one way or the other, comes to
    1e-7 m. Speeds and tensions follow from places by the frequency of the load on a sling,
    ω = √(EA/L m) = 16 rad/s, and by its stiffness, EA/L = 7.7 kN/m with the shortest of 2.6 m.
    """
    there, (place, speed, angle, force) = apart(0.0)
    assert there.events("slack") and there.events("taut")
    assert np.ptp(there.body("load")[:, 0]) > 0.5
    assert place < 1e-7 and angle < 1e-7
    assert speed < 16 * 1e-7
    assert force < 7.7e3 * 1e-7


def test_dampers_do_not_give_back_what_they_took() -> None:
    """The same with slings that damp, τ = 1 ms: the way back is another one, by far more than the bounds."""
    _, (place, *_) = apart(1e-3)
    assert place > 1e-4
