"""Drift forces of another program, of the barge of a scenario, against what they have to be at both ends."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gantline.hydro import read_database

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "crane_barge_in_swell" / "crane_barge.nc"
LENGTH, BREADTH, DRAFT, RHO, G = 90.0, 30.0, 3.0, 1025.0, 9.81


def test_short_waves_are_thrown_back_and_long_ones_pass() -> None:
    """Waves that a wall throws back whole push by ½ρg a² per metre of it (Maruo 1960): on sides of 90 m and
    ends of 30 m 452 and 151 kN/m². Of waves of 3 s, 14 m long, exp(−2κT) = 7 % of the energy is below a draft
    of 3 m and may pass; found are 97 and 96 %. Of waves ten times as long as the barge next to none is left.
    """
    database = read_database(FILE)
    assert database.drift is not None
    shortest, longest = database.drift[-1] / (RHO * G / 2), database.drift[0] / (RHO * G / 2)
    ahead, abeam, astern = (
        int(np.argmin(np.abs(database.directions - angle))) for angle in (0, np.pi / 2, np.pi)
    )
    assert shortest[abeam, 1] == pytest.approx(LENGTH, rel=0.07)
    assert shortest[ahead, 0] == pytest.approx(BREADTH, rel=0.07)
    assert shortest[astern, 0] == pytest.approx(-BREADTH, rel=0.07)
    assert np.abs(longest[:, :2]).max() < 1e-3


def test_waves_push_away_from_where_they_come() -> None:
    """Along their own direction, whatever that is; waves along the hull push it neither aside nor round."""
    database = read_database(FILE)
    assert database.drift is not None
    surge, sway, yaw = np.moveaxis(database.drift, -1, 0)
    along = surge * np.cos(database.directions) + sway * np.sin(database.directions)
    assert along.min() > -1e-4 * np.abs(along).max()
    for end in (0, -1):
        assert np.abs(sway[:, end]).max() < 1e-6 * np.abs(sway).max()
        assert np.abs(yaw[:, end]).max() < 1e-6 * np.abs(yaw).max()
