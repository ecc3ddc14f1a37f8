"""A hook was led to where its boom is flat, and its drives missed the way by millimetres without a word.

The arc cosine of (LD4) and the root of (LD5) have no finite slope at the edge of what a crane reaches, where
no series converges: 1024 terms were taken all the same.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from led_pair import led_text

_OUT = "{{step: out, lead: [a.H, b.H], by: [0 m, {} m, -10 m], speed: 0.3 m/min, acceleration: 1e-4 m/s^2}}"


def _led_out(way: float) -> None:
    """Assemble a lift that leads outwards, of cranes whose booms may go flat."""
    text = led_text(_OUT.format(way), duration=4000.0)
    assert "range: [20 deg, 80 deg]" in text
    assemble(parse_scenario(text.replace("range: [20 deg", "range: [0 deg")))


def test_a_way_to_a_flat_boom_is_told() -> None:
    """Heel pins 2 m ahead and 30 m of boom reach 32 m; hooks begin at 17 m."""
    _led_out(14.9)
    with pytest.raises(ScenarioError, match=r"'a\.H' would come to the very edge .*, its boom flat: its"):
        _led_out(15.0)
