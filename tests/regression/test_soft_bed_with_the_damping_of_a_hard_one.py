"""A soft bed pushed a manifold from 0.27 m above it on, and it was told to have gone down past what it met.

A contact pushes with k (e + t v), t its damping over its stiffness, so that it pushes what comes at v from
t v above it on. 3 MN/m with 1 MN s/m have t = 0.33 s, and with the damping of hard ground, which is taken
where none is said, 0.67 s: at 0.5 m/s that is a third of a metre.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.assembly import assemble
from gantline.scenario import load_scenario
from hung_box import hung_box

LIFT = (
    """\
format: 1
lift: {title: A box comes down}
duration: 10 s
ground: {level: 0 m, friction: 0.5, GROUND}
ropes: {sling: {axial_stiffness: 100 MN, damping_time: 20 ms, minimum_breaking_force: 900 kN}}
"""
    + hung_box(
        "0 m, 0 m, 1 m",
        "0 m, 0 m, 8 m",
        "speed: 30 m/min, acceleration: 0.5 m/s^2",
        size="4 m, 2 m, 2 m",
        rope="sling",
    )
    + """\
plan:
  - {step: down, lower: hook, by: 1.5 m, speed: 30 m/min}
  - {step: stand, hold: until_end}
"""
)


def doubts(lift: gantline.Scenario) -> list[str]:
    return [one for one in assemble(lift).warnings if "a damping of" in one]


@pytest.mark.parametrize(
    ("ground", "early"),
    [("stiffness: 3 MN/m", "0.33 m"), ("stiffness: 3 MN/m, damping: 1 MN s/m", "0.17 m")],
)
def test_it_is_told_how_far_above_it_pushes(ground: str, early: str) -> None:
    lift = gantline.parse_scenario(LIFT.replace("GROUND", ground))
    [doubt] = doubts(lift)
    assert f"it pushes what comes down at 0.5 m/s from {early} above it on" in doubt
    recording = gantline.simulate(lift)
    [met, *_] = [time for time, kind, _ in recording.events() if kind == "set_down"]
    underside = recording.column("body_position", "box")[:, 2] - 1.0
    at = int((recording.time >= met).argmax())
    assert underside[at] == pytest.approx(float(early[:-2]), abs=0.02)  # comes at 0.5 m/s, as the hook does


def test_usual_damping_is_in_order() -> None:
    assert (
        doubts(gantline.parse_scenario(LIFT.replace("GROUND", "stiffness: 3 MN/m, damping: 60 kN s/m"))) == []
    )
    assert doubts(load_scenario("goliath")) == []


def test_supports_and_contacts_too() -> None:
    lift = load_scenario("goliath").changed({"supports.keel_blocks.stiffness": "4 MN/m"})
    [doubt] = doubts(lift)
    assert "support keel_blocks.1.1 has a damping of 1.000 MN s/m over 4.000 MN/m, 0.25 s" in doubt
