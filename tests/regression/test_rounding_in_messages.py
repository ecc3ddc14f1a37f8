"""Where a centre of gravity is, said with what is left of rounding.

The load of `goliath` on the wrong keel blocks had it "at (-1.99914, -6.46818e-19) m".
"""

from __future__ import annotations

import pytest

import gantline
from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario

SUPPORTS = (
    "supports: {stools: {under: module, grid: {x: [-1 m, 1 m], y: [-1 m, 1 m]}, height: 1 m}}\ncranes:\n"
)


def test_a_centre_of_gravity_is_said_to_a_millimetre() -> None:
    """2 m along, beside stools at 1 m; across less than nothing, by a picometre.

    Half of four slings of 8.6 m and 7.92 kg/m are at the lugs, about 0: 2 x 40 / 40.136 = 1.993 m.
    """
    text = LIFT.replace("{at: [0 m, 0 m, 1.5 m]}", "{at: [2 m, -1e-12 m, 1.5 m]}")
    text = text.replace("stands_on: ground", "position: [0 m, 0 m, 1 m]\n  stands_on: stools")
    with pytest.raises(
        gantline.ScenarioError, match=r"with rigging, is at \(1\.993, 0\) m, which is not well"
    ):
        assemble(parse_scenario(text.replace("cranes:\n", SUPPORTS)))
