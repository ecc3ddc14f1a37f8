"""Pictures of `gantline compare` drew rounding as a difference, and constant ones on the edge of their panel.

Of two lifts at rest whose slings differ in length the table had `0 kN` for the hook load, and the picture a
curve of 1e-10 kN that swings, with "largest: −1.7e−10 kN at 4.30 s". A difference that is the same all the
time was largest at 0.26 s, where rounding had it; and the distance of the two loads, a constant, lay upon the
upper edge of its panel, with half of its mark cut off.
"""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import gantline
from drawn import text_of
from gantline.plot import comparison_figures
from gantline.results.comparison import Comparison
from sample_lift import WEIGHT, sample_recording, sample_rig

TIME = np.linspace(0.0, 10.0, 101)
#: Grows to 1e-12 in the middle of the time: ten thousand roundings of a number, a thousandth of what counts.
NOISE = 1e-12 * np.sin(np.pi * TIME / 10.0)


def compared(share: float, tilt: float = 0.0) -> Comparison:
    """The sample lift, and with shares of sling tension and a tilt [rad] that change by rounding alone."""

    def lift(more: float, angle: float) -> gantline.Recording:
        tension = WEIGHT / 5.0 * (1.0 + more + NOISE * (more != 0.0))[:, None] * np.ones(5)
        return sample_recording(TIME, rig=sample_rig(), tension=tension, tilt=angle * (1.0 + NOISE))

    return gantline.compare(lift(0.0, 0.0), lift(share, tilt))


def panels(comparison: Comparison, name: str) -> list[Axes]:
    figure: Figure = dict(comparison_figures(comparison))[name]
    return list(figure.axes)


def drawn(panel: Axes) -> list[np.ndarray]:
    lines = [np.asarray(line.get_ydata(), float) for line in panel.get_lines()]
    return [values for values in lines if len(values) > 2]


@pytest.mark.parametrize("name", ["compare_sling_tension", "compare_hook_load"])
def test_rounding_is_no_difference(name: str) -> None:
    lower = panels(compared(1e-13), name)[1]
    assert "no difference but rounding" in text_of(lower)
    assert all(not values.any() for values in drawn(lower))


def test_more_than_rounding_is_drawn() -> None:
    """1e-6 of WEIGHT/5 = 588.6 kN are 0.589 N."""
    lower = panels(compared(1e-6), "compare_sling_tension")[1]
    assert "+0.000589 kN" in text_of(lower)
    np.testing.assert_allclose(drawn(lower)[0], 1e-6 * WEIGHT / 5.0 / 1e3, rtol=2e-6)


def test_a_constant_difference_is_largest_as_it_begins() -> None:
    """A tenth more in each sling: rounding alone made it larger half-way, at 5 s."""
    comparison = compared(0.1)
    (found,) = (rope.deviation for rope in comparison.ropes if rope.name == "sling.S1")
    assert found is not None
    assert found.time == 0.0
    assert found.largest == pytest.approx(0.1 * WEIGHT / 5.0, rel=1e-9)
    assert "at 0.00 s" in text_of(panels(comparison, "compare_sling_tension")[1])


def test_a_constant_angle_keeps_clear_of_the_edge() -> None:
    for panel in (panels(compared(0.0, 0.02), "compare_load_motion")[place] for place in (2, 5)):
        low, high = panel.get_ylim()
        (largest,) = {round(float(values.max()), 6) for values in drawn(panel)[-1:]}
        assert low == 0.0
        assert largest == pytest.approx(np.degrees(0.02), abs=1e-6)
        assert largest < 0.8 * high
