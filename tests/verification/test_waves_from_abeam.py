"""Slow motions of a moored barge in waves from abeam: how they go, and what damps them.

The figures of an hour of them on the page on waves are those of `python -m tools.hour_from_abeam`, which
takes minutes.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from from_abeam import SEAS, barge_from_abeam
from gantline.hydro import read_database
from gantline.statics import Statics

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "crane_barge_in_swell" / "crane_barge.nc"
G = 9.81


def spectrum(frequency: np.ndarray, peak_period: float, enhancement: float) -> np.ndarray:
    """JONSWAP over the frequency [rad/s], to a factor."""
    peak = 2 * math.pi / peak_period
    width = np.where(frequency <= peak, 0.07, 0.09)
    near = np.exp(-0.5 * ((frequency - peak) / (width * peak)) ** 2)
    return np.asarray(frequency**-5 * np.exp(-1.25 * (peak / frequency) ** 4) * enhancement**near)


def wave_drift_damping(components: int = 100) -> float:
    """B of sway [N s/m] by (WV12) abeam in deep water: Σ a² (4ω/G D + κ D_ω), of components of equal energy.

    D from the file, by cubics that keep its shape; of shorter waves than there are that of the shortest.
    """
    database = read_database(FILE)
    assert database.drift is not None
    abeam = int(np.argmin(np.abs(database.directions - math.pi / 2)))
    known = np.asarray(database.frequencies)
    drift = PchipInterpolator(known, database.drift[:, abeam, 1])
    total = 0.0
    for height, period, enhancement in SEAS:
        frequency = np.linspace(0.2, 15.0, 400_000)
        energy = np.cumsum(spectrum(frequency, period, enhancement))
        shares = (np.arange(components) + 0.5) / components
        omega = np.interp(shares, energy / energy[-1], frequency)
        inside = np.minimum(omega, known[-1])
        slope = np.where(omega <= known[-1], drift(inside, 1), 0.0)
        each = 4 * omega / G * drift(inside) + omega**2 / G * slope
        total += 2 * (height / 4) ** 2 / components * float(each.sum())
    return total


def test_wave_drift_damping_of_a_sea_is_the_sum_over_its_waves() -> None:
    """Of the barge of `crane_barge_in_swell` in a swell and a wind sea from abeam, 29.07 kN s/m in sway by
    (WV12), to the 4e-4 that energies of components summed over steps of a spectrum leave.
    """
    sway = []
    for drift_damping in (True, False):
        question = Statics(barge_from_abeam(drift_damping=drift_damping))
        question.equilibrium(0.0)
        model = question.linear_model()
        place = model.coordinates.index("barge.y")
        sway.append(float(model.damping[place, place]))
    assert sway[0] - sway[1] == pytest.approx(wave_drift_damping(), rel=4e-4)


@pytest.mark.parametrize(
    ("drift_damping", "damping"),
    [(True, {"sway": 0.012, "yaw": 0.009}), (False, {"sway": 0.004, "yaw": 0.002})],
)
def test_sway_and_yaw_of_the_barge_on_its_lines(drift_damping: bool, damping: dict[str, float]) -> None:
    """The periods of 39 and 41 s of the page on waves, and its shares of critical damping, with and without
    what waves take: of sway B / 2 ω (M + A), 29.1 kN s/m over 2 × 0.160 rad/s × 10.9 kt, 0.84 % by (WV12).
    """
    question = Statics(barge_from_abeam(drift_damping=drift_damping))
    question.equilibrium(0.0)
    modes = {mode.motion: mode for mode in question.modes(6)}
    for name, period in (("sway", 39.0), ("yaw", 41.0)):
        mode = modes[f"barge {name}s"]
        assert mode.period == pytest.approx(period, abs=0.5)
        assert mode.damping_ratio == pytest.approx(damping[name], abs=5e-4)
