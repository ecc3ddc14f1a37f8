"""A top-heavy load that a step leads straight up never came clear, and no run said why.

What tells it looked for steps that hoist by their name; other checks know that a way straight up hoists.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.checks import Verdict, check_recording
from gantline.scenario import parse_scenario
from led_pair import led_text

_RAMPS = "speed: 3 m/min, acceleration: 0.02 m/s^2"
_LED = f"{{step: up, lead: [a.H, b.H], by: [0 m, 0 m, 0.25 m], {_RAMPS}}}"
_HOISTED = "{step: up, hoist: [a.H, b.H], by: 0.25 m, speed: 3 m/min}"


@pytest.mark.parametrize("step", [_LED, _HOISTED], ids=["led", "hoisted"])
def test_a_load_that_heels_over_as_it_is_led_up_is_told(step: str) -> None:
    """Its slings are plumb and its lugs in one line: a centre of gravity 0.2 m above them is unstable."""
    text = led_text(step, duration=40.0, rest="ground: {level: 5 m, friction: 0.4}\n")
    for old, new in (
        ("position: [0 m, 17 m, 5 m]", "position: [0 m, 17 m, 5 m]\n  stands_on: ground"),
        ("0 m, 1 m]}", "0.05 m, 2.2 m]}"),
        ("[-12 m, 0 m, 3 m]", "[-12 m, 0 m, 2 m]"),
        ("[12 m, 0 m, 3 m]", "[12 m, 0 m, 2 m]"),
        ("to: beam.A, length: 6 m", "to: beam.A, length: 7.05 m"),
        ("to: beam.B, length: 6 m", "to: beam.B, length: 7.05 m"),
    ):
        assert text.count(old) == 1
        text = text.replace(old, new)
    checks = check_recording(gantline.simulate(parse_scenario(text)))
    found = [one for one in checks if one.name == "hangs_stably"]
    assert [one.verdict for one in found] == [Verdict.FAILED]
