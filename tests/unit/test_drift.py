"""Drift of a load: what the plan takes along is none, all else is."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gantline.results.loads.drift import is_taken_along, load_drift
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.results.variable import FloatArray, Variable

TIME = np.arange(7.0)
#: The trolley goes 10 m a second from 2 s to 4 s, and by itself another metre from 5 s to 6 s.
TROLLEY = np.array([0.0, 0.0, 0.0, 10.0, 20.0, 20.0, 21.0])


def lift(
    way: FloatArray,
    kind: str = "traverse",
    supported: FloatArray | None = None,
    more: tuple[tuple[float, str, str], ...] = (),
) -> Recording:
    """A load that goes this way along x under one trolley, whose step goes from 2 s to 4 s."""
    zero = np.zeros_like(TIME)
    place = np.stack([np.stack([x, zero, zero], axis=1) for x in (way, TROLLEY)], axis=1)
    events = sorted([(2.0, "step_begin", "go"), (4.0, "step_end", "go"), *more])
    variables = {
        "time": Variable(("time",), TIME, "s", ""),
        "body_position": Variable(("time", "body", "xyz"), place, "m", ""),
        "body_orientation": Variable(
            ("time", "body", "wxyz"), np.tile([1.0, 0.0, 0.0, 0.0], (len(TIME), 2, 1)), "1", ""
        ),
        "hook_load": Variable(("time", "hook"), np.full((len(TIME), 1), 1e6), "N", ""),
        "contact_force": Variable(
            ("time", "contact"), (zero if supported is None else supported)[:, None], "N", ""
        ),
        "event_time": Variable(("event",), np.array([time for time, _, _ in events]), "s", ""),
        "event_kind": Variable(("event",), np.array([kind for _, kind, _ in events]), "1", ""),
        "event_name": Variable(("event",), np.array([name for _, _, name in events]), "1", ""),
    }
    hook = {"name": "c.h", "top": "c.h/top"}
    rig: dict[str, Any] = {
        "loads": [{"name": "load", "body": "load", "weight": 1e6, "contacts": ["corner"]}],
        "hooks": [{"name": "c.h"}],
        "cranes": [{"name": "c", "trolleys": [{"name": "c.t", "hooks": [hook]}]}],
        "plan": [{"step": "go", "kind": kind}, {"step": "up", "kind": "hoist"}],
    }
    names = {"body": ["load", "c.h/top"], "hook": ["c.h"], "contact": ["corner"], "xyz": ["x", "y", "z"]}
    return Recording(variables, names, {"rig": rig})


def drift(recording: Recording) -> FloatArray:
    return load_drift(recording, recording.rig.loads[0])


def test_a_load_that_goes_with_its_trolley_does_not_drift() -> None:
    assert drift(lift(np.minimum(TROLLEY, 20.0))) == pytest.approx(0.0)


def test_what_a_load_swings_off_its_trolley_is_drift() -> None:
    swings = np.array([0.0, 0.3, 0.3, 0.1, -0.2, 0.4, 0.0])
    assert drift(lift(np.minimum(TROLLEY, 20.0) + swings)) == pytest.approx(np.abs(swings))


def test_what_a_crane_does_outside_of_such_steps_is_drift() -> None:
    """A metre after the end of the step; and all of it in a step that hoists."""
    assert drift(lift(TROLLEY)) == pytest.approx([0, 0, 0, 0, 0, 0, 1])
    assert drift(lift(TROLLEY, kind="hoist")) == pytest.approx(TROLLEY)
    assert not is_taken_along(lift(TROLLEY, kind="hoist").rig)
    assert is_taken_along(lift(TROLLEY).rig)


def test_chain_hoists_take_no_load_along() -> None:
    """A step that hauls mooring lines does; one that hauls chain hoists of slings moves loads below hooks."""
    rig = lift(TROLLEY, kind="haul").attributes["rig"]
    chain = {"name": "S1", "joint": "sling.S1.chain_hoist"}
    plan = [{"step": "go", "kind": "haul", "drives": ["sling.S1.chain_hoist.drive"]}]
    assert is_taken_along(Rig.from_json(rig))
    assert not is_taken_along(Rig.from_json({**rig, "plan": plan, "chain_hoists": [chain]}))
    beside = [{**plan[0], "drives": ["mooring.bow.winch.drive", *plan[0]["drives"]]}]
    assert is_taken_along(Rig.from_json({**rig, "plan": beside, "chain_hoists": [chain]}))


def test_a_load_that_stands_is_not_taken_along() -> None:
    """Slack hooks that go over it leave it where it stands."""
    assert drift(lift(np.zeros(7), supported=np.full(7, 1e6))) == pytest.approx(0.0)


def test_a_step_takes_along_until_its_own_end() -> None:
    """A hoist that begins beside it, a second after, and ends before or after it changes nothing."""
    for end in (3.5, 6.0):
        recording = lift(TROLLEY, more=((3.0, "step_begin", "up"), (end, "step_end", "up")))
        assert drift(recording) == pytest.approx([0, 0, 0, 0, 0, 0, 1])
