"""What a file says between its frequencies and directions.

A cubic spline of a smooth function is off by (5/384) h⁴ max |f⁗| (Hall and Meyer 1976, h the distance of its
points), a straight line by h²/8 max |f″|. Forces here are those of Froude and Krylov on a box of
100 × 30 × 4 m, in closed form, added mass and damping those of three oscillators.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import waves
from floating import SEA
from gantline.hydro.database import HydrodynamicDatabase

Complex = npt.NDArray[np.complex128]
#: Of the fourth derivative, in the bound of Hall and Meyer.
BOUND = 5 / 384


def held(frequencies: npt.NDArray[np.float64], degrees: npt.NDArray[np.float64]) -> HydrodynamicDatabase:
    """The box at these frequencies [rad/s], in these directions."""
    nothing = np.zeros((len(frequencies), 6, 6))
    directions = np.radians(degrees)
    forces = np.array([[waves.force_per_metre(w, b) for b in directions] for w in frequencies])
    return HydrodynamicDatabase(
        name="box",
        source="closed form",
        frequencies=frequencies,
        added_mass=nothing,
        damping=nothing,
        density=SEA,
        directions=directions,
        excitation=forces,
    )


def fourth(
    function: Callable[[float], npt.NDArray[Any]], start: float, end: float
) -> npt.NDArray[np.float64]:
    """Largest |f⁗| of each of the six, by differences of steps whose own error is a thousandth of it."""
    h = (end - start) / 400
    values = np.array([function(x) for x in np.arange(start - 2 * h, end + 2.5 * h, h)])
    differences = values[4:] - 4 * values[3:-1] + 6 * values[2:-2] - 4 * values[1:-3] + values[:-4]
    largest: npt.NDArray[np.float64] = np.abs(differences).max(axis=0) / h**4
    return largest


@pytest.mark.parametrize("apart", [30.0, 22.5, 15.0, 10.0, 5.0])
def test_between_directions(apart: float) -> None:
    """Waves of 7 s from anywhere: within the bound of periodic splines, and no better than a tenth of it."""
    omega = 2 * math.pi / 7.0
    database = held(np.array([omega]), np.arange(0.0, 180.1, apart))
    wanted = np.radians(np.arange(0.0, 360.0, 1.3))
    found = np.array([database.excitation_at(np.array([omega]), b, SEA)[0][0] for b in wanted])
    true = np.array([waves.force_per_metre(omega, b) for b in wanted])
    bound = (
        BOUND * math.radians(apart) ** 4 * fourth(lambda b: waves.force_per_metre(omega, b), 0.0, math.tau)
    )
    error = np.abs(found - true).max(axis=0)
    # Second order in the bound: a periodic spline adds terms of h⁶.
    assert np.all(error <= 1.05 * bound)
    assert np.all(error >= 0.1 * bound)


@pytest.mark.parametrize("apart", [0.2, 0.1, 0.05, 0.025])
def test_between_frequencies(apart: float) -> None:
    """From 12 to 6 s in the middle of a file: away from its ends, where the spline has no third derivative to
    go by, the bound holds.
    """
    database = held(np.arange(0.2, 2.01, apart), np.array([35.0]))
    wanted = np.linspace(2 * math.pi / 12, 2 * math.pi / 6, 137)
    found = database.excitation_at(wanted, math.radians(35.0), SEA)[0]

    def at(omega: float) -> Complex:
        force: Complex = waves.force_per_metre(omega, math.radians(35.0))
        return force

    error = np.abs(found - np.array([at(w) for w in wanted])).max(axis=0)
    bound = BOUND * apart**4 * fourth(at, 0.3, 1.5)
    assert np.all(error <= 1.05 * bound)


@pytest.mark.parametrize("apart", [0.2, 0.1, 0.05])
def test_added_mass_and_damping_between_frequencies(apart: float) -> None:
    """At periods of 7 to 12 s; with 0.1 rad/s straight lines were seven times as far off."""
    frequencies = np.arange(0.2, 2.01, apart)
    added, damping = waves.radiated(frequencies)
    database = replace(held(frequencies, np.zeros(1)), added_mass=added, damping=damping)
    for which, found in enumerate((database.added_mass_at, database.damping_at)):

        def diagonal(omega: float, which: int = which) -> npt.NDArray[np.float64]:
            return np.diagonal(waves.radiated(np.array([omega]))[which][0])

        bound = BOUND * apart**4 * fourth(diagonal, 0.3, 1.5)
        for omega in np.linspace(2 * math.pi / 12, 2 * math.pi / 7, 19):
            error = np.abs(np.diagonal(found(2 * math.pi / omega, SEA)[0]) - diagonal(omega))
            assert np.all(error <= 1.05 * bound)


def test_a_file_of_some_directions() -> None:
    """From 30° to 30° between −60° and 60°: a spline along these, and nothing in the gap of 240°.

    At the ends it is one cubic over two intervals, as good as one through four points, whose error is
    max |s (s − 1) (s − 2) (s − 3)| h⁴/24 max |f⁗| = h⁴/24 max |f⁗|.
    """
    omega = 2 * math.pi / 9.0
    some = held(np.array([omega]), np.arange(-60.0, 60.1, 30.0))
    limit = math.radians(60.0)
    bound = math.radians(30.0) ** 4 / 24 * fourth(lambda b: waves.force_per_metre(omega, b), -limit, limit)
    for degrees in (-45.0, -15.0, 0.0, 7.0, 52.0):
        found, doubts = some.excitation_at(np.array([omega]), math.radians(degrees), SEA)
        assert np.all(np.abs(found[0] - waves.force_per_metre(omega, math.radians(degrees))) <= bound)
        assert not doubts
    gap = some.excitation_around(np.array([omega]), SEA)
    assert gap.at(math.radians(61.0)) is None
    assert gap.at(math.radians(180.0)) is None
    # Across it what moves there on: a straight line from one end to the other.
    last = gap.cubics[0, list(np.degrees(gap.directions).round()).index(60.0)]
    assert np.all(last[2:] == 0.0)
    assert last[0] + last[1] == pytest.approx(waves.force_per_metre(omega, math.radians(-60.0)), rel=1e-9)
