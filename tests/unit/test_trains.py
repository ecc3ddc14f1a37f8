"""Waves over points of a body that moves, in rows or not, against the sum of cosines at each point."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as some
from scipy.spatial.transform import Rotation

from gantline.results.afloat.trains import Trains
from gantline.results.afloat.wind import Wind

SEA = Trains.from_json(
    {
        "components": [
            {"frequency": 0.7, "wave_number": [0.04, 0.03], "amplitude": 0.8, "phase": 0.3},
            {"frequency": 2.1, "wave_number": [-0.41, 0.19], "amplitude": 0.2, "phase": -2.0},
        ],
        "rise_time": 5.0,
    }
)
TIME = np.linspace(0.0, 40.0, 81)


def _height(time: float, x: float, y: float) -> float:
    """g Σ a cos(k·x − ωt + ε) at one point, g = s³(10 − 15 s + 6 s²)."""
    share = min(time / SEA.rise_time, 1.0)
    waves = (
        one["amplitude"]
        * math.cos(
            one["wave_number"][0] * x + one["wave_number"][1] * y - one["frequency"] * time + one["phase"]
        )
        for one in SEA.components
    )
    return share**3 * (10.0 - 15.0 * share + 6.0 * share**2) * math.fsum(waves)


def _moving() -> tuple[np.ndarray, np.ndarray]:
    """A body that drifts, rolls and turns round."""
    origin = np.stack([0.3 * TIME, -2.0 + 0.1 * TIME, np.sin(TIME)], axis=1)
    turn = Rotation.from_euler("zyx", np.stack([0.05 * TIME, 0.1 * np.sin(TIME), 0.2 * np.cos(TIME)], axis=1))
    return origin, turn.as_matrix()


@given(
    rows=some.lists(
        some.tuples(
            some.tuples(*[some.floats(-60.0, 60.0)] * 3),
            some.tuples(*[some.floats(-8.0, 8.0)] * 3),
            some.integers(1, 30),
        ),
        min_size=1,
        max_size=4,
    )
)
def test_rows_have_the_heights_of_their_points(
    rows: list[tuple[tuple[float, ...], tuple[float, ...], int]],
) -> None:
    """After 30 turns by one angle rounding is below 1e-14 of an amplitude each: 1e-11 is far from it."""
    points = np.array([np.add(first, np.multiply(k, step)) for first, step, n in rows for k in range(n)])
    origin, turn = _moving()
    found = SEA.at_body(TIME, origin, turn, points)
    assert found.shape == (len(TIME), len(points))
    for sample in (0, 7, 80):
        places = origin[sample] + points @ turn[sample].T
        expected = [_height(float(TIME[sample]), float(x), float(y)) for x, y, _ in places]
        assert found[sample] == pytest.approx(expected, abs=1e-11)


def test_points_in_no_order() -> None:
    """Corners of a deck, with an opening twice and a row that ends where another begins."""
    points = np.array(
        [[0, 0, 3], [0, 6, 3], [0, 6, 3], [2, 6, 3], [4, 6, 3], [4, 5, 3], [4, 4, 3], [9, 1, 4]]
    )
    origin, turn = _moving()
    place = origin[:, None, :2] + np.einsum("tij,pj->tpi", turn[:, :2], points)
    assert SEA.at_body(TIME, origin, turn, points.astype(float)) == pytest.approx(
        SEA.at(TIME, place), abs=1e-12
    )


def test_waves_over_long_runs_have_the_heights_of_their_points() -> None:
    """Samples are looked at some thousands at a time: 10 000 of a wave a cos(k x − ω t) over two points of a
    body at rest, one of them 5 m further along, are all there."""
    wave = {"frequency": 0.7, "wave_number": [0.05, 0.0], "amplitude": 0.8, "phase": 0.0}
    sea = Trains.from_json({"components": [wave], "rise_time": 1.0})
    time = np.linspace(100.0, 1100.0, 10_000)
    points = np.array([[3.0, 1.0, 0.0], [8.0, 1.0, 0.0]])
    turn = np.broadcast_to(np.eye(3), (len(time), 3, 3))
    found = sea.at_body(time, np.zeros((len(time), 3)), turn, points)
    expected = 0.8 * np.cos(0.05 * points[:, 0] - 0.7 * time[:, None])
    assert found == pytest.approx(expected, abs=1e-11)


def test_gusty_wind_is_its_mean_and_what_gusts_add() -> None:
    """At a place that goes along, 8 m/s and the same sum."""
    place = np.stack([0.3 * TIME, 5.0 - 0.2 * TIME], axis=1)
    expected = [8.0 + _height(time, x, y) for time, (x, y) in zip(TIME, place, strict=True)]
    gusty, steady = Wind(8.0, 0.0, gusts=SEA), Wind(8.0, 0.0)
    assert gusty.speed_at(TIME, place) == pytest.approx(expected, abs=1e-12)
    assert steady.speed_at(TIME, place) == pytest.approx(np.full(TIME.shape, 8.0))
