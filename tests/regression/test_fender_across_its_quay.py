"""A fender on the side of a barge whose wall faced along the quay: "in order", and no quay held the barge.

`facing: 0 deg` for 90 put the wall 19 m astern of the point on the side that was to meet it. What was looked
at was whether that point is nearer to the bow or the stern, so that of the same slip fenders in the one half
of the barge were told, and those in the other were not; the barge could be blown through the quay.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import parse_scenario

LENGTH, BREADTH = 50.0, 24.0


def told(at: float, facing: float, wall: str) -> list[str]:
    """Of a fender so far from the stern [m] on the port side of a barge along the quay y = 13 m."""
    text = f"""\
format: 1
lift: {{title: A barge along a quay}}
duration: 1 s
water: {{density: 1025 kg/m^3, level: 0 m}}
vessels:
  barge:
    draft: 2.5 m
    hull: {{box: [{LENGTH} m, {BREADTH} m, 5 m]}}
    masses: {{all: {{mass: 3075 t, at: [25 m, 0 m, 2.5 m]}}}}
    radii_of_gyration: [8 m, 15 m, 16 m]
fenders:
  f: {{vessel: barge, at: [{at} m, {BREADTH / 2} m, 3.5 m], wall: {wall}, facing: {facing} deg,
      thickness: 1 m, stiffness: 3 MN/m}}
plan: [{{step: hold, hold: until_end}}]
"""
    return [doubt.sentence for doubt in assemble(parse_scenario(text)).doubts]


@pytest.mark.parametrize(
    ("at", "facing", "inside"), [(20.0, 0.0, 20.0), (25.0, 0.0, 25.0), (35.0, 180.0, 15.0), (40.0, 0.0, 40.0)]
)
def test_a_wall_that_faces_along_the_side_is_told(at: float, facing: float, inside: float) -> None:
    """From the end that the wall looks at to the fender: of 0 deg the stern, of 180 deg the bow."""
    wall = "[0 m, 13 m]" if facing == 0.0 else f"[{LENGTH} m, 13 m]"
    (sentence,) = told(at, facing, wall)
    assert sentence.startswith(f"fender f has 'at' {inside:g} m inside the hull of barge, seen from its wall")


@pytest.mark.parametrize(
    ("at", "facing", "wall"),
    [(20.0, -90.0, "[0 m, 13 m]"), (42.0, 180.0, "[43 m, 0 m]")],
    ids=["side", "bow"],
)
def test_one_on_the_side_or_near_the_bow_is_not(at: float, facing: float, wall: str) -> None:
    """Up to 10 m behind the outermost point of a bow is where a pointed one has its fenders."""
    assert told(at, facing, wall) == []
