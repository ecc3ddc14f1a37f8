"""Lift D, a floating crane and two crawler cranes on one load: its lift file, changed, and at rest."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from lift_text import changed, without

FILE = Path(__file__).parents[2] / "scenarios" / "floating_crane_and_crawlers" / "scenario.yaml"
#: Without its cases, each of which is checked wherever the file is read; `gantline cases` is for them.
TEXT = without(FILE.read_text(encoding="utf-8"), "cases")
HOOKS = ("fc.H2", "c1.H", "c2.H")
#: Within 'hold point 2', half of the load on its stands; within 'hold point 4' and at the end, none of it.
HALF, HANGS, END = 205.0, 450.0, 1200.0
LOAD = 560e3
#: Displaced at 4.30 m on even keel [kg]: 105.6 × 46 m of water of 1025 kg/m³.
DISPLACED = 105.6 * 46 * 4.30 * 1025


@cache
def at_rest(time: float, *changes: tuple[str, str]) -> Recording:
    """The lift, changed, at rest at a time of its plan; the last sample is the equilibrium."""
    found = Statics(parse_scenario(changed(TEXT, *changes), str(FILE))).equilibrium(time)
    assert found.is_stable
    return found.recording


def last(recording: Recording, variable: str, name: str) -> float:
    return float(recording.column(variable, name)[-1])


def hook_loads(recording: Recording) -> list[float]:
    return [last(recording, "hook_load", hook) for hook in HOOKS]
