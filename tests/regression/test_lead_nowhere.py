"""A way of 1e-300 m, and a hook turned about itself, ended in a division by zero or in a step of no length.

A hook alone that turns about its own place was refused without `about` only; with it at the hook, as with a
way next to nothing, rounding was what the rate of the way was computed from.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError
from led_pair import led

_RAMPS = "speed: 6 m/min, acceleration: 0.02 m/s^2"


@pytest.mark.parametrize(
    ("way", "key"),
    [
        ("lead: [a.H, b.H], by: [1e-300 m, 0 m, 0 m]", "by"),
        ("lead: [a.H, b.H], turn: 1e-300 deg", "turn"),
        ("lead: a.H, turn: 30 deg, about: [-12 m, 17 m]", "turn"),
    ],
)
def test_a_way_that_goes_nowhere_is_told(way: str, key: str) -> None:
    with pytest.raises(ScenarioError, match=rf"plan\[1\].{key}: takes no hook anywhere, or by less than"):
        led(f"{{step: s, {way}, {_RAMPS}}}")
