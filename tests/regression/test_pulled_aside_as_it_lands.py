"""A stator that was set down straight below its hook had falls 16 deg out of plumb, 813 % of the bound.

Its hook was of `type: fixed_hook`, which stays where falls would lean. As the load stood, two of its four
slings went slack before the others, since one pair was 5 cm longer, and those that still carried pulled
aside. Falls would have come over these two by themselves; a load that hangs beside its hook still counts.
"""

from __future__ import annotations

import copy
import math

import numpy as np
import pytest

import gantline
from gantline.checks import Verdict, hold_points
from gantline.cli.hold_points import hold_points as lines_of
from gantline.results.cranes.pulled_aside import pull_aside
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from hooked_lift import hooked_lift
from of_recording import checks_of

#: Bound past which falls warn where nobody limits them [rad].
BOUND = math.radians(2.0)
LENGTHS = {"A": 5.9, "B": 5.9, "C": 6.0, "D": 6.0}
PLAN = """\
ground: {level: 0 m, friction: 0.5}
plan:
  - {step: hold, hold: 20 s, report: [hook_height, corner_load]}
  - {step: lower, lower: H, speed: 0.1 m/s, by: 0.7 m}
  - {step: stand, hold: until_end}
"""


def landed() -> Recording:
    """A load of 20 t from 0.3 m over the ground on to it."""
    lugs = {"A": (2.0, 1.0, 2.0), "B": (2.0, -1.0, 2.0), "C": (-2.0, 1.0, 2.0), "D": (-2.0, -1.0, 2.0)}
    slings = {name: ("H", name, length) for name, length in LENGTHS.items()}
    text = hooked_lift(
        {"H": (0.0, 0.0, 7.7)},
        lugs,
        slings,
        mass=20e3,
        centre=(0.0, 0.0, 1.0),
        box=(6.0, 4.0, 2.0),
        position=(0.0, 0.0, 0.3),
        more=PLAN,
    )
    text = text.replace("start: as_given", "start: rest").replace("duration: 10 s", "duration: 60 s")
    return gantline.simulate(parse_scenario(text))


@pytest.fixture(scope="module")
def recording() -> Recording:
    return landed()


def test_slings_that_go_slack_one_after_another_are_no_lead(recording: Recording) -> None:
    hook = recording.rig.hooks[0]
    load, aside = recording.column("hook_load", "H"), pull_aside(recording, hook)
    leans = np.arctan2(aside, load)
    bears = load > 0.25 * load.max()
    assert leans[bears].max() > BOUND, "the lift shows nothing otherwise"
    assert not checks_of(recording, "falls_out_of_plumb")


def test_a_load_dragged_aside_of_where_it_hung_counts(
    recording: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same where the lugs are moved by more than 5 cm once it stands."""
    monkeypatch.setattr("gantline.checks.cranes._IN_PLACE", 1e-6)
    # Checks are kept with their recording, and a copy of it has none.
    (found,) = checks_of(copy.copy(recording), "falls_out_of_plumb")
    assert found.verdict is Verdict.WARNING and found.value is not None and found.value > BOUND


def test_hooks_without_falls_are_not_called_nothing(recording: Recording) -> None:
    (point,) = [one for one in hold_points(recording) if one.step.step == "hold"]
    assert point.step.report
    lines = [" ".join(line.split()) for line in lines_of(recording)]
    said = "known of hooks under trolleys and booms; those of this lift stay over their places"
    assert f"hook height {said}" in lines
    assert "corner load nothing in this lift has one" in lines
