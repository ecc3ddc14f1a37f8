"""A warning of numpy, with lines of this program's source, above the table of a lift.

Whether slings run through plates is asked of every line and triangle. A line that lies along a triangle but
for the last bits crosses its plane farther away than numbers reach: `RuntimeWarning: overflow encountered
in divide` of two plumb slings between a spreader and a load.
"""

from __future__ import annotations

import warnings

import numpy as np

from gantline.results.solids import crossings

#: In the plane z = 0.
TRIANGLE = np.array([[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]])
#: The smallest number above 0.
LEAST = np.nextafter(0.0, 1.0)


def test_a_line_along_a_triangle_goes_through_nowhere() -> None:
    """It stays 1 m above it, and meets its plane 2e323 m away."""
    first = np.array([[0.2, 0.2, 1.0]])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len(crossings(first, first + np.array([1.0, 0.0, LEAST]), TRIANGLE)[0]) == 0


def test_a_line_across_it_goes_through() -> None:
    first = np.array([[0.2, 0.2, 1.0]])
    found, _ = crossings(first, first + np.array([0.0, 0.0, -2.0]), TRIANGLE)
    assert found.tolist() == [[0.2, 0.2, 0.0]]
