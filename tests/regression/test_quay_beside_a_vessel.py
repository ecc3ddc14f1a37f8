"""Side views of a vessel along a quay show how high the quay is.

They are cut where most of the lift is, over water: in stages of `revolving_crane` and `heavy_lift_ship` a
load that stood on the quay seemed to hang before the side of the vessel, for nothing was there that it
could stand on.
"""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.figure import Figure

from gantline.plot.panels import draw_ground
from gantline.results.surroundings import Ground, Hole

#: A quay 3 m over the water, and a basin beside it that goes on along x.
QUAY = Ground(3.0, (Hole((-500.0, 500.0), (-15.0, 200.0), -12.0),))
VESSEL = [(0.0, -14.0, 0.0), (90.0, 14.0, 0.0)]


def lines_of(*points: tuple[float, float, float]) -> list[tuple[str, list[float]]]:
    """What is drawn along x over a window of 100 m: names of line styles and heights [m]."""
    panel = Figure().add_subplot()
    panel.set_xlim(-5.0, 95.0)
    panel.set_ylim(-15.0, 60.0)
    draw_ground(panel, QUAY, np.array(points))
    return [(str(line.get_linestyle()), list(np.asarray(line.get_ydata()))) for line in panel.lines]


def test_a_load_on_the_quay_has_its_level() -> None:
    (_, floor), (style, quay) = lines_of(*VESSEL, (60.0, -25.0, 4.0))
    assert set(floor) == {-12.0} and quay == [3.0, 3.0] and style == "--"


def test_a_vessel_far_from_it_has_none() -> None:
    [(style, floor)] = lines_of(*VESSEL)
    assert set(floor) == {-12.0} and style == "-"


@pytest.mark.parametrize("place", [-25.0, -300.0])
def test_neither_has_ground_that_is_cut(place: float) -> None:
    """All of the lift over the quay: its level is the cut itself."""
    [(_, ground)] = lines_of((0.0, place, 5.0), (90.0, place - 5.0, 5.0))
    assert set(ground) == {3.0}
