"""Bounds of sheaves that slip one way, of a load that stands, beside the equilibrium of one that hangs.

Each bound follows the plan by itself. Where a step waits for the load to come clear, an equalizer whose
sheaves all slip one way tilts the load, and a corner stands longer: at the end of the plan the bound was
still in its first step. `gantline statics` showed what slings carried there as what they may carry in the
lift.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gantline.cli.app import app

LIFT = """\
format: 1
lift: {title: Seized sheaves}
duration: DURATION s
start: rest
ground: {level: 0 m, friction: 0.4}
ropes:
  sling: {axial_stiffness: 300 MN, damping_time: 10 ms, mass: none}
  eq: {axial_stiffness: 100 MN, damping_time: 10 ms, mass: 8 kg/m}
load:
  name: module
  shape: {box: [8 m, 4 m, 3 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 80 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  stands_on: ground
  lugs: {L1: {at: [-2 m, 0 m, 3 m]}, L2: {at: [2 m, 0 m, 3 m]}}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 17.9 m], hoist: {speed: 12 m/min, acceleration: 0.1 m/s^2}}
equalizers:
  e1:
    hangs_from: hook
    heading: 0 deg
    frame: {mass: 4 t, length: 5 m, width: 1 m, height: 2 m, centre_of_gravity_below_hook: 3 m,
      inertia_about_vertical: 8000 kg m^2}
    hinge: {axis: vertical, friction: 1 kN m, damping: 0 kN m s}
    rope: eq
    sheaves: {bearing: seized, groove_friction: 0.1}
    rope_ends:      {along: [-2.4 m, 2.4 m], below_hook: 4 m}
    fixed_sheaves:  {along: [0 m], below_hook: 4 m, pitch_diameter: 3.2 m}
    moving_sheaves: {along: [-2 m, 2 m], below_hook: 7 m, pitch_diameter: 0.8 m, mass: 200 kg,
      guided: vertical}
    travel: {up: 1 m, down: 1 m}
slings:
  S1: {from: e1.1, to: module.L1, length: 8 m, rope: sling}
  S2: {from: e1.2, to: module.L2, length: 8 m, rope: sling}
plan:
  - {step: lift off, hoist: hook, speed: 0.5 m/min, until: {supports: clear}}
  - {step: end, hold: until_end}
"""


@pytest.mark.parametrize(("duration", "still"), [(60, ["module"]), (400, [])])
def test_a_load_that_still_stands_in_a_bound_is_told(tmp_path: Path, duration: int, still: list[str]) -> None:
    """Spans go by exp(0.1 pi), and slings by exp(0.2 pi) = 1.87: they pull 0.61 m off the middle.

    With lugs 2 m above its centre of gravity it tilts by atan(0.61/2) = 17 deg before it hangs, its middle
    4 m sin(17 deg) = 1.2 m up, at 0.5 m/min no sooner than after 140 s.
    """
    lift = tmp_path / "lift.yaml"
    lift.write_text(LIFT.replace("DURATION", str(duration)), encoding="utf-8")
    said = CliRunner().invoke(app, ["statics", str(lift), "--json"]).stdout
    assert [one["still_standing"] for one in json.loads(said)["bounds"]] == [still, still]
    shown = " ".join(CliRunner().invoke(app, ["statics", str(lift)]).stdout.split())
    assert ("module still stands in that, at 60 s" in shown) is bool(still)
