"""A deck that comes up under a load, or goes down with it.

What comes down hard on what is below it was told by the speed of the load alone. A load that hung still over
the deck of a barge was met by it at 18 m/min, and nothing said so; one that followed a deck down was told of
as if it had come down on the quay.
"""

from __future__ import annotations

import pytest

from gantline import simulate
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from hung_box import hung_box
from lift_text import changed
from of_recording import checks_of

LIFT = (
    """\
format: 1
lift: {title: Onto a deck that heaves}
duration: 14 s
start: rest
ropes: {soft: {axial_stiffness: 20 MN, damping_time: 10 ms}}
"""
    + hung_box("0 m, 0 m, HEIGHT m", "0 m, 0 m, HOOK m", "speed: 30 m/min, acceleration: 0.2 m/s^2")
    + """\
mechanics:
  bodies:
    deck:
      at: [10 m, 0 m, 0 m]
      joint: {type: slider, axis: [0, 0, 1], motion: [RAMP]}
      mass: 1000 t
      shape: {box: [24 m, 4 m, 1 m], centre: [0 m, 0 m, -0.5 m]}
  body_contacts:
    on_deck: {between: [box, deck], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
plan:
  - {step: wait, hold: 4 s}
  - STEP
  - {step: end, hold: until_end}
simulation: {sample_interval: 10 ms}
"""
)


def run(ramp: str, step: str, height: float = 1.0) -> Recording:
    """With the load so high above the deck [m]."""
    given = {"RAMP": ramp, "STEP": step, "HEIGHT": f"{height}", "HOOK": f"{7.0 + height}"}
    return simulate(parse_scenario(changed(LIFT, *given.items())))


def told(recording: Recording) -> list[float]:
    """Speeds of which the check tells [m/min]."""
    found = checks_of(recording, "set_down_softly")
    return [float(one.remark.split(" at ")[1].split(" m/min")[0]) for one in found]


def test_a_deck_that_comes_up_under_a_load_that_hangs_still() -> None:
    """At 0.3 m/s from 4 s on, 18 m/min; the load moves no faster than its sling rings. Told to 0.1 m/min."""
    recording = run("{at: 4 s, duration: 1 s, velocity: 0.3 m/s}", "{step: look, hold: 1 s}")
    first, *_ = [time for time, _, name in recording.events("set_down") if name == "box"]
    # It goes 0.15 m in its ramp and has 0.85 m left, less what the sling has stretched by.
    assert first == pytest.approx(5.0 + 0.85 / 0.3, abs=0.1)
    assert told(recording) == [pytest.approx(18.0, abs=0.1)]


def test_a_load_that_follows_a_deck_down() -> None:
    """Both go down, the load by 0.05 m/s more, 3 m/min: nothing to tell."""
    ramp = "{at: 4 s, duration: 1 s, velocity: -0.25 m/s}"
    down = "{step: down, lower: hook, speed: 18 m/min, until: {supports: touched}}"
    recording = run(ramp, down, height=0.2)
    assert recording.events("set_down")
    assert not told(recording)


def test_a_load_that_comes_down_on_a_deck_at_rest() -> None:
    down = "{step: down, lower: hook, speed: 18 m/min, until: {supports: touched}}"
    assert told(run("{at: 13 s, duration: 1 s, velocity: 0.01 m/s}", down)) == [pytest.approx(18.0, abs=0.1)]
