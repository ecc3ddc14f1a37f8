"""A load whose own x axis is upright has no heading, and `gantline statics --json` gives none.

It gave that of what rounding had left of a level axis: of the upended pile of `monopile` −90° without losses,
−36.87° and 0° between the bounds of them, and others in other units or with slings in another order.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from verbs import gantline

#: A bar on one sling at a lug of its end, at a height that is that of its centre of gravity or not.
BAR = """
format: 1
lift: {{title: A bar}}
duration: 1 s
ropes: {{sling: {{axial_stiffness: 100 MN, damping_time: 5 ms, mass: none}}}}
load:
  name: bar
  shape: {{box: [8 m, 1 m, 1 m]}}
  position: [0 m, 0 m, 0 m]
  heading: 40 deg
  weight: {{calculated: 8 t}}
  centre_of_gravity: {{at: [0 m, 0 m, 0.5 m]}}
  lugs: {{end: {{at: [4 m, 0 m, {height}], main_plate: xz, capacity: 20 t}}}}
cranes: {{hook: {{type: fixed_hook, at: [3 m, 2.5 m, 8 m], rated_capacity: 20 t,
  hoist: {{speed: 0.1 m/s, acceleration: 0.1 m/s^2}}}}}}
slings: {{S: {{from: hook, to: bar.end, length: 8 m, rope: sling}}}}
plan:
  - {{step: hold, hold: until_end}}
"""


@pytest.mark.parametrize(("height", "is_upright"), [("0.5 m", True), ("0.9 m", False)])
def test_only_what_leans_has_one(height: str, is_upright: bool, tmp_path: Path) -> None:
    """The lug comes plumb over the centre of gravity: with both on its axis that axis is upright, and with
    the lug 0.4 m beside, it leans by atan(0.4 / 4).
    """
    lift = tmp_path / "lift.yaml"
    lift.write_text(BAR.format(height=height), encoding="utf-8")
    found = json.loads(gantline("statics", str(lift), "--json").stdout)
    assert (found["load_heading"]["bar"] is None) == is_upright
