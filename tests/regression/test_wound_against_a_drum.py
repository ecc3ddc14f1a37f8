"""Rope that is wound against the rest of a drum ran off it without a word.

`wraps_at_start` are the turns of each rope, and a drum counted them one way: what it hauled in for one rope
it paid out for the other, whose turns nothing counted. 3 turns, 12 m hauled in on 0.8 m: 1.8 turns more than
there were came off, and what hung there would have fallen, in a run without a check. The other way round, a
drum whose only rope is wound against failed for turns that it gained.
"""

from __future__ import annotations

import math

import pytest

import gantline
from gantline.checks import Check, Verdict
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from of_recording import checks_of

DIAMETER, WAY = 0.8, 12.0
TURNS = WAY / (math.pi * DIAMETER)


def run(step: str, start: float, *, with_it: bool = True) -> Recording:
    """A load and its counterweight on one shaft, or the counterweight alone."""
    ends = "[{type: end, body: world, drum: winch}, {type: end, body: load}]"
    load = f"a: {{rope: r, length: as_routed, route: {ends}}}"
    text = f"""\
format: 1
lift: {{title: Two ropes on one shaft}}
duration: 40 s
ropes: {{r: {{axial_stiffness: 36 MN, damping_time: 20 ms, diameter: 20 mm}}}}
mechanics:
  bodies:
    load: {{at: [0 m, 0 m, -20 m], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 10 t}}
    counter: {{at: [5 m, 0 m, -30 m], joint: {{type: slider, axis: [0, 0, 1]}}, mass: 2 t}}
  drums:
    winch: {{diameter: {DIAMETER} m, rotating_mass: 2 t, wraps_at_start: {start},
      drive: {{speed: 60 m/min, acceleration: 0.2 m/s^2}}}}
  ropes:
    {load if with_it else ""}
    b: {{rope: r, length: as_routed, route: [
      {{type: end, body: world, at: [5 m, 0 m, 0 m], drum: winch, wound: against}},
      {{type: end, body: counter}}]}}
plan:
  - {{step: turn, {step}: winch, speed: 30 m/min, by: {WAY} m}}
  - {{step: wait, hold: until_end}}
"""
    return gantline.simulate(parse_scenario(text))


def turns_on_drum(recording: Recording) -> list[Check]:
    return checks_of(recording, "turns_on_drum")


def test_rope_wound_against_runs_off_as_the_drum_hauls_in() -> None:
    found = run("haul_in", 3.0)
    # The drum turns as far as its drive, which ends where it should to rounding.
    assert found.column("drum_wraps", "winch")[-1] == pytest.approx(3.0 + TURNS, abs=1e-9)
    assert found.column("drum_wraps", "winch/against")[-1] == pytest.approx(3.0 - TURNS, abs=1e-9)
    assert found.column("rope_paid_out", "winch/against")[-1] == pytest.approx(WAY, abs=1e-9)
    (check,) = turns_on_drum(found)
    assert (check.verdict, check.element) == (Verdict.FAILED, "winch/against")


def test_rope_wound_with_the_drum_runs_off_as_it_pays_out() -> None:
    (check,) = turns_on_drum(run("pay_out", 3.0))
    assert (check.verdict, check.element) == (Verdict.FAILED, "winch")


def test_turns_that_a_drum_gains_are_no_failure() -> None:
    assert turns_on_drum(run("pay_out", 3.0, with_it=False)) == []
    (check,) = turns_on_drum(run("haul_in", 3.0, with_it=False))
    assert check.element == "winch/against"
