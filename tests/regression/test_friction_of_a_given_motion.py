"""Dry friction of a joint with a motion given in advance was accepted, and did nothing.

`friction: 1 N m` beside `motion` passed every check, while the core leaves friction out of a driven
joint: it moves as told whatever holds against it, and neither the audit nor any force knew of the
friction. Nothing in a lift file is silently ignored, so it is refused by name.
"""

from __future__ import annotations

import pytest

from gantline.scenario import ScenarioError, parse_scenario

LIFT = """\
format: 1
lift: {title: An arm}
duration: 1 s
mechanics:
  bodies:
    arm:
      mass: 2 kg
      centre_of_gravity: [0 m, 0 m, -1 m]
      joint:
        type: hinge
        axis: [0, 1, 0]
        friction: 1 N m
        motion: [{at: 0 s, duration: 1 s, velocity: 1 deg/s}]
"""


def test_a_given_motion_has_no_friction() -> None:
    with pytest.raises(ScenarioError) as refused:
        parse_scenario(LIFT)
    assert str(refused.value) == (
        "scenario.yaml:12: mechanics.bodies.arm.joint.friction: "
        "a given motion takes place whatever holds against it; leave 'friction' out"
    )


@pytest.mark.parametrize("gone", ["        friction: 1 N m\n", LIFT[LIFT.index("        motion") :]])
def test_each_by_itself_is_right(gone: str) -> None:
    assert parse_scenario(LIFT.replace(gone, "")).mechanics is not None
