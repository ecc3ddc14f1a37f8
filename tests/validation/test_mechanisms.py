"""The paper's argument against the approximated mechanism, and the explicit method, on the reference lift."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.results.stability import stability_of

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


def test_explicit_finds_the_reference_lift() -> None:
    """First order, 1 ms: highest sling tension and lift-off of the independent solution to 0.1 %."""
    metrics = gantline.simulate(SCENARIOS / "equalizer", integrator="explicit", step=1e-3).metrics()
    assert metrics["peak_sling_tension"] == pytest.approx(702.0e3, rel=1e-3)
    assert metrics["lift_off_time"] == pytest.approx(19.806, abs=5e-3)
    assert metrics["energy_remainder"] < 1e-7


def test_the_longest_step_of_explicit_is_that_of_the_sheaves() -> None:
    """All five sheaves on the equalizing rope and their slings: h²ω² + 2hω²τ = 4 at 2.55 ms.

    ω² = (2² · 5 EA/L of the equalizing rope, parts of 2 m and nine arcs, + EA/L of a sling)/m.
    """
    equalizing = 1e8 / (10 * 2.0 + 9 * math.pi * 0.4)
    square = (20 * equalizing + 2e8 / 26) / 300
    limit = -2e-3 + math.sqrt(2e-3**2 + 4 / square)
    assert limit == pytest.approx(2.55e-3, abs=0.01e-3)
    below = gantline.simulate(SCENARIOS / "equalizer", integrator="explicit", step=0.98 * limit)
    assert stability_of(below).is_sound
    with pytest.raises(gantline.SimulationError, match="is too long for an explicit method") as failure:
        gantline.simulate(SCENARIOS / "equalizer", integrator="explicit", step=1.02 * limit)
    assert failure.value.element.startswith("e1.")


def test_the_time_of_adjusting_is_step_over_factor() -> None:
    """1 ms/0.001 and 10 ms/0.01 are the same lift to the first order, and another than 1 ms/0.01."""
    slow = gantline.simulate(SCENARIOS / "mechanisms", adjusting_factor=1e-3).metrics()
    long = gantline.simulate(SCENARIOS / "mechanisms", step=1e-2).metrics()
    quick = gantline.simulate(SCENARIOS / "mechanisms").metrics()
    assert long["peak_sling_tension"] == pytest.approx(slow["peak_sling_tension"], rel=1e-2)
    assert slow["peak_sling_tension"] > 1.8 * quick["peak_sling_tension"]
    assert slow["largest_rope_lengthening"] == pytest.approx(long["largest_rope_lengthening"], abs=1e-2)


def test_above_a_factor_of_two_slings_carry_in_turn() -> None:
    """By `del` differences grow where f > 2 + h²ω²/2; with ω of 20/s and 1 ms that is 2.0002."""
    spreads, gains = [], []
    for factor in (1.9, 2.05):
        recording = gantline.simulate(SCENARIOS / "mechanisms", adjusting_factor=factor, duration=30.0)
        spreads.append(recording.metrics()["final_tension_spread"])
        gains.append(stability_of(recording).energy_gain_time)
    assert spreads[0] < 0.01 < 1.0 < spreads[1]
    assert gains[0] is None
    assert gains[1] is not None


def test_lengths_grow_beyond_any_stroke() -> None:
    """Slings of 28 m need 3 m of travel down where there are 1.9 m; lengths are adjusted all the same."""
    from gantline.scenario.file.reading import parse_scenario

    text = (SCENARIOS / "mechanisms" / "scenario.yaml").read_text(encoding="utf-8")
    for old, new in (
        ("26 m", "28 m"),
        ("brake_from: 25 s", "brake_from: 45 s"),
        ("duration: 40 s", "duration: 60 s"),
    ):
        text = text.replace(old, new)
    recording = gantline.simulate(parse_scenario(text, "lift.yaml"))
    assert recording.metrics()["largest_rope_lengthening"] > 2.9
    assert np.all(recording["sheave_travel"].values == 0.0)
