"""Slings of 20 m under a hook 8 m over their lugs were in order; the run waited for lift-off to its end.

The plan had no time, or no way, to hoist the hook to where they go taut. `gantline check` told only of slings
several times as long as their way at the start.
"""

from __future__ import annotations

from math import hypot, sqrt

import pytest

from crawler_pair import GEAR, MASSES
from four_slings import LIFT
from gantline.assembly import assemble
from gantline.scenario import parse_scenario
from lift_text import changed

LONG = 20.0
#: Where 20 m go taut over lugs 3 m high and 2.5 m and 1.5 m aside of the hook [m].
TAUT = 3.0 + sqrt(LONG**2 - hypot(2.5, 1.5) ** 2)
#: Where it starts [m], and the steps of the plan: speeds [m/s], and the way of the second [m].
START, SLOW, WAY = 11.0, 1.0 / 60.0, 0.2


def told(length: float, duration: float, *changes: tuple[str, str]) -> list[str]:
    text = LIFT.replace("length: 8.6 m", f"length: {length} m")
    text = changed(text, ("duration: 70 s", f"duration: {duration} s"), *changes)
    return [one for one in assemble(parse_scenario(text)).warnings if "never lifted" in one]


def test_too_little_time() -> None:
    """All of 120 s at 1 m/min, and the way of the next step."""
    most = START + SLOW * 120.0 + WAY
    (warning,) = told(LONG, 120.0)
    comes = f"goes taut with crane at {TAUT:.2f} m, and the plan brings crane to {most:.2f} m at most"
    assert (f"{TAUT:.2f}", f"{most:.2f}") == ("22.79", "13.20")
    assert warning.startswith(f"module is never lifted: sling A, the first of 4, {comes}; see lengths")


@pytest.mark.parametrize("time", [(TAUT - START - WAY) / SLOW + 10.0, 1200.0])
def test_time_enough(time: float) -> None:
    assert told(LONG, time) == []


def test_too_little_way() -> None:
    """A step `by` 11 m in place of one that waits for lift-off, with time for ten times that."""
    by = ("speed: 1 m/min, until: {supports: clear}", "speed: 1 m/min, by: {} m")
    (warning,) = told(LONG, 6000.0, (by[0], by[1].format(11)))
    assert f"brings crane to {START + 11.0 + WAY:.2f} m at most" in warning
    assert told(LONG, 6000.0, (by[0], by[1].format(11.7))) == []


@pytest.mark.parametrize("by", [2.0, 3.5])
def test_one_sling_that_goes_taut_is_enough(by: float) -> None:
    """10 m under a hook that starts 8 m over the lugs: 8.10 m and 1.56 m more; the others are 20 m long."""
    short = ("module.A, length: 20.0 m", "module.A, length: 10 m")
    step = ("speed: 1 m/min, until: {supports: clear}", f"speed: 1 m/min, by: {by - WAY} m")
    assert START + by > 3.0 + sqrt(10.0**2 - hypot(2.5, 1.5) ** 2)
    assert told(LONG, 6000.0, short, step) == []


def test_as_high_as_the_sheaves_allow() -> None:
    """The head 1 m over the upper sheaves, half of 0.7 m of these and of those below, a hook block of 2 m."""
    text = f"""\
format: 1
lift: {{title: To two-blocking}}
duration: 6000 s
{GEAR}load:
  name: cube
  shape: {{box: [4 m, 3 m, 3 m]}}
  position: [8 m, 0 m, 0 m]
  weight: {{calculated: 30 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs: {{A: {{at: [-1.5 m, 0 m, 3 m]}}, B: {{at: [1.5 m, 0 m, 3 m]}}}}
cranes:
  c1:
    type: crawler
    position: [-8 m, 0 m]
    heading: 0 deg
    slew: 0 deg
    tracks: {{length: 9 m, width: 1.5 m, gauge: 8.4 m, mats: 6 m}}
{MASSES}    hooks: {{H: {{type: H, height: 30 m}}}}
sling_defaults: {{rope: sling, length: LENGTH m}}
slings: {{A: {{from: c1.H, to: cube.A}}, B: {{from: c1.H, to: cube.B}}}}
plan: [{{step: up, hoist: c1.H, speed: 3 m/min, until: {{supports: clear}}}}]
"""
    head = 2.5 + sqrt(63.0**2 - (16.0 - 1.6) ** 2)
    top, taut = head - 1.0 - 0.7 - 2.0, 3.0 + sqrt(60.0**2 - 1.5**2)
    (warning,) = (
        one for one in assemble(parse_scenario(changed(text, ("LENGTH", "60")))).warnings if "never" in one
    )
    assert f"goes taut with c1.H at {taut:.2f} m, and the plan brings c1.H to {top:.2f} m at most" in warning
    shorter = assemble(parse_scenario(changed(text, ("LENGTH", "57")))).warnings
    assert not [one for one in shorter if "never lifted" in one]
