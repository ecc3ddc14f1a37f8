"""The reference lift `equalizer` by `adaptive` against an independent solution of the same equations.

`tests/support/reference_lift.py` says what that solution is. Where its whole curves are not beside this
checkout, the tests on them are skipped; those at chosen times remain.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

import gantline
from gantline.results.variable import FloatArray
from reference_lift import (
    EQUALIZING_PEAK,
    LIFT_OFF,
    MIRROR,
    PEAK,
    PEAK_TIME,
    SAMPLES,
    SCENARIO,
    at,
    curves_or_skip,
    rms,
    sampled_error,
    sling_curves,
    tensions,
    travel_curves,
    travels,
)
from shown import unsaid

#: Defaults of this lift: a ten-thousandth of the mean load of a rope, 52 N, and 0.1 mm.
TENSION, POSITION = 52.0, 1e-4


def with_tolerances(factor: float) -> gantline.Recording:
    """The lift with that many times the default tolerances."""
    return gantline.simulate(
        SCENARIO, tension_tolerance=factor * TENSION, position_tolerance=factor * POSITION
    )


@pytest.fixture(scope="module")
def default() -> gantline.Recording:
    """The lift as `gantline run` does it, without a setting."""
    return gantline.simulate(SCENARIO)


@pytest.fixture(scope="module")
def tight() -> gantline.Recording:
    """The lift with tolerances a thousand times as tight."""
    return with_tolerances(1e-3)


@pytest.fixture(scope="module")
def curves() -> Mapping[str, FloatArray]:
    """Columns of the independent solution."""
    return curves_or_skip()


def test_key_numbers_at_default_tolerances(default: gantline.Recording) -> None:
    """Peak 702.0 kN within 0.2 %, at 20.52 s, equalizing rope 350.4 kN, lift-off 19.806 ± 0.002 s."""
    assert default.attributes["settings"]["integrator"]["type"] == "adaptive"
    metrics = default.metrics()
    assert metrics["peak_sling_tension"] == pytest.approx(PEAK, rel=2e-3)
    # The curves have a value every 20 ms.
    assert metrics["peak_sling_tension_time"] == pytest.approx(PEAK_TIME, abs=0.02)
    assert metrics["peak_equalizing_rope_tension"] == pytest.approx(EQUALIZING_PEAK, rel=2e-3)
    assert metrics["lift_off_time"] == pytest.approx(LIFT_OFF, abs=2e-3)
    assert default.attributes["warnings"] == []


def test_tension_at_chosen_times_at_default_tolerances(default: gantline.Recording) -> None:
    """rms difference of tension at 18, 20 … 40 s, while the lift rings, at most 0.5 % of 591 kN."""
    assert sampled_error(default) < 5e-3


def test_travel_at_chosen_times_at_default_tolerances(default: gantline.Recording) -> None:
    """Travel of every moving sheave within 1 mm at 18, 20 … 40 s."""
    found = travels(default)[at(default, SAMPLES[:, 0])]
    assert np.abs(found - SAMPLES[:, 4:][:, MIRROR]).max() < 1e-3


def test_whole_curves_at_default_tolerances(
    default: gantline.Recording, curves: Mapping[str, FloatArray]
) -> None:
    """rms difference over 40 s at most 0.5 % of 591 kN, highest tension within 0.2 %."""
    exact = sling_curves(curves)
    assert default.time == pytest.approx(curves["time_s"], abs=1e-9)
    assert rms(tensions(default) - exact) < 5e-3
    assert default.metrics()["peak_sling_tension"] == pytest.approx(float(exact.max()), rel=2e-3)


def test_tension_at_chosen_times_at_tight_tolerances(tight: gantline.Recording) -> None:
    """rms difference of tension at 18, 20 … 40 s below 1e-5 of 591 kN."""
    assert sampled_error(tight) < 1e-5


def test_whole_curves_at_tight_tolerances(
    tight: gantline.Recording, curves: Mapping[str, FloatArray]
) -> None:
    """rms difference over 40 s below 1e-5 of 591 kN; of the curves' own 1e-10 per step 4e-6 have become."""
    assert rms(tensions(tight) - sling_curves(curves)) < 1e-5


def test_the_documents_say_so(
    default: gantline.Recording, tight: gantline.Recording, curves: Mapping[str, FloatArray]
) -> None:
    """README and pages have the differences, steps and energy remainders that are measured here."""
    exact, travel = sling_curves(curves), travel_curves(curves)
    later = curves["time_s"] >= 18.0
    rows = []
    for recording in (default, tight):
        metrics = recording.metrics()
        peak = metrics["peak_sling_tension"]
        apart = np.abs(travels(recording) - travel)[later].max()
        cells = [
            f"{recording.attributes['counters']['steps']}",
            f"{100 * rms(tensions(recording) - exact):.2g} %",
            f"{peak / 1e3:.2f} kN ({100 * (peak / exact.max() - 1):+.3f} %)",
            f"{metrics['lift_off_time']:.3f} s",
            f"{1e3 * apart:.2g} mm",
            f"{recording.attributes['energy_remainder']:.1e}",
        ]
        rows.append(f"| {' | '.join(cells)} |")
    assert unsaid("docs/verification/index.md", *rows) == []
    low = 1 - default.metrics()["peak_sling_tension"] / exact.max()
    sentence = (
        f"by {100 * rms(tensions(default) - exact):.2g} % rms of sling tension and {100 * low:.3f} % "
        f"of the peak, in {default.attributes['counters']['steps']} steps for 40 s"
    )
    first = f"differs from an independent solution by {100 * rms(tensions(default) - exact):.2g} % rms"
    assert unsaid("README.md", sentence, first) == []


def test_accuracy_over_tolerance_is_as_the_page_says(
    default: gantline.Recording, tight: gantline.Recording, curves: Mapping[str, FloatArray]
) -> None:
    """Steps and differences of four tolerances, in the table of the page on the method."""
    exact = sling_curves(curves)
    runs = {
        "520 N, 1 mm": with_tolerances(10.0),
        "52 N, 0.1 mm (default)": default,
        "5.2 N, 10 µm": with_tolerances(0.1),
        "0.052 N, 0.1 µm": tight,
    }
    rows = []
    for name, recording in runs.items():
        metrics = recording.metrics()
        cells = [
            name,
            f"{recording.attributes['counters']['steps']}",
            f"{100 * rms(tensions(recording) - exact):.2g} %",
            f"{100 * (metrics['peak_sling_tension'] / exact.max() - 1):+.3f} %",
            f"{metrics['lift_off_time']:.4f} s",
        ]
        rows.append(f"| {' | '.join(cells)} |")
    assert unsaid("docs/concepts/adaptive.md", *rows) == []


def test_tight_tolerances_are_the_limit_of_looser_ones(tight: gantline.Recording) -> None:
    """Without the independent solution: 1000 times the tolerance, 1000 times the rms difference, to half a
    decade.
    """
    errors = [rms(tensions(with_tolerances(factor)) - tensions(tight)) for factor in (10.0, 1e-2)]
    assert np.log10(errors[0] / errors[1]) == pytest.approx(3.0, abs=0.5)
