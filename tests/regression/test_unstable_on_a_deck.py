"""A module that has been set down on a moored barge, at rest after the start.

Without friction it slides down the deck until its slings hold it, and turns round there. At the start
statics said so, and later "UNSTABLE: one motion leads away" of a load that stands: `--held` it is stable.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from program import called, program

LIFT = """\
format: 1
lift: {title: A module set down on a moored barge}
duration: 60 s
water: {density: 1025 kg/m^3, level: 0 m}
ropes:
  sling: {axial_stiffness: 200 MN, mass: none, minimum_breaking_force: 4000 kN, damping_time: 50 ms}
  moor: {axial_stiffness: 20 MN, mass: none, minimum_breaking_force: 1300 kN}
vessels:
  barge:
    position: [-30 m, 0 m]
    draft: 1.85 m
    hull: {box: [60 m, 20 m, 4.5 m]}
    masses: {hull: {mass: 2000 t, at: [30 m, 0.1 m, 2.8 m]}}
    radii_of_gyration: [6.5 m, 17 m, 17 m]
mooring_lines:
  fore: {vessel: barge, type: spring, fairlead: [60 m, 0 m, 2 m], to: [90 m, 0 m, 2 m], rope: moor,
         pretension: 60 kN}
  aft: {vessel: barge, type: spring, fairlead: [0 m, 0 m, 2 m], to: [-60 m, 0 m, 2 m], rope: moor,
        pretension: 60 kN}
load:
  name: module
  shape: {box: [14 m, 10 m, 8 m]}
  position: [0 m, 0 m, 2.7 m]
  weight: {calculated: 260 t}
  centre_of_gravity: {at: [0 m, 0 m, 3.5 m]}
  lugs:
    A: {at: [-5 m,  4 m, 8 m]}
    B: {at: [ 5 m,  4 m, 8 m]}
    C: {at: [ 5 m, -4 m, 8 m]}
    D: {at: [-5 m, -4 m, 8 m]}
mechanics:
  body_contacts:
    on_deck: {between: [module, barge], stiffness: 100 MN/m, damping: 1 MN s/m, friction: 0.3}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 22.0 m], hoist: {speed: 6 m/min, acceleration: 0.05 m/s^2}}
slings:
  A: {from: hook, to: module.A, length: 13.15 m, rope: sling}
  B: {from: hook, to: module.B, length: 13.15 m, rope: sling}
  C: {from: hook, to: module.C, length: 13.15 m, rope: sling}
  D: {from: hook, to: module.D, length: 13.15 m, rope: sling}
plan:
  - {step: look, hold: 2 s}
  - {step: hold, hold: until_end}
limits: {rule: yard, load_tilt: 5 deg}
"""

SAID = "  module stands where it is unstable, free to slide; --held has friction hold what it can"


@pytest.fixture
def lift(tmp_path: Path) -> Path:
    path = tmp_path / "lift.yaml"
    path.write_text(LIFT, encoding="utf-8")
    return path


def test_an_unstable_rest_of_a_load_that_stands_says_what_holds_it(lift: Path) -> None:
    table = called("statics", lift, "--time", "5 s", "--modes", 0)
    assert "Equilibrium at 5 s: UNSTABLE" in table.stdout
    assert f"contacts without friction\n{SAID}\n" in table.stdout


def test_held_it_is_stable(lift: Path) -> None:
    table = called("statics", lift, "--held", "--time", "5 s", "--modes", 0)
    assert "Equilibrium at 5 s: stable" in table.stdout
    assert SAID not in table.stdout


def test_steps_that_say_how_far_it_slides_say_it_once(lift: Path) -> None:
    assert SAID not in program("statics", lift, "--steps").stdout
