"""Plates of lugs of which the lift file says nothing were taken to stand along x, without a word.

Slings that lean 35 deg along x at lugs without `main_plate` had an angle of 0 deg out of their planes, and
their shackles all of their working load limit, where plates that stand across (`yz`) leave 70 % of it: ok at
70 % of what they use. A lug that nobody has described is a warning now, where its sling leans by more than
shackles bear from aside.
"""

from __future__ import annotations

import math

import pytest

from gantline.checks import Check, Verdict, check_recording
from gantline.scenario import parse_scenario
from gantline.statics import Statics

#: Height of the hook over its lugs, and their distance from the middle [m].
_HEIGHT = 10.0


def checks(lean: float, plate: str = "", types: str = "", *, shackles: bool = True) -> dict[str, Check]:
    """Of 40 t on two slings that lean by so much along x [deg]."""
    gear = ", shackles: {top: wb, bottom: wb}" if shackles else ""
    away = _HEIGHT * math.tan(math.radians(lean))
    length = math.hypot(_HEIGHT, away)
    said = f"""\
format: 1
lift: {{title: Two slings that lean}}
duration: 1 s
ropes:
  steel: {{axial_stiffness: 60 MN, damping_time: 10 ms, mass: none, diameter: 44 mm}}
shackles: {{wb: {{working_load_limit: 35 t, mass: 0 kg}}}}
{types}load:
  name: box
  shape: {{box: [20 m, 4 m, 2 m]}}
  position: [0 m, 0 m, 0 m]
  weight: {{calculated: 40 t, contingency: 1.0}}
  centre_of_gravity: {{at: [0 m, 0 m, 1 m]}}
  lugs:
    A: {{at: [{away} m, 0 m, 2 m]{plate}}}
    B: {{at: [{-away} m, 0 m, 2 m]{plate}}}
cranes:
  hook:
    {{type: fixed_hook, at: [0 m, 0 m, {_HEIGHT + 2} m], hoist: {{speed: 1 m/min, acceleration: 1 m/s^2}}}}
slings:
  A: {{from: hook, to: box.A, length: {length} m, rope: steel{gear}}}
  B: {{from: hook, to: box.B, length: {length} m, rope: steel{gear}}}
"""
    recording = Statics(parse_scenario(said, "lift.yaml")).equilibrium().recording
    return {check.name: check for check in check_recording(recording)}


def test_a_plate_that_stands_across_takes_a_third_of_a_shackle() -> None:
    """At 35 deg aside 70 % are left; 0027/ND and the chart of Crosby."""
    name = "shackle_load_of_working_load_limit"
    along, across = (checks(35.0, f", main_plate: {plate}")[name].value for plate in ("xz", "yz"))
    assert along is not None and across is not None
    assert across / along == pytest.approx(1.0 / 0.70, rel=1e-9)


@pytest.mark.parametrize(("lean", "verdict"), [(35.0, Verdict.WARNING), (8.0, Verdict.NOT_CHECKED)])
def test_who_says_nothing_is_told(lean: float, verdict: Verdict) -> None:
    """Up to 10 deg a shackle bears it from any side."""
    check = checks(lean)["lug_out_of_plane_angle"]
    assert check.verdict is verdict
    assert ("'main_plate' not said, xz assumed" in check.remark) is (verdict is Verdict.WARNING)


@pytest.mark.parametrize(
    ("plate", "types"),
    [
        (", main_plate: xz", ""),
        (", main_plate: {turned: 15 deg}", ""),
        (", type: PL", "lug_types: {PL: {main_plate: xz}}\n"),
    ],
)
def test_who_says_it_is_not(plate: str, types: str) -> None:
    """Of the lug, or of its type."""
    assert checks(35.0, plate, types)["lug_out_of_plane_angle"].verdict is Verdict.NOT_CHECKED


def test_a_type_that_says_nothing_either() -> None:
    """A capacity is no plane."""
    told = checks(35.0, ", type: PL", "lug_types: {PL: {capacity: 50 t}}\n")["lug_out_of_plane_angle"]
    assert told.verdict is Verdict.WARNING


def test_without_shackles_it_matters_to_a_limit_alone() -> None:
    """Then nothing that is held against anything rests on how the plate stands."""
    name = "lug_out_of_plane_angle"
    assert checks(35.0, shackles=False)[name].verdict is Verdict.NOT_CHECKED
    limited = checks(35.0, types="limits: {lug_out_of_plane_angle: 10 deg}\n", shackles=False)[name]
    # Both slings lie in the plane in which the plate is taken to stand.
    assert limited.value == pytest.approx(0.0, abs=1e-9)
    assert limited.verdict is Verdict.WARNING
