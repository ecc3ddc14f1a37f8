"""Steps that go side by side and begin at different times.

A step `with_previous` may have a `start_at` of its own. Everything that asked which steps were under way took
each for over as the next began: a trolley that went on for 40 m while a hoist began at 10 s left 35 m of
"drift" of a load that hung plumb under it; a load that it drove into a wall then came down "in" no step at
all, the timelines of report and player ended with the hoist, and what a vessel came to "at the end" of a step
was what it came to as the next began.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from gantline.checks import Verdict
from gantline.checks.plan import came_down
from gantline.results.progress import spans, stretches
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from goliath_lift import goliath_lift

#: 40 m at 0.5 m/s with ramps of 0.03 m/s^2; a hoist from 10 s on, 1 m at 0.1 m/s with ramps of 0.05 m/s^2.
_OVER, _UP = 40 / 0.5 + 0.5 / 0.03, (10.0, 10 + 1 / 0.1 + 0.1 / 0.05)
_PLAN = """\
{step: over, traverse: one, speed: 30 m/min, by: 40 m}
{step: up, hoist: A, starts: with_previous, start_at: 10 s, speed: 6 m/min, by: 1 m}
{step: hold, hold: until_end}"""


def lift() -> Recording:
    return simulate(parse_scenario(goliath_lift(_PLAN, duration=110.0)))


def test_a_step_goes_on_while_another_begins() -> None:
    recording = lift()
    assert spans(recording) == {
        "over": pytest.approx((0.0, _OVER)),
        "up": pytest.approx(_UP),
        "hold": pytest.approx((_OVER, 110.0)),
    }
    found = stretches(recording)
    assert [one.name for one in found] == ["over", "over + up", "hold"]
    ends = [(0.0, 10.0), (10.0, _OVER), (_OVER, 110.0)]
    assert [end for one in found for end in (one.begin, one.end)] == pytest.approx(np.ravel(ends))


def test_a_load_that_is_driven_into_a_wall_is_told() -> None:
    """The step that drives it goes alone by then, though it was not the last to begin."""
    recording = lift()
    met = [(50.0, "set_down", "block")]
    attributes = dict(recording.attributes)
    attributes["rig"] = {**attributes["rig"], "loads": [{"name": "block", "body": "gol.A", "weight": 1.0}]}
    events = sorted([*recording.events(), *met])
    kinds = {"event_time": 0, "event_kind": 1, "event_name": 2}
    variables = dict(recording.variables)
    for name, place in kinds.items():
        values = np.array([event[place] for event in events])
        variables[name] = dataclasses.replace(variables[name], values=values)
    (found,) = came_down(Recording(variables, recording.coordinates, attributes))
    assert (found.name, found.verdict, found.time) == ("stays_clear", Verdict.FAILED, 50.0)
    assert found.remark == "it runs into what is in its way in 'over', which does not lower it"
