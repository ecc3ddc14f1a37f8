"""A load on the deck of a barge, at rest without friction and held by it.

Statics leaves friction of contacts out unless `--held` asks for it. A module of 180 t on the deck of a cargo
barge slid 6.66 m until its slings held it, heeled the barge by 1.46° and pulled the falls 8° aside; the table
told no more than `contacts without friction`. With `--held` it stood, but beside its slings, 29.6 kN each,
stood the bounds of sheaves of the lift that had slid, 42.0 and 41.9 kN; and their NO-GO made the code 1.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from program import called, program

MODULE_ON_A_BARGE = """
format: 1
lift: {title: A module on a barge}
duration: 10 s
water: {density: 1025 kg/m^3, level: 0 m}
ropes:
  sling: {axial_stiffness: 100 MN, mass: none, minimum_breaking_force: 2000 kN}
  hoist: {axial_stiffness: 60 MN, mass: none, minimum_breaking_force: 900 kN}
vessels:
  barge:
    position: [-30 m, 0 m]
    draft: 1.5 m
    hull: {box: [60 m, 20 m, 4 m]}
    masses: {hull: {mass: 1745 t, at: [30 m, 0.5 m, 2 m]}}
    radii_of_gyration: [6 m, 17 m, 17 m]
load:
  name: module
  shape: {box: [6 m, 4 m, 3 m]}
  position: [0 m, 0 m, 2.5 m]
  weight: {calculated: 100 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  lugs:
    A: {at: [-2 m, 0 m, 3 m]}
    B: {at: [2 m, 0 m, 3 m]}
mechanics:
  body_contacts:
    on_deck: {between: [module, barge], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 15 m]
    block: {mass: 2 t, height: 1 m}
    reeving:
      {ropes: 1, parts_each: 4, rope: hoist, sheave_diameter: 0.8 m,
       sheaves: {efficiency: 0.98, sheave_mass: 80 kg}, upper_sheaves_at: 40 m}
    drum: {diameter: 0.8 m}
    hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}
slings:
  A: {from: hook, to: module.A, length: 11 m, rope: sling}
  B: {from: hook, to: module.B, length: 11 m, rope: sling}
plan:
  - {step: hold, hold: until_end}
limits: {rule: yard, falls_out_of_plumb: 1 deg}
"""


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    """The barge heels to port by its off-centre weight, and the slings have 0.4 m of slack."""
    path = tmp_path / "lift.yaml"
    path.write_text(MODULE_ON_A_BARGE, encoding="utf-8")
    return path


@pytest.mark.parametrize("asked", [("--time", "0 s"), ("--steps",)], ids=["table", "steps"])
def test_statics_says_that_a_load_has_slid(lift: Path, asked: tuple[object, ...]) -> None:
    """On the way to the bottom of the deck it stops where its slings, 11 m and a stretch long, are taut."""
    result = program("statics", lift, *asked)
    found = re.search(
        r"contacts without friction\n  so module slides ([\d.]+) m from where the lift file has it; "
        r"--held has friction hold it",
        result.stdout,
    )
    assert found is not None, result.stdout
    # Bearing at 15 m, lugs at 5.5 m and 2 m to either side, 11 m of sling: sqrt(11^2 - 2^2 - 9.5^2) aside.
    # The falls go along, and the barge, which nothing holds, goes the other way.
    assert float(found[1]) > (11.0**2 - 2.0**2 - 9.5**2) ** 0.5


def test_held_it_has_no_bounds_of_another_place(lift: Path) -> None:
    """Friction of 0.3 holds it on a deck that heels by 1.3°; with the NO-GO of bounds the code was 1.

    It stands, and nothing of it hangs: no verdict, code 4.
    """
    table = called("statics", lift, "--held", "--modes", 0)
    assert table.returncode == 4, table.stdout + table.stderr
    assert "NO VERDICT: 'module' is not lifted" in table.stdout
    assert "slip along" not in table.stdout and "With all sheaves" not in table.stdout
    assert "slides" not in table.stdout
    assert json.loads(called("statics", lift, "--held", "--json").stdout)["bounds"] == []
    free = json.loads(called("statics", lift, "--json").stdout)
    assert len(free["bounds"]) == 2
