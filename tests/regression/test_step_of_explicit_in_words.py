"""A step of 2.6 ms was told as one of 0.0026000000000000003 s.

It stood so in what ends the reference lift by `explicit`, an example of the page on older mechanisms: a unit
of a lift file is a factor, and 2.6 times 0.001 is not the nearest number to 0.0026.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.units import quantity


def test_a_step_is_told_with_the_digits_that_it_was_given() -> None:
    """(ME4) ends this lift at steps of more than 2.55 ms."""
    with pytest.raises(gantline.SimulationError, match=r"the step of 0\.0026 s is too long for an explicit"):
        gantline.simulate("equalizer", integrator="explicit", step=quantity("2.6 ms", "time"))
