"""Fenders on the wrong side of a hull, far off it, or pressed metres deep at the start were "in order".

A wall that faced the wrong way went through the middle of the other vessel, which then began 4 m away, 12
degrees turned, drawn in the same place; the only word was of that place, and none led to the fender.
"""

from __future__ import annotations

import re

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario

FENDER = (
    "at: [40 m, -12 m, 3.5 m], wall: [0 m, 10 m], wall_of: inner, facing: 90 deg, thickness: 1 m, "
    "stiffness: 3 MN/m, capacity: 1 MN"
)
#: `inner` between y = -10 m and 10 m, `outer` between 11 m and 35 m, the fender right between them.
TEXT = f"""\
format: 1
lift: {{title: Two barges}}
duration: 1 s
water: {{density: 1025 kg/m^3, level: 0 m}}
vessels:
  inner:
    draft: 2 m
    hull: {{box: [60 m, 20 m, 4.5 m]}}
    masses: {{all: {{mass: 2460 t, at: [30 m, 0 m, 2 m]}}}}
    radii_of_gyration: [8 m, 17 m, 18 m]
  outer:
    position: [5 m, 23 m]
    draft: 2.5 m
    hull: {{box: [50 m, 24 m, 5 m]}}
    masses: {{all: {{mass: 3075 t, at: [25 m, 0 m, 2.5 m]}}}}
    radii_of_gyration: [8 m, 15 m, 16 m]
fenders:
  f: {{vessel: outer, {FENDER}}}
plan: [{{step: hold, hold: until_end}}]
"""


def spoiled(right: str, wrong: str) -> str:
    assert TEXT.count(right) == 1
    return TEXT.replace(right, wrong)


def test_a_fender_between_two_sides_is_in_order() -> None:
    assert assemble(parse_scenario(TEXT)).doubts == ()
    # At a quay, y = 11 m, the starboard side of `outer` just there.
    assert assemble(parse_scenario(spoiled("wall_of: inner, ", ""))).doubts == ()


@pytest.mark.parametrize(
    ("right", "wrong", "key", "says"),
    [
        (
            "facing: 90 deg",
            "facing: -90 deg",
            "wall",
            "has its wall 20 m inside the hull of inner: 'wall' is",
        ),
        ("wall: [0 m, 10 m]", "wall: [0 m, 33 m]", "wall", "has its wall 23 m off the hull of inner: "),
        ("at: [40 m, -12 m", "at: [40 m, 12 m", "at", "has 'at' 24 m inside the hull of outer, seen from"),
        # Nearer by 3 m than where it only touches; by 0.5 m, 3 MN/m of it.
        (
            "[5 m, 23 m]",
            "[5 m, 20 m]",
            "at",
            "is pressed 3 m deep where the lift file has its vessels, with 9 MN; it is 1 m thick: ",
        ),
        (
            "[5 m, 23 m]",
            "[5 m, 22.5 m]",
            "at",
            "is pressed 0.5 m deep .*, with 1.5 MN; its capacity is 1 MN: ",
        ),
    ],
)
def test_one_that_cannot_well_be_meant_is_doubtful(right: str, wrong: str, key: str, says: str) -> None:
    [doubt] = assemble(parse_scenario(spoiled(right, wrong))).doubts
    assert doubt.path == f"fenders.f.{key}"
    assert re.match(f"fender f {says}", doubt.sentence)


def test_one_far_off_its_vessel_is_refused() -> None:
    """As a fairlead is, 10 m and more from the hull."""
    with pytest.raises(ScenarioError, match=r"fenders\.f\.at: this is 50 m outside the hull of 'outer'"):
        parse_scenario(spoiled("at: [40 m, -12 m", "at: [100 m, -12 m"))
