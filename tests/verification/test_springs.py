"""Ropes that start stretched, as springs do, against equations of their own."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import gantline

G, MASS, STIFFNESS, LENGTH = 9.81, 10.0, 2000.0, 1.5
START = (1.0, -1.5)  # x and z of the bob [m]: 1.803 m from its pivot, 20 % more than the rope


def _pendulum(**rope: Any) -> gantline.Scenario:
    """A bob on an elastic rope, let go where the rope is stretched by 20 %."""
    route = [{"type": "end", "body": "world"}, {"type": "end", "body": "bob"}]
    return gantline.parse_scenario(
        {
            "format": 1,
            "lift": {"title": "Elastic pendulum"},
            "duration": "5 s",
            "ropes": {"spring": {"axial_stiffness": f"{STIFFNESS} N"}},
            "mechanics": {
                "bodies": {
                    "bob": {
                        "at": [f"{START[0]} m", 0, f"{START[1]} m"],
                        "joint": {"type": "point"},
                        "mass": f"{MASS} kg",
                    }
                },
                "ropes": {"spring": {"rope": "spring", "length": f"{LENGTH} m", "route": route} | rope},
            },
        }
    )


def _exact(times: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """x, z and tension of the elastic pendulum, m r'' = -T r/|r| - m g, T = max(0, EA (|r|/L - 1))."""

    def pull(place: np.ndarray[Any, Any]) -> Any:
        return np.maximum(0.0, STIFFNESS * (np.hypot(*place) / LENGTH - 1.0))

    def rate(_: float, state: np.ndarray[Any, Any]) -> list[float]:
        place = state[:2]
        x, z = -pull(place) * place / np.hypot(*place) / MASS
        return [*state[2:], x, z - G]

    found = solve_ivp(rate, times[[0, -1]], [*START, 0, 0], "DOP853", times, rtol=1e-12, atol=1e-12)
    return np.vstack([found.y[:2], pull(found.y[:2])])


@pytest.mark.parametrize("finer", [1.0, 1e-2, 1e-4])
def test_an_elastic_pendulum_that_starts_stretched(finer: float) -> None:
    """Elastic pendulum let go at 20 % of stretch: path and tension of its own equations."""
    tension, position = 0.1 * finer, 1e-4 * finer
    run = gantline.simulate(_pendulum(stretched=True), tension_tolerance=tension, position_tolerance=position)
    x, z, pull = _exact(run.time)
    path = run.column("body_position", "bob")
    # Tolerances are of one step; 45 to 173 of them add up to a few. EA/L is 1333 N/m.
    assert np.abs(path[:, [0, 2]].T - [x, z]).max() < 10 * position
    assert np.abs(run.column("rope_tension", "spring") - pull).max() < 5 * 1300 * position
    assert run.column("rope_tension", "spring")[0] == pytest.approx(
        STIFFNESS * (np.hypot(*START) / LENGTH - 1), rel=1e-12
    )


def test_a_spring_over_a_sheave_starts_stretched() -> None:
    """Spring over a sheave of 0.4 m, both parts plumb, 31 % longer at the start than its length: a cosine."""
    mass, length, down = 50.0, 2.0, 1.0
    routed = 2 * down + np.pi * 0.2
    lift = gantline.parse_scenario(
        {
            "format": 1,
            "lift": {"title": "A spring over a sheave"},
            "duration": "1 s",
            "ropes": {"spring": {"axial_stiffness": "2 kN"}},
            "mechanics": {
                "bodies": {
                    "weight": {
                        "at": ["0.2 m", 0, 0],
                        "joint": {"type": "slider", "axis": [0, 0, 1]},
                        "mass": f"{mass} kg",
                    }
                },
                "ropes": {
                    "spring": {
                        "rope": "spring",
                        "length": f"{length} m",
                        "stretched": True,
                        "route": [
                            {"type": "end", "body": "world", "at": ["-0.2 m", 0, 0]},
                            {
                                "type": "sheave",
                                "body": "world",
                                "at": [0, 0, f"{down} m"],
                                "axis": [0, 1, 0],
                                "diameter": "0.4 m",
                            },
                            {"type": "end", "body": "weight"},
                        ],
                    }
                },
            },
        }
    )
    run = gantline.simulate(lift, tension_tolerance=1e-3, position_tolerance=1e-7)
    stiffness = 2e3 / length
    pull = stiffness * (routed - length)
    assert run.column("rope_tension", "spring")[0] == pytest.approx(pull, rel=1e-9)
    # A weight on a spring: from rest about where the spring carries it, with EA/(m L).
    swing = (pull - mass * G) / stiffness
    wanted = swing * (1 - np.cos(np.sqrt(stiffness / mass) * run.time))
    assert run.column("joint_position", "weight") == pytest.approx(wanted, abs=1e-6)


def test_a_start_as_stretched_as_that_is_asked_for() -> None:
    """Without the word it is taken for a mistake in a length; the message says the word."""
    with pytest.raises(gantline.ScenarioError, match=r"20\.19 %.*or 'stretched: true' for a spring"):
        gantline.Simulation(_pendulum())
