"""Mooring lines to bollards inside a quay passed without a word.

Bollards at a height of -2 m, 20 m behind the face of a quay whose top is at 3 m, held a barge by lines that
ran through the quay: a sign, or heights that count from another zero.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario

_LIFT = """\
format: 1
lift: {title: A barge at a quay}
duration: 10 s
start: rest
water: {density: 1025 kg/m^3, level: 0 m}
ropes:
  nylon: {axial_stiffness: 4 MN, minimum_breaking_force: 800 kN, mass: none}
structures:
  quay: {type: box, x: [-50 m, 150 m], y: [20 m, 60 m], z: [-12 m, 3 m]}
vessels:
  barge:
    draft: 3 m
    hull: {box: [90 m, 30 m, 6.5 m]}
    masses: {hull: {mass: 8302.5 t, at: [45 m, 0 m, 3 m]}}
    radii_of_gyration: [10 m, 26 m, 27 m]
mooring_lines:
  bow:
    {vessel: barge, fairlead: [88 m, 14 m, 6.5 m], to: BOLLARD, rope: nylon, pretension: 60 kN, type: spring}
plan:
  - {step: hold, hold: until_end}
"""


@pytest.mark.parametrize(
    ("bollard", "below"),
    [
        ("[100 m, 40 m, 3.2 m]", None),  # on the quay
        ("[100 m, 40 m, 2.5 m]", None),  # in a pit of it
        ("[100 m, 20.5 m, 0.5 m]", None),  # a hook in a recess of its face
        ("[100 m, 40 m, -2 m]", "5.0 m"),
    ],
)
def test_a_line_that_ends_inside_a_quay(bollard: str, below: str | None) -> None:
    lift = parse_scenario(_LIFT.replace("BOLLARD", bollard))
    doubts = [f"{one.path}: {one.sentence}" for one in assemble(lift).doubts]
    line = "mooring_lines.bow.to: mooring line bow"
    said = f"{line} ends inside quay, {below} below its top, as no bollard stands"
    assert doubts == ([said] if below else [])
