"""A bar that slides and turns over corners and edges of other shapes: its results follow the tolerance.

`tests/regression/test_bar_slides_over_an_end.py` holds such a motion against equations of its own.
"""

from __future__ import annotations

import numpy as np

from mechanics import Floats, Json
from sliding_bar import bar, end_of, run, shape


def ends(system: Json, duration: float, tolerances: tuple[float, ...]) -> list[Floats]:
    return [end_of(run(system, duration, tolerance)) for tolerance in tolerances]


def test_results_over_corners_follow_the_tolerance() -> None:
    """A bar that slides and turns over two pedestals narrower than itself, their corners on its underside:
    ends at tolerances of 10, 1 and 0.1 µm are within half of that of the one at 10 nm.
    """
    pedestals = [shape(name, (0.3, 0.6, 1.0), (x, 0.0, -0.5)) for name, x in (("one", -1.2), ("other", 1.0))]
    system = bar(0.0, 8, [1.5, 0.2, 0.0], 0.3, 0.3, *pedestals)
    *found, best = ends(system, 0.4, (1e-5, 1e-6, 1e-7, 1e-8))
    for place, tolerance in zip(found, (1e-5, 1e-6, 1e-7), strict=True):
        assert np.abs(place - best).max() < 0.5 * tolerance


def test_results_over_edges_follow_the_tolerance() -> None:
    """The same over two beams wider than the bar, whose edges cross its own: friction acts at the crossing,
    which runs along both, and how far it has slid is right to second order of a step: 1e-6 at a tolerance
    of 1 µm, and less with the tolerance.
    """
    beams = [shape(name, (0.3, 6.0, 1.0), (x, 0.0, -0.5)) for name, x in (("one", -1.2), ("other", 1.0))]
    system = bar(0.0, 8, [1.2, 0.9, 0.0], 0.4, 0.3, *beams)
    *found, best = ends(system, 0.4, (1e-6, 1e-8, 1e-9))
    errors = [np.abs(place - best).max() for place in found]
    assert errors[0] < 1e-6 and errors[1] < 1e-7
