"""The paper's argument against the approximated mechanism, and the explicit method, on the reference lift."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.checks import check_recording
from gantline.results.recording import Recording
from gantline.results.stability import stability_of
from gantline.scenario import Scenario, parse_scenario
from shown import unsaid

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
PAGE = "docs/concepts/mechanisms.md"


def with_long_slings(name: str) -> Scenario:
    """A scenario with slings of 28 m in place of 26 m, hoisted until they carry."""
    text = (SCENARIOS / name / "scenario.yaml").read_text(encoding="utf-8")
    for old, new in (
        ("26 m", "28 m"),
        ("brake_from: 25 s", "brake_from: 45 s"),
        ("duration: 40 s", "duration: 60 s"),
    ):
        text = text.replace(old, new)
    return parse_scenario(text, "lift.yaml")


def values_of(recording: Recording, name: str) -> list[float]:
    """Values of the checks of that name."""
    checks = [check for check in check_recording(recording) if check.name == name]
    return [check.value for check in checks if check.value is not None]


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
    recording = gantline.simulate(with_long_slings("mechanisms"))
    longest = recording.metrics()["largest_rope_lengthening"]
    assert longest > 2.9
    assert np.all(recording["sheave_travel"].values == 0.0)
    assert unsaid(PAGE, f"Adjusted, slings grow by {longest:.2f} m") == []


def test_sheaves_end_the_run_where_they_meet() -> None:
    """With sheaves the same slings take sheave 3 up to the fixed ones, 2 m above, where nothing stops it.

    By (EZ2) all travels add up to half of what the equalizing rope has stretched, 16 mm of 31.3 m by 51 kN
    (EA 100 MN): sheaves 1 and 5 have been 2.87 m down by then, and have a stroke of 1.9 m.
    """
    with pytest.raises(gantline.SimulationError, match=r"next place that e1\.equalizing passes") as failure:
        gantline.simulate(with_long_slings("equalizer"))
    recording = failure.value.recording
    travel = recording["sheave_travel"].values[-1]
    assert failure.value.element == "e1.3"
    assert travel[2] == pytest.approx(-(8.65 - 6.65), abs=1e-3)
    length = 10 * 2.0 + 9 * math.pi * 0.4
    stretch = float(recording.column("rope_tension", "e1.equalizing")[-1]) * length / 100e6
    # The damper of the rope, 2 ms, has some of the tension that is taken for stretch here.
    assert travel.sum() == pytest.approx(stretch / 2, abs=1e-4)
    [used] = values_of(recording, "equalizer_travel_used")
    assert used == pytest.approx(recording["sheave_travel"].values.max() / 1.9, rel=1e-12)
    assert unsaid(PAGE, f"the check `equalizer_travel_used` says {100 * used:.0f} %") == []


def test_what_the_audit_finds_beyond_the_longest_step() -> None:
    """3 ms of `explicit`: energy from nowhere, and books that balance all the same, as the page has it."""
    with pytest.raises(gantline.SimulationError, match="is too long for an explicit method") as failure:
        gantline.simulate(SCENARIOS / "equalizer", integrator="explicit", step=3e-3)
    found = stability_of(failure.value.recording)
    gain, remainder = found.energy_gain, found.energy_remainder
    assert gain is not None and remainder is not None and gain > 0.01 > 1e-3 > remainder
    said = f"has {100 * gain:.1f} % from nowhere and a remainder of {remainder:.0e}"
    assert unsaid("docs/concepts/audit.md", said.replace("e-0", "e-")) == []


def test_a_shorter_step_adjusts_otherwise() -> None:
    """By (ME1) once a step: with a quarter of the step a difference goes four times as fast, (ME2)."""
    factors = [
        max(values_of(gantline.simulate(SCENARIOS / "mechanisms", step=step), "hook_dynamic_factor"))
        for step in (1e-3, 0.25e-3)
    ]
    said = f"is {factors[0]:.3f} as run, {factors[1]:.3f} with a quarter of the step"
    assert unsaid("docs/concepts/refinement.md", said) == []
