"""An emergency stop decelerated a boom in tackles by the lever that they had at the start of the lift.

`emergency_acceleration: 0.3 deg/s^2` is one of the angle; the winch of the tackles stops rope. It got what
that is at the angle of the lift file, wherever the boom had luffed to: from tackles of a low A-frame the stop
of a boom that had come down from 74 to 34 deg was one of 0.345 deg/s^2. Steps have the mean lever of their
own way, and an emergency stop has that of the step in which it is.
"""

from __future__ import annotations

import math

import pytest

from crawler_lift import AHEAD, HEEL, LENGTH, crawler_lift
from gantline import Simulation
from gantline.scenario import parse_scenario

TOP = (-7.0, 8.0)
STOP = ", emergency_acceleration: 0.3 deg/s^2"
TACKLES = f"{STOP}, tackles: {{count: 1, parts: 20, rope: luff, from: [{TOP[0]} m, 0 m, {TOP[1]} m]}}"
ROPE = "ropes:\n  luff: {axial_stiffness: 1000 MN, damping_time: 10 ms, mass: none}\n"
SPEED = "speed: 3 deg/min"
PLAN = f"{{step: out, luff: c1, {SPEED}, to: 40 deg}}\n{{step: on, luff: c1, {SPEED}, to: 31 deg}}"


def apart(angle: float) -> float:
    """From the top of the A-frame to the boom head, law of cosines [m]; angle [deg]."""
    reach, of_top = math.hypot(TOP[0] - AHEAD, TOP[1] - HEEL), math.atan2(TOP[1] - HEEL, TOP[0] - AHEAD)
    across = 2.0 * reach * LENGTH * math.cos(of_top - math.radians(angle))
    return math.sqrt(reach**2 + LENGTH**2 - across)


def mean_lever(first: float, second: float) -> float:
    """What tackles get longer from one angle to a lower one, over that way [m/rad]."""
    return (apart(second) - apart(first)) / math.radians(first - second)


@pytest.mark.parametrize(("at", "ends"), [(50, (None, 40.0)), (850, (40.0, 31.0))], ids=["first", "second"])
def test_it_stops_as_fast_as_the_step_under_way_says(at: int, ends: tuple[float | None, float]) -> None:
    """The drum goes on by v^2/2a, v and a those of the angle times the mean lever of the step."""
    # 12 t at 16 m; at 31 deg they hang at 56 m, below what tips the crane there.
    more = f"emergency_stop: {{at: {at} s}}\n"
    text = crawler_lift(12e3, PLAN, duration=at + 5.0, luffing=TACKLES, more=more, sample=1.0)
    recording = Simulation(parse_scenario(text.replace("ropes:\n", ROPE))).run()
    assert len(recording.events("emergency_stop")) == 1
    drum = recording.column("joint_position", "c1.boom.drum")
    first = math.degrees(math.acos((16.0 - AHEAD) / LENGTH)) if ends[0] is None else ends[0]
    lever = mean_lever(first, ends[1])
    speed, deceleration = math.radians(3.0 / 60.0) * lever, math.radians(0.3) * lever
    assert drum[at] - drum[-1] == pytest.approx(speed**2 / 2.0 / deceleration, rel=1e-6)
