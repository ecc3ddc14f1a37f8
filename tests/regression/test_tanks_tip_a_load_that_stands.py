"""A load whose tanks tip it over the edge of its stools, into its slings, was told nothing of.

100 t stand on four stools 1.5 m to either side of the middle; 52 t are pumped into a tank 4.4 m from there,
which has the centre of gravity of both 5 mm beyond the stools. It turns about the stools at that end until
its slings hold it, with 2.5 % of its weight: a GO, with a limit of tilt of 5 deg. `stands_by_itself` looked
at loads alone that a step had set down, and no more at these once anything was pumped after that; and at
none at rest.
"""

from __future__ import annotations

import math

import pytest

from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.statics import Statics
from lift_text import changed
from of_recording import check_of, checks_of

#: What the load weighs and what is pumped [t], and where its tank is, along it [m].
_LOAD, _PUMPED, _TANK = 100.0, 52.0, 4.4
#: Stools to either side of the middle, and half of their tops [m].
_STOOLS, _HALF = 1.5, 0.25
_LIFT = f"""\
format: 1
lift: {{title: A load with a tank on its stools}}
duration: 140 s
ground: {{level: 0 m, friction: 0.4}}
water: {{density: 1025 kg/m^3, level: -5 m}}
ropes:
  sling: {{axial_stiffness: 60 MN, damping_time: 20 ms, minimum_breaking_force: 2500 kN, mass: none}}
load:
  name: box
  shape: {{box: [12 m, 6 m, 4 m]}}
  position: [0 m, 0 m, 1 m]
  weight: {{calculated: {_LOAD} t}}
  centre_of_gravity: {{at: [0 m, 0 m, 2 m]}}
  stands_on: stools
  tanks:
    fore: {{box: [3 m, 5 m, 3.5 m], bottom: [{_TANK} m, 0 m, 0.2 m], content: 0}}
  lugs:
    A: {{at: [-4 m,  2 m, 4 m], capacity: 80 t}}
    B: {{at: [ 4 m,  2 m, 4 m], capacity: 80 t}}
    C: {{at: [ 4 m, -2 m, 4 m], capacity: 80 t}}
    D: {{at: [-4 m, -2 m, 4 m], capacity: 80 t}}
supports:
  stools:
    under: box
    grid: {{x: [-{_STOOLS} m, {_STOOLS} m], y: [-2 m, 2 m]}}
    height: 1 m
    top: [{2 * _HALF} m, 0.5 m]
    stiffness: 500 MN/m
    damping: 5 MN s/m
    friction: 0.4
    capacity: 120 t
cranes:
  crane:
    {{type: fixed_hook, at: [0 m, 0 m, 20 m], rated_capacity: 250 t,
      hoist: {{speed: 4 m/min, acceleration: 0.02 m/s^2}}}}
sling_defaults: {{rope: sling, length: 15.8 m}}
slings:
  A: {{from: crane, to: box.A}}
  B: {{from: crane, to: box.B}}
  C: {{from: crane, to: box.C}}
  D: {{from: crane, to: box.D}}
plan:
  - {{step: stand, hold: 5 s}}
  - {{step: fill, pump: {{from: sea, to: box.fore}}, rate: 2000 t/h, by: {_PUMPED} t}}
  - {{step: look, hold: until_end}}
limits: {{load_tilt: 5 deg}}
"""
_NAME = "stands_by_itself"


def _run(*changes: tuple[str, str]) -> Recording:
    return simulate(parse_scenario(changed(_LIFT, *changes), "lift.yaml"))


def _held(*changes: tuple[str, str]) -> Recording:
    """At rest at its end, friction holding."""
    question = Statics(parse_scenario(changed(_LIFT, *changes), "lift.yaml"))
    return question.equilibrium(losses="held").recording


def _centre(pumped: float) -> float:
    """Of load and content, along the load as it stands [m]."""
    return pumped * _TANK / (_LOAD + pumped)


@pytest.mark.parametrize("found", [_run, _held])
def test_it_leans_in_its_slings(found) -> None:  # type: ignore[no-untyped-def]
    """Its centre of gravity comes to 1.505 m: within the tops of the stools, and beyond where these bear."""
    assert _STOOLS < _centre(_PUMPED) < _STOOLS + _HALF
    recording = found()
    check = check_of(recording, _NAME)
    tilt = math.degrees(float(recording.column("load_tilt", "box")[-1]))
    assert tilt > 1.0
    assert f"standing from the start, it has tilted by {tilt:.2f} deg more since" in check.remark
    assert "with what is in its tanks" in check.remark


@pytest.mark.parametrize("found", [_run, _held])
def test_what_stands_is_not_told(found) -> None:  # type: ignore[no-untyped-def]
    """Of 40 t in the tank the centre of gravity stays within the stools, at 1.26 m."""
    assert _centre(40.0) < _STOOLS
    recording = found((f"by: {_PUMPED} t", "by: 40 t"))
    assert recording.column("load_transferred", "box")[-1] == pytest.approx(0.0, abs=1e-6)
    assert checks_of(recording, _NAME) == []


def test_what_a_plan_hoists_is_not_told() -> None:
    """Lifted at one end first it leans as it is meant to."""
    up = "  - {step: up, hoist: crane, speed: 1 m/min, by: 0.35 m}\n"
    plan = "  - {step: look, hold: until_end}\n"
    assert checks_of(_run((plan, up + plan)), _NAME) == []
