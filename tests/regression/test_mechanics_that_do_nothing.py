"""Parts of `mechanics` that could do nothing passed every check, or failed in the first step without a line.

A `centre_of_gravity` without `mass` is a forgotten mass: the body weighed nothing, and nothing was said. A
contact of a body that stands still pushed it against its plane, both of the world; a `motion` that begins
after the end of the lift never came, while a cut at such a time was refused. An inextensible rope between two
places of one body ended with "the equations are singular here", which named neither line nor cause.
"""

from __future__ import annotations

import pytest

import gantline

LIFT = """
format: 1
lift: {title: An arm on a post}
duration: 2 s
ropes:
  thin: {inextensible: true}
  thick: {axial_stiffness: 1 MN}
mechanics:
  bodies:
    post: {joint: {type: fixed}}
    bracket: {parent: post, at: [0 m, 0 m, 3 m], joint: {type: fixed}}
    arm: {at: [1 m, 0, 3 m], joint: {type: hinge, axis: [0, 1, 0]}, mass: 8 t, centre_of_gravity: [1 m, 0, 0]}
    tip: {parent: arm, at: [2 m, 0 m, 0 m], joint: {type: fixed}, mass: 2 kg}
    foot: {parent: tip, joint: {type: slider, axis: [0, 0, 1]}, mass: 1 kg}
  ropes:
    stay: {rope: thin, length: as_routed, route: [{type: end, body: bracket}, {type: end, body: tip}]}
    line: {rope: thick, length: as_routed, route: [{type: end, body: post}, {type: end, body: foot}]}
  contacts:
    ground: {body: foot, plane: {point: [0 m, 0 m, 2 m]}, stiffness: 1 MN/m}
"""


@pytest.mark.parametrize(
    ("right", "wrong", "path", "sentence"),
    [
        (
            "mass: 8 t, ",
            "",
            "mechanics.bodies.arm.centre_of_gravity",
            "a body without mass has no centre of gravity; give it 'mass', or leave this out",
        ),
        (
            "{body: foot, plane",
            "{body: bracket, plane",
            "mechanics.contacts.ground.body",
            "'bracket' stands still, as the plane does; name a body that moves",
        ),
        (
            "{type: slider, axis: [0, 0, 1]}",
            "{type: slider, axis: [0, 0, 1], motion: [{at: 3 s, duration: 1 s, velocity: 1 m/s}]}",
            "mechanics.bodies.foot.joint.motion[1].at",
            "3 s is after the end of the lift at 2 s, so that nothing moves; make 'duration' longer or this"
            " time earlier",
        ),
        (
            "{type: end, body: tip}]",
            "{type: end, body: world}]",
            "mechanics.ropes.stay.route",
            "nothing gives way to this inextensible rope: all its guides are on 'bracket', 'world', which do"
            " not move against each other; name another body",
        ),
        (
            "[{type: end, body: bracket}, {type: end, body: tip}]",
            "[{type: end, body: arm}, {type: end, body: tip}]",
            "mechanics.ropes.stay.route",
            "nothing gives way to this inextensible rope: all its guides are on 'arm', 'tip', which do not"
            " move against each other; name another body",
        ),
    ],
    ids=["no mass", "standing contact", "late motion", "rope of the world", "rope of one body"],
)
def test_what_does_nothing_is_refused(right: str, wrong: str, path: str, sentence: str) -> None:
    """Each with its line, and what would be right."""
    assert LIFT.count(right) == 1
    text = LIFT.replace(right, wrong)
    line = LIFT[: LIFT.index(right)].count("\n") + 1
    with pytest.raises(gantline.ScenarioError) as refused:
        gantline.parse_scenario(text)
    assert str(refused.value) == f"scenario.yaml:{line}: {path}: {sentence}"


def test_what_does_something_is_not() -> None:
    """The lift as it is, an elastic rope between places that stand still, and a body of inertia alone."""
    still = LIFT.replace("{type: end, body: foot}", "{type: end, body: world}")
    weightless = LIFT.replace("mass: 8 t, centre_of_gravity: [1 m, 0, 0]", "")
    for text in (LIFT, still, weightless):
        assert gantline.parse_scenario(text).mechanics is not None
