"""The sketches of a load that is raised in a hinge showed it lying, and no stage showed it upright.

They are of the moment in which a load that is turned comes clear. In a hinge it lies then as it lay before:
nothing on the first page told that it is raised. Stages ended at two thirds of its turn, and went on with the
ends of the last steps, after the hinge had let it go.
"""

from __future__ import annotations

import math

import pytest

from gantline.plot.moments import stages
from gantline.report.sketch import sketches
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from hinged_mast import HEAD, mast

LET_GO = """\
  - {step: raise, hoist: main, speed: 6 m/min, until: {load_tilt: {above: 80 deg}}}
  - {step: settle, hold: 20 s}
  - {step: let go, hold: 1 s, open_hinges: foot}
"""


@pytest.fixture(scope="module")
def raised() -> Recording:
    return simulate(parse_scenario(mast(LET_GO)))


def test_the_side_view_shows_it_half_raised(raised: Recording) -> None:
    """From 0 to 80 deg: lug and pins are 39 m apart at 40 deg."""
    side, _ = sketches(Subject(raised))
    (ring,) = (mark for mark in side.marks if mark.style == "sk-hinge")
    (lug,) = (mark for mark in side.marks if mark.style == "sk-lug")
    run, rise = (lug.x - ring.x) * side.scale, (ring.y - lug.y) * side.scale
    assert math.hypot(run, rise) == pytest.approx(HEAD, abs=0.01)
    assert math.degrees(math.atan2(rise, run)) == pytest.approx(40.0, abs=1.5)


def test_a_stage_shows_it_as_the_hinge_opens(raised: Recording) -> None:
    names = [one.name for one in stages(raised)]
    assert "foot opens" in names and "slings taut" not in names
