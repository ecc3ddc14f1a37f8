"""The reference lift `equalizer` as an independent program solved it, and measures of the distance from that.

That solution was made by a separate program in minimal coordinates, adaptive BDF/Adams method, relative
tolerance 1e-10. Its key numbers and the values at chosen times are kept here; the whole curves, every 0.02 s,
are in `../shared/reference/equalizer.csv` beside the project.
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
SCENARIO = ROOT / "scenarios" / "equalizer"
CURVES = ROOT.parent / "shared" / "reference" / "equalizer.csv"

STATIC = 591e3  # N, about which the slings ring; errors of tension are given as shares of it
PEAK, PEAK_TIME = 702.0e3, 20.52  # N, s
EQUALIZING_PEAK = 350.4e3  # N
LIFT_OFF = 19.806  # s, the last contact force is zero

#: Time [s]; tension of slings 1 and 5, 2 and 4, and 3 [N]; travel of their moving sheaves, down [m].
SAMPLES = np.array([
    (18, 138544.97, 140253.95, 137996.19, 1.709923, -0.988465, -1.431970),
    (20, 661462.83, 658933.49, 655952.36, 1.894657, -1.208291, -1.321046),
    (22, 539913.78, 544157.55, 539251.12, 1.729200, -1.059955, -1.296146),
    (24, 629810.90, 636969.34, 629732.91, 1.696612, -1.013744, -1.316145),
    (26, 546720.76, 546811.62, 543681.65, 1.833563, -1.160369, -1.303682),
    (28, 629750.91, 629161.76, 625802.06, 1.852531, -1.174166, -1.307455),
    (30, 547863.91, 553794.82, 547716.64, 1.698168, -1.020395, -1.312494),
    (32, 625971.53, 631628.98, 625541.63, 1.719298, -1.045166, -1.299023),
    (34, 556106.66, 554219.37, 551637.30, 1.884734, -1.203304, -1.319482),
    (36, 629882.31, 632389.14, 627906.74, 1.783562, -1.112284, -1.293146),
    (38, 556929.57, 563471.45, 556829.82, 1.691337, -1.008129, -1.322618),
    (40, 625293.55, 628252.04, 623596.90, 1.773164, -1.102441, -1.292392),
])  # fmt: skip
MIRROR = [0, 1, 2, 1, 0]  # slings 5 and 4 do as 1 and 2


def curves_or_skip() -> Mapping[str, FloatArray]:
    """Columns of the independent solution; the test is skipped where they are not beside this checkout."""
    if not CURVES.exists():
        pytest.skip("the whole curves, ../shared/reference/equalizer.csv, are not beside this checkout")
    table = np.genfromtxt(CURVES, delimiter=",", names=True)
    return {name: table[name] for name in table.dtype.names or ()}


def sling_curves(curves: Mapping[str, FloatArray]) -> FloatArray:
    """Tension of the five slings in the independent solution [N], shape (time, 5)."""
    return np.stack([curves[f"sling{k}_N"] for k in range(1, 6)], axis=1)


def travel_curves(curves: Mapping[str, FloatArray]) -> FloatArray:
    """Travel of the five moving sheaves in the independent solution [m], shape (time, 5)."""
    return np.stack([curves[f"sheave{k}_travel_m"] for k in range(1, 6)], axis=1)


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
    return rms(tensions(recording)[at(recording, SAMPLES[:, 0])] - SAMPLES[:, 1:4][:, MIRROR])
