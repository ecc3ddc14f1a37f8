"""A load over the water that the crests of waves reach.

Whether a load went into the water was looked at against still water alone: a module 0.5 m over it, in waves
of 2 m, had their crests half a metre up its sides, without a word.
"""

from __future__ import annotations

import pytest

import gantline
from module_lift import BARGE, module_lift

PERIOD, HEIGHT = 8.0, 2.0
SWELL = f"waves: {{swell: {{height: {HEIGHT} m, period: {PERIOD} s, direction: 90 deg}}}}\n"
BASIN = "structures: {basin: {type: dock, x: [-60 m, 20 m], y: [-90 m, 90 m], floor: -12 m}}\n"
QUAY = "ground: {level: 0.2 m}\n" + BASIN


def told(clear: float, ground: str = "ground: {level: -30 m}\n") -> list[str]:
    """Of a module whose underside is lowered to that height over still water."""
    lift = module_lift(
        2.0, place=(60.0, 2.0 + clear), speed=12.0, duration=60.0, ground=ground, around=BARGE + SWELL
    )
    run = gantline.simulate(gantline.parse_scenario(lift))
    return [one for one in run.attributes["warnings"] if "module" in one and "slamming" in one]


@pytest.mark.parametrize("clear", [0.5, 0.9])
def test_crests_that_reach_a_load_are_told(clear: float) -> None:
    """1 m − clear, and the 5 mm that its sling stretches; crests run along its sides, one period of samples
    20 ms apart leaves 1e-4 m.
    """
    stretched = 20e3 * 9.81 * 5.0 / 100e6
    (said,) = told(clear)
    assert said.startswith("waves reach module at ")
    up = float(said.split("up to ")[1].split(" m")[0])
    assert up == pytest.approx(HEIGHT / 2 - clear + stretched, abs=6e-3)  # as printed
    # It is down at 11 s; waves have grown to half of what they are by 12 s, to all of it by 24 s.
    assert 11.0 < float(said.split(" at ")[1].split(" s")[0]) < 60.0


def test_above_the_crests_nothing_is_told() -> None:
    assert told(1.1) == []


def test_over_ground_there_are_no_waves() -> None:
    """A quay 0.2 m over the water, whose basin ends 40 m from the module."""
    assert told(0.5, QUAY) == []
