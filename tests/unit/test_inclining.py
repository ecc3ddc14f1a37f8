"""Metacentric heights of how a vessel yields to moments about level axes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.statics.inclining import MetacentricHeights


def test_heights_about_principal_axes_and_between() -> None:
    """1/GM about an axis is the share of each principal 1/GM by the square of the cosine (Mohr's circle)."""
    heights = MetacentricHeights(np.diag([1 / 2.0, 1 / 50.0]))
    assert (heights.transverse, heights.longitudinal) == pytest.approx((2.0, 50.0), rel=1e-15)
    turn = math.radians(30.0)
    expected = 1.0 / (0.75 / 2.0 + 0.25 / 50.0)
    assert heights.about((math.cos(turn), math.sin(turn))) == pytest.approx(expected, rel=1e-15)


def test_what_displaces_nothing_does_not_yield() -> None:
    heights = MetacentricHeights(np.zeros((2, 2)))
    assert heights.transverse == heights.longitudinal == math.inf
