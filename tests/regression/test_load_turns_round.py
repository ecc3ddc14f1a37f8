"""A load that turned round below its hook was a GO without a word.

In `equalizer_yard` slings of different lengths give the load a turn as it comes off the ground, and the hinge
of its frame has no friction: it turned by 202 deg in 300 s, still at 1 deg/s, and no check told of it, since
nobody had written `load_yaw`. Past 45 deg, and what crane or vessel turn by, it is a warning now; a limit, or
a step that asks for the heading, decides in its place.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import gantline
from gantline.checks import Check, Outcome, Verdict, check_recording, outcome_of
from gantline.results.recording import Recording
from gantline.results.variable import Variable
from of_recording import checks_of
from sample_lift import ringing_lift, sample_rig


def turned(by: float, rig: dict[str, Any] | None = None, slew: float | None = None) -> list[Check]:
    """Checks of the heading [deg] of a load that has turned, below a crane that has slewed [deg]."""
    clock = np.linspace(0.0, 1.0, 2001)
    recording = ringing_lift(load_yaw=math.radians(by) * clock, rig=rig or sample_rig())
    if slew is not None:
        angle = Variable(("time", "crawler"), math.radians(slew) * clock[:, None], "rad", "")
        variables, names = {**recording.variables, "slew_angle": angle}, {"crawler": ("c1",)}
        recording = Recording(variables, {**recording.coordinates, **names}, recording.attributes)
    return checks_of(recording, "load_yaw")


def test_the_load_of_a_yard_turns_round() -> None:
    """202 deg after 300 s."""
    checks = check_recording(gantline.simulate("equalizer_yard"))
    (found,) = (check for check in checks if check.name == "load_yaw")
    assert (found.verdict, found.limit) == (Verdict.WARNING, math.radians(45.0))
    # To a degree: how fast it turns comes of the moments at which corners come off the ground.
    assert found.value == pytest.approx(math.radians(201.8), abs=math.radians(1.0))
    assert outcome_of(checks) is Outcome.GO_WITH_WARNINGS


def test_up_to_an_eighth_of_a_turn_there_is_nothing_to_tell() -> None:
    """The line stands in the table past the bound alone."""
    assert turned(44.9) == [] == turned(-44.9)
    for by in (45.1, -45.1, 700.0):
        (found,) = turned(by)
        assert found.verdict is Verdict.WARNING
        assert found.value == pytest.approx(math.radians(abs(by)))


def test_what_carries_it_may_turn_it() -> None:
    """With a crane that slews by 90 deg a load may turn by 135 deg: tag lines may hold it back."""
    assert turned(134.0, slew=90.0) == [] == turned(-134.0, slew=90.0)
    (found,) = turned(136.0, slew=-90.0)
    assert found.limit == pytest.approx(math.radians(135.0))


def test_who_asks_for_the_heading_has_no_bound() -> None:
    """A limit decides, and so does what a step requires."""
    limited = sample_rig(load_yaw=math.radians(100.0))
    assert [check.verdict for check in turned(90.0, limited)] == [Verdict.OK]
    assert [check.verdict for check in turned(101.0, limited)] == [Verdict.FAILED]
    asked = sample_rig()
    asked["plan"][-1]["require"] = {"load_yaw": {"above": math.radians(80.0)}}
    assert all(check.step for check in turned(90.0, asked))
