"""A boom whose heel pins are off the middle of its vessel, or of its upper structure.

The tops of its luffing tackles went from y to -y of `from` about the middle of what bears the heel pins,
their lower ends as far about the middle of the boom: with heel pins 8 m to port and `from` 8 m beyond them
all ran askew, by 8 m over 93 m, and carried 0.37 % more. Now they lie as far on both sides of the boom,
wherever that stands.
"""

from __future__ import annotations

import numpy as np
import pytest

from boom_lift import TACKLES, boom_lift
from gantline import Simulation
from gantline.results import Recording
from gantline.scenario import parse_scenario

SLEWS = "    slewing_axis: [90 m, {axis:g} m]\n    slew: 0 deg\n"


def at_rest(aside: float, axis: float | None) -> Recording:
    """Heel pins and tops so far to port of the axes of the crane, and its slewing axis, if it has one [m]."""
    text = boom_lift(duration=0.1, start="rest", luffing=TACKLES)
    text = text.replace("heel_pins: {at: [98 m, 0 m,", f"heel_pins: {{at: [98 m, {aside:g} m,")
    text = text.replace("from: [70 m, 8 m,", f"from: [70 m, {8 + aside:g} m,")
    if axis is not None:
        text = text.replace("    outreach_from: 105.6 m\n", SLEWS.format(axis=axis))
    return Simulation(parse_scenario(text)).run()


@pytest.mark.parametrize("axis", [None, 8.0, 5.0], ids=["fixed", "about the boom", "about another axis"])
def test_a_boom_beside_the_middle_hangs_as_one_in_it(axis: float | None) -> None:
    """All that moves aside together keeps its forces: 1e-9 of them, where both are found to rounding."""
    middle, beside = at_rest(0.0, None), at_rest(8.0, axis)
    ropes = [f"luff.fc.{n}" for n in range(1, 5)]
    pulls = [[one.column("rope_tension", rope)[-1] for rope in ropes] for one in (middle, beside)]
    assert pulls[1] == pytest.approx(pulls[0], rel=1e-9)
    angles = [one.column("boom_angle", "fc")[-1] for one in (middle, beside)]
    assert angles[1] == pytest.approx(angles[0], abs=1e-10)


def test_each_tackle_is_in_a_plane_along_the_boom() -> None:
    """Both ends of each part of line at the same y: 16, 32/3, 16/3 and 0 m, the heel pins being at 8 m."""
    recording = at_rest(8.0, None)
    points, ropes = recording["rope_point"].values[-1], recording["rope_of_point"].values
    for place in range(4):
        across = points[ropes == f"luff.fc.{place + 1}"][:, 1]
        assert across == pytest.approx(np.full(len(across), 16 - 16 * place / 3), abs=1e-6)
