"""The worst of all cases stood for the worst there is, and two margins at once had more.

Each case changes one thing. Of a box on four slings to one hook the corner of its centre of gravity brought a
sling from 337 kN to 374 kN, its lengths to 588 kN, and the table named 588 kN as the worst: both at once
bring it to 613 kN, and nothing said that nobody had looked.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Statics
from program import called

LENGTH, TOLERANCE, ASIDE = 11.456, 0.0025, (0.3, 0.2)
LIFT = f"""\
format: 1
lift: {{title: Four slings}}
duration: 10 s
ropes: {{sling: {{axial_stiffness: 100 MN, mass: none}}}}
load:
  name: box
  shape: {{box: [12 m, 6 m, 4 m]}}
  position: [0 m, 0 m, 5 m]
  weight: {{calculated: 120 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 1.5 m], envelope: [{ASIDE[0]} m, {ASIDE[1]} m, 0 m]}}
  lugs: {{A: {{at: [5 m, 2.5 m, 4 m]}}, B: {{at: [5 m, -2.5 m, 4 m]}}, C: {{at: [-5 m, 2.5 m, 4 m]}},
    D: {{at: [-5 m, -2.5 m, 4 m]}}}}
cranes:
  hook: {{type: fixed_hook, at: [0 m, 0 m, 19 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
sling_defaults: {{rope: sling, length: {LENGTH} m, tolerance: {100 * TOLERANCE} %}}
slings:
  A: {{from: hook, to: box.A}}
  B: {{from: hook, to: box.B}}
  C: {{from: hook, to: box.C}}
  D: {{from: hook, to: box.D}}
plan: [{{step: hang, hold: until_end}}]
cases:
  cog: {{vary: load.centre_of_gravity.envelope, corners: all}}
  lengths: {{vary: slings.tolerance, pattern: worst}}
"""
TOLD = re.compile(r"with cog and lengths at once (\w) bears some ([\d.]+) kN, to first order")


def _said(tmp_path: Path, text: str) -> str:
    path = tmp_path / "lift.yaml"
    path.write_text(text, encoding="utf-8")
    return " ".join(called("cases", path).stdout.split())


def test_what_both_bring_together_is_told(tmp_path: Path) -> None:
    """To first order T + ΔT + ΔT; exactly, the lift with both, that is 2 % less."""
    told = TOLD.search(_said(tmp_path, LIFT))
    assert told is not None
    both = {
        "load.centre_of_gravity.at": f"[{-ASIDE[0]} m, {-ASIDE[1]} m, 1.5 m]",
        **{f"slings.{one}.length": f"{LENGTH * (1 - TOLERANCE)} m" for one in "AD"},
        **{f"slings.{one}.length": f"{LENGTH * (1 + TOLERANCE)} m" for one in "BC"},
    }
    lift = parse_scenario(LIFT)
    given, exact = (Statics(one).equilibrium(5.0) for one in (lift, lift.changed(both)))
    most = max(exact.tension(f"sling.{one}") for one in "ABCD")
    assert float(told[2]) * 1e3 == pytest.approx(most, rel=0.03)
    assert most > 1.8 * given.tension("sling.A")


def test_nothing_is_told_where_one_of_them_adds_nothing(tmp_path: Path) -> None:
    """A centre of gravity within 10 mm brings a thirtieth of the 11 % that 0.3 m bring."""
    near = LIFT.replace(f"envelope: [{ASIDE[0]} m, {ASIDE[1]} m, 0 m]", "envelope: [10 mm, 10 mm, 0 m]")
    assert near != LIFT and "at once" not in _said(tmp_path, near)
