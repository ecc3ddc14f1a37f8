"""What heave compensation is asked for by small motions, against runs, and its largest values by lot."""

from __future__ import annotations

import math

import numpy as np
import pytest

import gantline
from compensated import BARGE, HOOK, VESSEL, compensated, compensated_text, head_of, place_of
from gantline.scenario import Scenario, parse_scenario
from gantline.scenario.cranes.heave import FILTER
from gantline.study.heave_demand import LASTS, heave_demands
from lift_text import changed

STILL = "  - {step: still, hold: until_end, compensate_heave: H1}\n"
SEA = "swell: {significant_height: 0.8 m, peak_period: 7 s, direction: 150 deg}"


def alike(period: float, plan: str = STILL, lasts: str = "120 s") -> Scenario:
    """The crane barge in waves of 0.6 m that are all alike."""
    waves = f"swell: {{height: 0.6 m, period: {period} s, direction: 150 deg}}"
    return parse_scenario(changed(compensated_text(plan, lasts=lasts), (SEA, waves)), str(BARGE))


@pytest.mark.parametrize("period", [7.0, 9.0])
def test_in_waves_that_are_all_alike(period: float) -> None:
    """ω² τ/√(1 + ω²τ²) of the heave of the boom head that a run has without compensation, and so on.

    To 1 %: in a run falls swing out of plumb, and the barge sways about on its lines in half a minute.
    """
    recording = gantline.Simulation(alike(period, "  - {step: sway, hold: until_end}\n")).run()
    omega = math.tau / period
    heave = place_of(recording, VESSEL, head_of(recording))[:, 2]
    late = recording.time > 120.0 - 8 * period
    turn = np.stack([np.cos(omega * recording.time), np.sin(omega * recording.time)], axis=1)[late]
    parts = np.linalg.lstsq(np.column_stack([turn, np.ones(len(turn))]), heave[late], rcond=None)[0]
    added = float(np.hypot(*parts[:2])) * omega * FILTER / math.hypot(1.0, omega * FILTER)
    (one,) = heave_demands(alike(period))
    assert (one.hook, one.step, one.over) == (HOOK, "still", None)
    assert added > 0.05
    found = [one.stroke, one.speed, one.acceleration, one.deviation]
    wanted = [2 * added, omega * added, omega**2 * added, omega * added / math.sqrt(2.0)]
    np.testing.assert_allclose(found, wanted, rtol=1e-2)


def test_in_a_sea_the_largest_of_three_hours() -> None:
    """The mean of the largest values of thirty records of 3 h, by lot.

    It is σ (√(2 ln N) + 0.577/√(2 ln N)), the first term being the most probable (Gumbel). Thirty records
    know it to π/√6/(2 ln N)/√30 = 1.6 % (a standard deviation); twice that.
    """
    (one,) = heave_demands(compensated(STILL))
    waves = np.random.default_rng(1)
    # Of any sea as narrow as this one N is within a tenth, which is 0.6 % of √(2 ln N).
    omega = math.tau / waves.normal(6.9, 0.7, 150)
    time = np.arange(0.0, LASTS, 0.5)
    largest = []
    for _ in range(30):
        phase = waves.uniform(0.0, math.tau, 150)
        parts = [np.cos(w * time + p) for w, p in zip(omega, phase, strict=True)]
        largest.append(math.sqrt(2 / 150) * one.deviation * float(np.max(np.sum(parts, axis=0))))
    root = one.speed / one.deviation
    assert np.mean(largest) == pytest.approx(one.deviation * (root + 0.577 / root), rel=0.032)


def test_where_nothing_heaves_or_compensates_nothing_is_asked_for() -> None:
    """None of a plan without it, nor of a vessel under which waves pass without a trace."""
    assert heave_demands(compensated("  - {step: sway, hold: until_end}\n")) == []
    pushed = "    wave_forces: {database: crane_barge.nc, at: [45 m, 0 m, 3 m]}\n"
    assert heave_demands(parse_scenario(changed(compensated_text(STILL), (pushed, "")), str(BARGE))) == []


def test_a_rope_that_does_not_stretch_holds() -> None:
    """One sling of four changes what a hoist needs by less than 1 %: it is 10 mm of half a metre of heave."""
    text = compensated_text(STILL)
    stiff = "  stiff: {inextensible: true, diameter: 56 mm, mass: none, minimum_breaking_force: 2188 kN}\n"
    held = changed(
        text,
        ("ropes:\n", f"ropes:\n{stiff}"),
        (
            "  A: {from: sheerleg.H1, to: module.A, length: 14 m}",
            "  A: {rope: stiff, from: sheerleg.H1, to: module.A, length: 14.01 m}",
        ),
    )
    found = [heave_demands(parse_scenario(one, str(BARGE)))[0].speed for one in (text, held)]
    assert found[1] == pytest.approx(found[0], rel=1e-2)
