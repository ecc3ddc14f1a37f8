"""A sling that was cut went on being adjusted, and what its spring would have held was booked as a loss.

Of an equalizer by `mechanism: approximated` a parted sling counted as one without tension, which is shortened
at each step: by tens of metres, while all others grew. Each step booked the energy of its spring, though it
held nothing, so that `mechanisms` with a sling cut lost −400 kJ by adjusting, and the remainder was 2.2 times
the largest energy, whatever the step.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline
from adjusting import LENGTH, held
from gantline.results.metrics import energy_bound
from mechanics import simulate

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


def test_the_others_share_what_they_have() -> None:
    """Held ropes at f = 1, one cut: the others are at their own mean Σ e/Σ ε, and Σ ΔL = 0."""
    stiffness = np.array([1e6, 2e6, 5e6])
    system = held(stiffness, 1.0)
    system["ropes"][2]["cut_at"] = 0.0
    run = simulate(system, 0.02)
    stretch = 1e-3 * np.arange(21, 23)
    compliance = (LENGTH - stretch) / stiffness[:2]
    mean = stretch.sum() / compliance.sum()
    assert run.columns["rope_tension"][-1] == pytest.approx([mean, mean, 0.0], rel=1e-9)
    assert np.abs(run.columns["rope_lengthening"][:, 2]).max() == 0.0
    assert np.abs(run.columns["rope_lengthening"][:, :2].sum(axis=1)).max() < 1e-15
    assert run.energy_remainder < 1e-12


def test_the_books_of_a_lift_whose_sling_is_cut() -> None:
    """`mechanisms` with its fifth sling cut while the others begin to carry."""
    lift = gantline.load_scenario(SCENARIOS / "mechanisms").changed({"slings.S5.cut_at": "1.5095 s"})
    recording = gantline.simulate(lift, duration=5.0)
    assert recording.metrics()["energy_remainder"] <= energy_bound(recording.attributes["settings"])
    lengthening = recording.column("rope_lengthening", "sling.S5")
    assert np.ptp(lengthening[recording.time > 1.52]) == 0.0
