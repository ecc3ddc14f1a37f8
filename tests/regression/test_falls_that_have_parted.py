"""Hoist ropes that broke were a hook run into its crane.

A rope that has parted has no length any more. `hook_falls_margin` took that for falls that had become so
short, `falls of 0.00 m - sheaves of 1.00 m`, and failed for two-blocking, of a hook that fell to the ground.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.checks import Check, Verdict
from gantline.checks.hooks import falls_margin
from gantline.checks.measure import Found, Missing
from gantline.results.recording import Recording
from gantline.results.ropes.parting import while_there
from gantline.results.variable import BoolArray, Variable
from gantline.scenario import parse_scenario
from of_recording import checks_of

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "reeved_hoist" / "scenario.yaml"
ROPES = ["hoist.hook.1", "hoist.hook.2"]
#: Of the sheaves of the hook block [m]; what is between upper sheaves, hook and hook block at the start [m].
SHEAVES, UPPER, HOOK, HOOK_BLOCK = 1.0, 60.0, 16.75, 3.0


@pytest.fixture(scope="module")
def broken() -> Recording:
    """The hoist in 16 parts whose two ropes break at 150 kN, as it lifts off; they carry 144 kN in a lift."""
    text = FILE.read_text(encoding="utf-8")
    short = text.replace("duration: 180 s", "duration: 26 s").replace("emergency_stop_at: 150 s", "by: 1 m")
    weak = short.replace("diameter: 42 mm,", "diameter: 42 mm, breaks_at: 150 kN,")
    return gantline.simulate(parse_scenario(weak))


def margin(recording: Recording) -> Check:
    """The check of it."""
    (found,) = checks_of(recording, "hook_falls_margin")
    return found


def test_it_counts_until_they_part(broken: Recording) -> None:
    """Upper sheaves - hook - hook block - rise up to then - diameter; the falls are plumb."""
    assert [rope for _, kind, rope in broken.events() if kind == "broken"] == ROPES
    whole = while_there(broken, ROPES).all(axis=0)
    height = broken.column("body_position", "hook")[:, 2]
    left = UPPER - HOOK - HOOK_BLOCK - float(height[whole].max() - height[0]) - SHEAVES
    check = margin(broken)
    assert check.value == pytest.approx(left, abs=1e-6)
    assert check.verdict is Verdict.OK


def test_where_all_have_parted_nothing_can_be_said(broken: Recording) -> None:
    """Of the samples after that alone."""
    gone: BoolArray = ~np.asarray(while_there(broken, ROPES).any(axis=0))
    assert list(falls_margin(broken, gone)) == [Missing("hook", "its falls have parted")]
    assert list(falls_margin(broken, np.zeros_like(gone))) == []


def test_falls_that_are_left_count(broken: Recording) -> None:
    """One of two ropes parts after 1.5 s; the falls of the other are 1.5 m long in the end, less 1 m."""
    segments = broken.coordinates["segment"]
    of_first = np.array([name.startswith(ROPES[0]) for name in segments])
    lengths = np.where(of_first, [[3.0], [2.0], [0.0], [0.0]], [[3.0], [2.0], [1.8], [1.5]])
    variables = {
        "time": Variable(("time",), np.array([0.0, 1.0, 2.0, 3.0]), "s", ""),
        "segment_length": Variable(("time", "segment"), lengths, "m", ""),
        "event_time": Variable(("event",), np.array([1.5]), "s", ""),
        "event_kind": Variable(("event",), np.array(["broken"]), "", ""),
        "event_name": Variable(("event",), np.array([ROPES[0]]), "", ""),
    }
    recording = Recording(variables, {"segment": segments}, broken.attributes)
    (found,) = falls_margin(recording, np.ones(4, dtype=np.bool_))
    assert isinstance(found, Found)
    assert found.value == pytest.approx(0.5)
    assert found.time == 3.0
    assert found.formula == "falls of 1.50 m - sheaves of 1.00 m"
