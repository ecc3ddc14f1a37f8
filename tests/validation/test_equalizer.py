"""The reference lift `equalizer` against an independent solution of the same equations.

That solution was made by a separate program in minimal coordinates, adaptive BDF/Adams method, relative
tolerance 1e-10. Its key numbers and tensions at chosen times are kept here; the whole curves, every 0.02 s,
are in `../shared/reference/equalizer.csv` beside the project, and where they are not, the tests on them
are skipped.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import gantline
from gantline.results.variable import FloatArray

ROOT = Path(__file__).resolve().parents[2]
CURVES = ROOT.parent / "shared" / "reference" / "equalizer.csv"
STEPS = (1e-3, 5e-4, 2.5e-4)

STATIC = 591e3  # N, about which the slings ring; errors of tension are given as shares of it
PEAK, PEAK_TIME = 702.0e3, 20.52  # N, s
EQUALIZING_PEAK = 350.4e3  # N
LIFT_OFF = 19.806  # s, the last contact force is zero
#: Time [s]; tension of slings 1 and 5, 2 and 4, and 3 [kN]; travel of their moving sheaves, down [m].
SAMPLES = np.array([
    (18, 138.54, 140.25, 138.00, 1.7099, -0.9885, -1.4320),
    (20, 661.46, 658.93, 655.95, 1.8947, -1.2083, -1.3210),
    (22, 539.91, 544.16, 539.25, 1.7292, -1.0600, -1.2961),
    (24, 629.81, 636.97, 629.73, 1.6966, -1.0137, -1.3161),
    (26, 546.72, 546.81, 543.68, 1.8336, -1.1604, -1.3037),
    (28, 629.75, 629.16, 625.80, 1.8525, -1.1742, -1.3075),
    (30, 547.86, 553.79, 547.72, 1.6982, -1.0204, -1.3125),
    (32, 625.97, 631.63, 625.54, 1.7193, -1.0452, -1.2990),
    (34, 556.11, 554.22, 551.64, 1.8847, -1.2033, -1.3195),
    (36, 629.88, 632.39, 627.91, 1.7836, -1.1123, -1.2931),
    (38, 556.93, 563.47, 556.83, 1.6913, -1.0081, -1.3226),
    (40, 625.29, 628.25, 623.60, 1.7732, -1.1024, -1.2924),
])  # fmt: skip
MIRROR = [0, 1, 2, 1, 0]  # slings 5 and 4 do as 1 and 2

Runs = Mapping[float, gantline.Recording]


@pytest.fixture(scope="module")
def runs() -> Runs:
    """The lift by `del` with three steps, each half of the one before."""
    return {
        step: gantline.simulate(ROOT / "scenarios" / "equalizer", integrator="del", step=step)
        for step in STEPS
    }


@pytest.fixture(scope="module")
def curves() -> Mapping[str, FloatArray]:
    """Columns of the independent solution."""
    if not CURVES.exists():
        pytest.skip("the whole curves, ../shared/reference/equalizer.csv, are not beside this checkout")
    table = np.genfromtxt(CURVES, delimiter=",", names=True)
    return {name: table[name] for name in table.dtype.names or ()}


def tensions(recording: gantline.Recording) -> FloatArray:
    """Tension of the five slings [N], shape (time, 5)."""
    return np.stack([recording.column("rope_tension", f"sling.S{k}") for k in range(1, 6)], axis=1)


def travels(recording: gantline.Recording) -> FloatArray:
    """Travel of the five moving sheaves, down positive [m], shape (time, 5)."""
    return np.stack([recording.column("sheave_travel", f"e1.{k}") for k in range(1, 6)], axis=1)


def at(recording: gantline.Recording, times: FloatArray) -> NDArray[np.intp]:
    """Samples at these times."""
    found = np.searchsorted(recording.time, times - 1e-6)
    assert recording.time[found] == pytest.approx(times, abs=1e-9)
    return found


def rms(difference: FloatArray) -> float:
    """Root mean square of differences of tension as a share of the static tension."""
    return float(np.sqrt(np.mean(difference**2))) / STATIC


def sampled_error(recording: gantline.Recording) -> float:
    """rms difference of the tensions at the chosen times."""
    return rms(tensions(recording)[at(recording, SAMPLES[:, 0])] - 1e3 * SAMPLES[:, 1:4][:, MIRROR])


def test_key_numbers(runs: Runs) -> None:
    """h = 1 ms: peak 702.0 kN within 1 %, at 20.52 s, equalizing rope 350.4 kN, lift-off 19.806 ± 0.05 s."""
    metrics = runs[1e-3].metrics()
    assert metrics["peak_sling_tension"] == pytest.approx(PEAK, rel=0.01)
    assert metrics["peak_sling_tension_time"] == pytest.approx(PEAK_TIME, abs=0.05)
    assert metrics["peak_equalizing_rope_tension"] == pytest.approx(EQUALIZING_PEAK, rel=0.01)
    assert metrics["lift_off_time"] == pytest.approx(LIFT_OFF, abs=0.05)
    assert runs[1e-3].attributes["counters"]["unconverged"] == 0


def test_tension_at_chosen_times(runs: Runs) -> None:
    """h = 1 ms: rms difference of tension at 18, 20 … 40 s, while the lift rings, below 2 % of 591 kN."""
    assert sampled_error(runs[1e-3]) < 0.02


def test_sheave_travel_at_chosen_times(runs: Runs) -> None:
    """h = 1 ms: travel of every moving sheave within 1 cm at 18, 20 … 40 s."""
    found = travels(runs[1e-3])[at(runs[1e-3], SAMPLES[:, 0])]
    assert np.abs(found - SAMPLES[:, 4:][:, MIRROR]).max() < 0.01


def test_error_at_chosen_times_falls_with_the_step(runs: Runs) -> None:
    """First order: errors of tensions and of the peak fall by at least 1.6 per halving of h, twice."""
    peak = [abs(runs[step].metrics()["peak_sling_tension"] - PEAK) for step in STEPS]
    error = [sampled_error(runs[step]) for step in STEPS]
    for errors in (peak, error):
        assert errors[0] > 1.6 * errors[1] > 1.6**2 * errors[2]


def test_whole_curves_of_tension(runs: Runs, curves: Mapping[str, FloatArray]) -> None:
    """rms difference over 40 s: at most 1.5 % of 591 kN at h = 1 ms; falls by 1.6 per halving, twice."""
    exact = np.stack([curves[f"sling{k}_N"] for k in range(1, 6)], axis=1)
    error = []
    for step in STEPS:
        assert runs[step].time == pytest.approx(curves["time_s"], abs=1e-9)
        error.append(rms(tensions(runs[step]) - exact))
    assert error[0] < 0.015
    assert error[0] > 1.6 * error[1] > 1.6**2 * error[2]


def test_whole_curves_of_the_peak(runs: Runs, curves: Mapping[str, FloatArray]) -> None:
    """Highest sling tension within 1 % at 1 ms; its error falls by 1.6 per halving of h, twice."""
    exact = max(float(curves[f"sling{k}_N"].max()) for k in range(1, 6))
    assert exact == pytest.approx(PEAK, rel=1e-4), "the figure kept here is that of the curves"
    error = [abs(runs[step].metrics()["peak_sling_tension"] / exact - 1) for step in STEPS]
    assert error[0] < 0.01
    assert error[0] > 1.6 * error[1] > 1.6**2 * error[2]


def test_whole_curves_of_travel(runs: Runs, curves: Mapping[str, FloatArray]) -> None:
    """Travel of every sheave within 1 cm from 18 s on; before, the slack sheaves drift in neutral balance."""
    exact = np.stack([curves[f"sheave{k}_travel_m"] for k in range(1, 6)], axis=1)
    later = curves["time_s"] >= 18.0
    assert np.abs(travels(runs[1e-3]) - exact)[later].max() < 0.01


def test_samples_kept_here_are_those_of_the_curves(curves: Mapping[str, FloatArray]) -> None:
    """The table of this file against the whole curves, to the digits that it keeps."""
    rows = np.searchsorted(curves["time_s"], SAMPLES[:, 0] - 1e-6)
    for k in range(1, 6):
        assert curves[f"sling{k}_N"][rows] / 1e3 == pytest.approx(SAMPLES[:, 1 + MIRROR[k - 1]], abs=0.006)
        assert curves[f"sheave{k}_travel_m"][rows] == pytest.approx(SAMPLES[:, 4 + MIRROR[k - 1]], abs=6e-5)
