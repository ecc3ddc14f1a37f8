"""Extension sheaves, Fig. 4 of Ham, Roh and Lee (2016): tension halves at each depth.

A load W with lugs at (±a, ±b) hangs level. Each of two extension sheaves of mass m is held by a sling
of unstretched length l₁ (half of one that runs over the sheave above it), whose top is at ±t, and carries
a sling of length 2 l₂ over it to the two lugs on its side. With d its distance from the middle plane and
the stretched lengths ℓᵢ = lᵢ (1 + Tᵢ/EA):

    sin θ₁ = (d − t)/ℓ₁,   T₁ cos θ₁ = W/2 + m g,   cos θ₂ = √(ℓ₂² − (a − d)² − b²)/ℓ₂,   4 T₂ cos θ₂ = W
    T₁ sin θ₁ = 2 T₂ (a − d)/ℓ₂

of which the last gives d. A sheave above both is held by W + 3 m g.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest

from extension_lifts import DEEP, LOAD, LUGS, PAIRED, SHEAVE
from gantline.results import series
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from mechanics import G

EA = 100e6
WEIGHT = LOAD * G
METHODS = {"adaptive": None, "del": 2e-3}


@dataclass(frozen=True)
class Rest:
    """Tensions [N], distance of the sheaves from the middle plane, height of the tops over the lugs [m]."""

    upper: float
    lower: float
    aside: float
    height: float


def at_rest(top: float, upper_length: float, lower_length: float) -> Rest:
    """The equations above, by halving."""
    a, b = max(x for x, _ in LUGS), max(y for _, y in LUGS)

    def state(d: float) -> tuple[float, Rest]:
        upper, lower = WEIGHT / 2 + SHEAVE * G, WEIGHT / 4
        for _ in range(60):  # stretch changes lengths by a thousandth, so each round is worth three digits
            long, short = upper_length * (1 + upper / EA), lower_length * (1 + lower / EA)
            sine = (d - top) / long
            height = math.sqrt(short**2 - (a - d) ** 2 - b**2)
            upper = (WEIGHT / 2 + SHEAVE * G) / math.sqrt(1 - sine**2)
            lower = WEIGHT / 4 * short / height
        missing = upper * sine - 2 * lower * (a - d) / short
        return missing, Rest(upper, lower, d, height + long * math.sqrt(1 - sine**2))

    low, high = top, a
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if state(middle)[0] < 0 else (low, middle)
    return state(high)[1]


def static(recording: Recording, rope: str) -> float:
    value = series.static_value(recording, recording.column("rope_tension", rope))
    assert value is not None
    return value


def aside(recording: Recording, sheave: str) -> float:
    value = series.static_value(recording, np.abs(recording.column("body_position", sheave)[:, 0]))
    assert value is not None
    return value


@pytest.mark.parametrize("method", METHODS)
def test_tension_halves_at_each_depth(method: str) -> None:
    """One sling of a hook, two sheaves under its sheave, four lugs: W + 3mg, W/2 + mg and W/4 over cosines.

    Means over the quiet window, in which the load still rings on its ropes by 0.3 %.
    """
    recording = simulate(parse_scenario(DEEP), integrator=method, step=METHODS[method])
    exact = at_rest(0.0, 10.0, 9.0)
    assert static(recording, "sling.S") == pytest.approx(WEIGHT + 3 * SHEAVE * G, rel=1e-4)
    assert static(recording, "sling.S1") == pytest.approx(exact.upper, rel=1e-4)
    for sling in ("sling.S2", "sling.S3"):
        assert static(recording, sling) == pytest.approx(exact.lower, rel=1e-4)
    for sheave in ("X2", "X3"):
        assert aside(recording, sheave) == pytest.approx(exact.aside, abs=1e-3)
    # Both legs of a sling carry the same, at any time.
    legs = recording["segment_tension"].values
    labels = recording.coordinates["segment"]
    for sling in ("S1", "S2", "S3"):
        one, other = (legs[:, labels.index(f"sling.{sling}/{leg}")] for leg in (0, 1))
        assert np.array_equal(one, other)
    assert recording.attributes["energy_remainder"] < (1e-7 if method == "adaptive" else 1e-3)


@pytest.mark.parametrize("method", METHODS)
def test_an_equalizer_that_serves_two_lugs_by_each_sling(method: str) -> None:
    """Two moving sheaves, four lugs: (W/2 + mg)/cos θ₁ in its slings, a half of that and less below."""
    recording = simulate(parse_scenario(PAIRED), integrator=method, step=METHODS[method])
    exact = at_rest(0.8, 9.0, 10.0)
    for number in (1, 2):
        assert static(recording, f"sling.S{number}") == pytest.approx(exact.upper, rel=1e-4)
        assert static(recording, f"sling.S{number}x") == pytest.approx(exact.lower, rel=1e-4)
        assert aside(recording, f"X{number}") == pytest.approx(exact.aside, abs=1e-3)
    # What the table calls the spread of the equalizer is that of the slings on its moving sheaves.
    assert recording.rig.equalizers[0].slings == ["sling.S1", "sling.S2"]
    assert recording.metrics()["final_tension_spread"] < 1e-3
