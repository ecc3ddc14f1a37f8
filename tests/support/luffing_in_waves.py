"""The crane barge of the scenario `crane_barge_in_swell`, whose boom follows what a quay hook upends."""

from __future__ import annotations

import re
from importlib.resources import files

from gantline.scenario import Scenario, parse_scenario
from lift_text import changed

_BARGE = files("gantline.scenarios") / "crane_barge_in_swell.yaml"

_COLUMN = """\
load:
  name: column
  shape: {box: [20 m, 3 m, 3 m]}
  datum: bottom_centre
  position: [116.7 m, 0 m, 10.9 m]
  weight: {calculated: 120 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  lugs: {a: {at: [-9.5 m, 0 m, 1.5 m]}, b: {at: [9.5 m, 0 m, 1.5 m]}}
"""
_QUAY = """\
cranes:
  quay:
    type: fixed_hook
    at: [126.2 m, 0 m, 30 m]
    rated_capacity: 300 t
    rating_includes_hook_block: false
    hoist: {speed: 6 m/min, acceleration: 0.02 m/s^2}
"""
_SLINGS_AND_PLAN = """\
slings:
  A: {from: sheerleg.H1, to: column.a, length: 17.6 m}
  B: {from: quay, to: column.b, length: 17.6 m}
plan:
  - {step: wait, hold: 60 s}
  - {step: upend, hoist: quay, speed: 3 m/min, by: 6 m}
  - {step: follow, luff: sheerleg, starts: with_previous, speed: 12 deg/min, keep_plumb: sheerleg.H1}
  - {step: rest, hold: until_end}
"""


def in_waves(waves: str) -> Scenario:
    """A column upended beside a barge in these waves, the entries of `waves`."""
    text = _BARGE.read_text(encoding="utf-8")
    for section, instead in (
        ("plan", ""),
        ("load", _COLUMN),
        ("slings", _SLINGS_AND_PLAN),
        ("watch", ""),
        ("cases", ""),
        ("limits", ""),
        ("waves", f"waves: {{{waves}}}\n"),
    ):
        text, count = re.subn(
            rf"^{section}:.*?(?=^\w)", instead, text, count=1, flags=re.DOTALL | re.MULTILINE
        )
        assert count == 1, section
    text = changed(
        text,
        ("cranes:\n", _QUAY),
        ("duration: 300 s", "duration: 400 s"),
        ("speed: 1 deg/min\n      acceleration: 0.01", "speed: 12 deg/min\n      acceleration: 0.05"),
    )
    return parse_scenario(text, str(_BARGE))
