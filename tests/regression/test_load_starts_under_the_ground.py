"""A manifold that hung 87 m under the ground at the start was in order for `gantline check`.

The sea bed was at `level: 90 m`, a sign short, and a load that stands on nothing was not looked at. Its run
began 87 m higher, slings plumb downwards, and told of that alone.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import load_scenario, parse_scenario
from hung_box import hung_box

LIFT = (
    """\
format: 1
lift: {title: A box hangs}
duration: 10 s
water: {level: 0 m}
ground: {level: LEVEL, friction: 0.5}
ropes: {sling: {axial_stiffness: 100 MN, damping_time: 20 ms}}
"""
    + hung_box(
        "0 m, 0 m, 3 m",
        "0 m, 0 m, 10 m",
        "speed: 3 m/min, acceleration: 0.5 m/s^2",
        size="4 m, 2 m, 2 m",
        rope="sling",
    )
    + """\
plan:
  - {step: hang, hold: until_end}
"""
)


def doubts(level: str) -> list[str]:
    lift = parse_scenario(LIFT.replace("LEVEL", level))
    return [one for one in assemble(lift).warnings if "which pushes it up" in one]


def test_a_load_deep_in_the_ground_is_told() -> None:
    [doubt] = doubts("90 m")
    assert "box starts 87 m under the ground, which pushes it up" in doubt
    assert "a sea bed has a negative one where the water is at 0" in doubt


@pytest.mark.parametrize("level", ["-90 m", "0 m", "3.05 m"])
def test_one_that_hangs_above_it_or_touches_it_is_in_order(level: str) -> None:
    assert doubts(level) == []


def test_one_in_a_dock_is_in_order() -> None:
    """The barge of `off_a_barge` floats below the level of the quay."""
    found = assemble(load_scenario("off_a_barge")).warnings
    assert not [one for one in found if "which pushes it up" in one]
