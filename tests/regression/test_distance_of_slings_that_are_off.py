"""A watched pair of slings that are off at the end was infinitely far apart: statics ended in a traceback.

`gantline statics --json` and every `gantline cases` of such a lift ended in "Out of range float values are
not JSON compliant: inf"; the table had `clearance_margin inf m`, ok, though nothing was measured, and metrics
had an infinite `smallest_clearance`.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import gantline
from box_on_a_hook import box_on_a_hook
from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from of_recording import checks_of
from verbs import gantline as command

PLAN = """\
  - {step: hold, hold: 3 s}
  - {step: land, lower: hook, speed: 3 m/min, until: {slings: slack}}
  - {step: off, hold: 1 s, detach: [sling.S1, sling.S2]}"""
WATCHED = """\
watch:
  - {between: [slings, box], smallest: 0.1 m}
cases:
  heavy: {set: {load.weight.simulate: design}}
"""
PAIR = "slings - box"


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    path = tmp_path / "lift.yaml"
    path.write_text(box_on_a_hook(PLAN, duration=20.0, more=WATCHED), encoding="utf-8")
    return path


def margin(recording: Recording) -> Check:
    [check] = checks_of(recording, "clearance_margin")
    return check


def test_at_rest_there_is_none(lift: Path) -> None:
    recording = gantline.Statics(lift).equilibrium().recording
    check = margin(recording)
    assert (check.verdict, check.value) == (Verdict.NOT_CHECKED, None)
    assert check.remark == f"its ropes are off or have parted: {PAIR}"
    assert f"smallest_clearance.{PAIR}" not in recording.metrics()


def test_a_run_has_the_smallest_while_they_are_on(lift: Path) -> None:
    """Hook to lug, 1 m aside: the slings stand 1 m of their ends off the load, which is 0.97 m above it."""
    recording = gantline.simulate(lift)
    least = recording.metrics()[f"smallest_clearance.{PAIR}"]
    # Taut the last metre of a sling of 4.2 m whose lug is 1 m aside ends sqrt(1 - (1/4.2)^2) m over the load.
    assert least == pytest.approx((1.0 - (1.0 / 4.2) ** 2) ** 0.5, abs=2e-3)
    assert margin(recording).verdict is Verdict.OK


@pytest.mark.parametrize("verb", ["statics", "cases"])
def test_numbers_are_json(lift: Path, verb: str) -> None:
    found = command(verb, str(lift), "--json")
    assert found.exception is None or isinstance(found.exception, SystemExit), found.exception
    assert json.loads(found.stdout)
