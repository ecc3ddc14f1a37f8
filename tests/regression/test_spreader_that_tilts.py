"""A spreader that hung askew, or rolled right over, passed without a word.

Tilt was looked at of loads and of equalizers that tilt. A bar whose upper slings differ by a metre and a half
hung 23 deg askew under a level load, and one with its upper lugs below the lower ones rolled over by 180 deg
while it was loaded: GO, if nothing was known of the plates of its lugs. Bars are made to be pushed together,
and not to be bent.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.checks import Check, Verdict, check_recording, verdict_of
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from of_recording import checks_of

HALF = 4.0  # from the middle of the bar to its upper lugs [m]


def lift(lengths: tuple[float, float], middle: float = -0.001, lower: float = 0.0, more: str = "") -> str:
    """60 t hang by one sling from the middle of a bar, the bar by slings from both its ends.

    Args:
        lengths: Of the upper slings [m].
        middle: Height of the bar's centre of gravity over its upper lugs [m].
        lower: Height of its lower lug over them [m].
        more: Further sections.
    """
    return f"""\
format: 1
lift: {{title: A bar}}
duration: 60 s
ropes: {{r: {{axial_stiffness: 900 MN, damping_time: 20 ms, mass: none}}}}
ground: {{friction: 0.5}}
load:
  name: load
  shape: {{box: [6 m, 4 m, 3 m]}}
  weight: {{calculated: 60 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m]}}
  stands_on: ground
  lugs: {{A: {{at: [0 m, 0 m, 3 m]}}}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 13 m], hoist: {{speed: 6 m/min, acceleration: 0.1 m/s^2}}}}
spreaders:
  bar:
    mass: 3 t
    size: [8.4 m, 0.4 m, 0.4 m]
    centre_of_gravity: [0 m, 0 m, {middle} m]
    lugs:
      T1: {{at: [{-HALF} m, 0 m, 0 m]}}
      T2: {{at: [{HALF} m, 0 m, 0 m]}}
      B: {{at: [0 m, 0 m, {lower} m]}}
sling_defaults: {{rope: r}}
slings:
  T1: {{from: hook, to: bar.T1, length: {lengths[0]} m}}
  T2: {{from: hook, to: bar.T2, length: {lengths[1]} m}}
  B: {{from: bar.B, to: load.A, length: 5 m}}
plan:
  - {{step: up, hoist: hook, speed: 3 m/min, by: 2 m}}
  - {{step: hold, hold: until_end}}
{more}"""


def by_hand(lengths: tuple[float, float]) -> float:
    """Tilt at rest [rad]: the hook is over the middle, from which the load hangs.

    In the triangle of hook and upper lugs the line from the hook to the middle is m long, and plumb:
    L1^2 + L2^2 = 2 m^2 + 2 a^2 and |L1^2 - L2^2| = 4 m a sin(tilt).
    """
    one, two = (length**2 for length in lengths)
    line = math.sqrt((one + two) / 2 - HALF**2)
    return math.asin(abs(one - two) / (4 * line * HALF))


def checked(recording: Recording) -> Check:
    [check] = checks_of(recording, "spreader_tilt")
    return check


def test_warns_of_a_bar_askew() -> None:
    """Slings of 8 m and 6.5 m: 17.9 deg; ropes that hardly stretch, a bar of a twentieth of the load."""
    recording = Statics(parse_scenario(lift((8.0, 6.5)))).equilibrium().recording
    check = checked(recording)
    assert check.value == pytest.approx(by_hand((8.0, 6.5)), rel=1e-3)
    assert check.element == "bar"
    assert check.verdict is Verdict.WARNING
    assert "past a limit that only warns: spreader_tilt" in verdict_of(check_recording(recording))


def test_says_what_a_level_bar_has() -> None:
    check = checked(gantline.simulate(parse_scenario(lift((7.0, 7.0)))))
    assert check.verdict is Verdict.NOT_CHECKED
    assert check.value == pytest.approx(0.0, abs=1e-6)


def test_limit_of_the_lift_fails() -> None:
    """The largest of a run, which has the ringing of slings as the load is hoisted on top."""
    limits = "limits: {rule: maker of the bar, spreader_tilt: 3 deg}\n"
    check = checked(gantline.simulate(parse_scenario(lift((7.0, 6.6), more=limits))))
    assert check.verdict is Verdict.FAILED
    assert check.value == pytest.approx(by_hand((7.0, 6.6)), rel=2e-3)


def test_bar_that_rolls_over_as_it_is_loaded() -> None:
    """Hanging alone it is upright, its weight below its upper lugs; the load pulls 0.15 m above them."""
    check = checked(gantline.simulate(parse_scenario(lift((7.0, 7.0), middle=-0.05, lower=0.15))))
    assert check.verdict is Verdict.WARNING
    assert check.value is not None and check.value > math.radians(90.0)


def test_what_hangs_empty_does_not_count() -> None:
    """The slings below are slack as long as the load stands and the hook is low."""
    text = lift((8.0, 6.5)).replace("by: 2 m", "by: 0.01 m")
    assert not [
        check
        for check in check_recording(gantline.simulate(parse_scenario(text)))
        if check.name == "spreader_tilt"
    ]
