"""Mooring lines with a pretension of 40 kN began slack, and no line said so.

A barge lay 0.1 m off her fenders, held by four lines that all lead to the quay. Where the lift begins at
rest she lies against them: two springs of 3 m, which 3 mm leave slack, pulled with 0 kN, and the two others
with 1.9 kN. A run tells of a vessel that starts a metre elsewhere, and here she had moved by a tenth of that.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import parse_scenario

LIFT = """
format: 1
lift: {title: A barge at a quay}
duration: 1 s
water: {density: 1.025 t/m^3, level: -2 m}
ropes: {steel: {axial_stiffness: 50 MN, mass: none, minimum_breaking_force: 900 kN, damping_time: 0.1 s}}
vessels:
  barge:
    position: [-20 m, GAP]
    draft: 2 m
    hull: {box: [40 m, 12 m, 4 m]}
    masses: {hull: {mass: 984 t, at: [20 m, 0 m, 2 m]}}
    radii_of_gyration: [4 m, 11 m, 11 m]
mooring_lines:
  fore: {vessel: barge, fairlead: [40 m, -6 m, 4 m], to: [40 m, -5 m, 0.5 m], rope: steel, PULL, type: spring}
  aft: {vessel: barge, fairlead: [0 m, -6 m, 4 m], to: [-40 m, -5 m, 0.5 m], rope: steel, PULL, type: spring}
fenders:
  f1: {vessel: barge, at: [35 m, -6 m, 2 m], wall: [0 m, 0 m], facing: 90 deg, stiffness: 3 MN/m}
  f2: {vessel: barge, at: [5 m, -6 m, 2 m], wall: [0 m, 0 m], facing: 90 deg, stiffness: 3 MN/m}
"""


def told(gap: str, pull: str = "pretension: 40 kN", start: str = "rest") -> list[str]:
    text = LIFT.replace("GAP", gap).replace("PULL", pull) + f"start: {start}\n"
    found = gantline.simulate(parse_scenario(text))
    return [one for one in found.attributes["warnings"] if "pretension" in one]


def test_lines_that_begin_slack_are_told() -> None:
    """0.2 m to the quay, which lies 14 deg beside them, are 50 mm; 40 kN over 50 MN of 20.7 m are 17 mm."""
    [sentence] = told("6.2 m")
    said = "mooring lines of barge pull less than a tenth of their pretension at the start: fore, aft; "
    assert sentence.startswith(said)


@pytest.mark.parametrize(
    ("gap", "pull", "start"),
    [
        ("6 m", "pretension: 40 kN", "rest"),
        ("6.2 m", "length: 20.6 m", "rest"),
        ("6.2 m", "pretension: 40 kN", "as_given"),
    ],
)
def test_lines_that_keep_their_pull_are_not_told(gap: str, pull: str, start: str) -> None:
    """She lies against her fenders, her lines have a length, or she is where the lift file has her."""
    assert told(gap, pull, start) == []
