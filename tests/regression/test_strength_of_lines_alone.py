"""Breaking forces of lines by which nothing hangs made a lift a GO.

A load on a sling without a breaking force, below a lug and a hook without a capacity, is NO VERDICT: nothing
has been held against what bears it. With a tag line of a rope out of a table, or a barge moored beside it, it
was GO WITH WARNINGS: the one rope whose factor on its breaking force was known was that line.
"""

from __future__ import annotations

import pytest

from gantline.checks import Outcome, check_recording, outcome_of, verdict_of
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from lift_text import changed

LIFT = """\
format: 1
lift: {title: Beside a line}
duration: 20 s
start: rest
ground: {level: 0 m}
ropes:
  soft: {axial_stiffness: 100 MN, damping_time: 10 ms}
  line: {construction: 6x36 IWRC, grade: 1770, diameter: 16 mm}
load:
  name: box
  shape: {box: [4 m, 4 m, 2 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0 m, 0 m, 1 m]}
  stands_on: ground
  lugs: {top: {at: [0 m, 0 m, 2 m]}}
cranes:
  hook: {type: fixed_hook, at: [0 m, 0 m, 9 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
slings: {S: {from: hook, to: box.top, length: 7.05 m, rope: soft}}
plan:
  - {step: up, hoist: hook, speed: 1 m/min, until: {supports: clear}}
  - {step: end, hold: until_end}
"""
TAG = "tag_lines: {a: {at: [2 m, 0 m, 1 m], to: [20 m, 0 m, 1 m], rope: line, pull: 0.1 kN}}\n"
MOORED = """\
vessels:
  barge:
    position: [0 m, 60 m]
    draft: 4 m
    hull: {box: [60 m, 20 m, 6 m]}
    masses: {hull: {mass: 4920 t, at: [30 m, 0 m, 3 m]}}
    radii_of_gyration: [6 m, 16 m, 16 m]
mooring_lines:
  bow: {vessel: barge, fairlead: [60 m, 0 m, 6 m], to: [90 m, 60 m, 2 m], rope: line, pretension: 10 kN}
  stern: {vessel: barge, fairlead: [0 m, 0 m, 6 m], to: [-30 m, 60 m, 2 m], rope: line, pretension: 10 kN}
"""


@pytest.mark.parametrize("beside", [TAG, MOORED], ids=["tag line", "mooring line"])
def test_what_nothing_hangs_by_is_no_strength(beside: str) -> None:
    checks = check_recording(simulate(parse_scenario(LIFT + beside)))
    (factor,) = (one for one in checks if one.name == "rope_factor_on_breaking_force")
    assert factor.value is not None
    assert outcome_of(checks) is Outcome.NO_VERDICT
    assert verdict_of(checks).startswith("NO VERDICT: no force has been held against what bears it")


def test_the_strength_of_the_sling_counts_beside_them() -> None:
    known = changed(
        LIFT + TAG, ("damping_time: 10 ms}", "damping_time: 10 ms, minimum_breaking_force: 1 MN}")
    )
    assert outcome_of(check_recording(simulate(parse_scenario(known)))) is Outcome.GO_WITH_WARNINGS
