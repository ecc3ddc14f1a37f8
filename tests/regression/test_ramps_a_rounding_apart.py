"""A drive that is asked to brake, or to start, a last bit after a ramp of its own or of another has ended.

A way that is too short for full speed has no cruise, but one of 1e-16 s by rounding: the step that began at
the end of the first ramp did not see the second, went on at full speed to where that ends, and was put back
from there. A Goliath crane that travelled by 46 mm as its plan began was 22 mm beyond its place and jumped
back; a traverse by 0.5 m at 0.01 m/s^2 left 3.5 % of its energy unbalanced. A quarter of all first ways of
that kind were so, and what began beside other drives, emergency stops too: 9 m/min at 0.025 m/s^2 take
5.999999999999999 s, and what was to begin at 6 s began a step later.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.results.recording import Recording
from gantline.results.variable import FloatArray
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from goliath_lift import goliath_lift

END = "{step: end, hold: until_end}"


def run(plan: str, more: str = "") -> Recording:
    return Simulation(parse_scenario(goliath_lift(f"{plan}\n{END}", duration=20.0, more=more))).run()


def balance(recording: Recording) -> float:
    return float(recording.attributes["energy_remainder"])


@pytest.mark.parametrize(("verb", "what"), [("travel", "gol"), ("traverse", "one")])
@pytest.mark.parametrize(("way", "acceleration"), [(0.1, 0.01), (0.5, 0.01), (0.06, 0.01), (0.37, 0.02)])
def test_a_way_too_short_for_full_speed(verb: str, what: str, way: float, acceleration: float) -> None:
    """a t^2/2 up to T = sqrt(s/a), s - a (2T - t)^2/2 from there to 2T; prescribed, so to rounding."""
    words = f"speed: 20 m/min, acceleration: {acceleration} m/s^2, by: {way} m"
    recording = run(f"{{step: move, {verb}: {what}, {words}}}")
    half = math.sqrt(way / acceleration)
    time = recording.time
    first = 0.5 * acceleration * np.minimum(time, half) ** 2
    second = way - 0.5 * acceleration * np.maximum(2 * half - time, 0.0) ** 2
    expected: FloatArray = np.where(time < half, first, second)
    place = recording.column("joint_position", f"gol.{what}" if what == "one" else what)
    assert np.abs(place - place[0] - expected).max() < 1e-12
    # The bound of a run is 1e-6; that of a method of order 5 on a pendulum is far below.
    assert balance(recording) < 1e-6


#: 9 m/min at 0.025 m/s^2.
SPEED, ACCELERATION = 0.15, 0.025
_MOVE = "speed: 9 m/min, acceleration: 0.025 m/s^2, by: 5 m"


def test_an_emergency_stop_at_the_end_of_a_ramp() -> None:
    """0.45 m up to 6 s, 0.15 m/s then, and 0.03 m/s^2 from there: 5 s to rest, 0.375 m."""
    assert SPEED / ACCELERATION == 5.999999999999999
    recording = run(f"{{step: move, travel: gol, {_MOVE}}}", "emergency_stop: {at: 6 s}\n")
    time = recording.time
    on = np.clip(time - 6.0, 0.0, 5.0)
    expected = np.where(time < 6.0, 0.0125 * time**2, 0.45 + 0.15 * on - 0.015 * on**2)
    assert np.abs(recording.column("joint_position", "gol") - expected).max() < 1e-12
    assert balance(recording) < 1e-6


def test_a_drive_that_starts_as_the_ramp_of_another_ends() -> None:
    beside = f"{{step: beside, traverse: one, {_MOVE}, starts: with_previous, start_at: 6 s}}"
    recording = run(f"{{step: move, travel: gol, {_MOVE}}}\n{beside}")
    time = recording.time
    since = np.maximum(time - 6.0, 0.0)
    expected = np.where(since < 6.0, 0.0125 * since**2, 0.45 + 0.15 * (since - 6.0))
    place = recording.column("joint_position", "gol.one")
    assert np.abs(place - place[0] - expected).max() < 1e-12
    assert balance(recording) < 1e-6
