"""Section 4.1 of Ham, Roh and Lee 2016, the scenario `pulleys`, against its closed form.

One inextensible rope, all parts plumb: 2 (2T/20 - g) + 2 (2T/20 - g) = g - T/11, hence T = 275 g/27; the box
sinks with 2 g/27, the moving sheaves rise with g/54.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline

LIFT = Path(__file__).resolve().parents[2] / "scenarios" / "pulleys"
G = 9.81
BOX, SHEAVE = 2 * G / 27 * 5**2 / 2, G / 54 * 5**2 / 2  # m after 5 s


def displacements(recording: gantline.Recording) -> list[float]:
    """Of the box, down, and of the two moving sheaves, up, at the end [m]."""
    moved = {
        name: float(np.ptp(recording.column("joint_position", name)[[0, -1]]))
        for name in ("box", "sheave_1", "sheave_2")
    }
    return list(moved.values())


def test_tension_at_every_step() -> None:
    """T = 275 g/27 = 99.9167 N within 1e-6 at every step after the first, `del`, h = 1 ms."""
    recording = gantline.simulate(LIFT, step=1e-3, sample_interval=1e-3)
    tension = recording.column("rope_tension", "rope")
    assert len(tension) == 5001
    assert np.abs(tension[2:] / (275 * G / 27) - 1).max() < 1e-6


def test_displacements_after_five_seconds() -> None:
    """9.08333 m and 2.27083 m within 0.1 % at h = 1 ms; the error halves with h."""
    assert pytest.approx((9.08333, 2.27083), abs=5e-6) == (BOX, SHEAVE)
    exact = np.array([BOX, SHEAVE, SHEAVE])
    errors = [
        float(np.abs(displacements(gantline.simulate(LIFT, step=step)) / exact - 1).max())
        for step in (1e-3, 5e-4)
    ]
    assert errors[0] < 1e-3
    assert errors[0] / errors[1] == pytest.approx(2.0, rel=1e-3)


def test_nothing_is_reached() -> None:
    """Parts long enough at the start that moving and fixed sheaves stay more than a metre apart."""
    recording = gantline.simulate(LIFT)
    assert recording["segment_length"].values.min() > 1.0
