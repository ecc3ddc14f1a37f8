"""The first page spelled out three warnings in the order of the checks, and hid that the load was dropped.

A manifold that a swell picked up from its bed again and dropped at 65 m/min had "neither limits nor rules say
how far below its breaking force a sling has to stay" on its first page, and "6 warnings" for all else.
"""

from __future__ import annotations

from typing import Any

import gantline
from gantline.report.first_page import FirstPage
from gantline.report.subject import Subject

# Three things to know: no factor on the strength of slings, a lug without a sling, and a landing at 0.5 m/s.
LIFT = """
format: 1
lift: {title: A box comes down hard}
duration: 12 s
ground: {level: 0 m, friction: 0.5}
ropes: {sling: {axial_stiffness: 100 MN, damping_time: 20 ms, minimum_breaking_force: 2 MN}}
load:
  name: box
  shape: {box: [4 m, 2 m, 2 m]}
  position: [0 m, 0 m, 1 m]
  weight: {calculated: 10 t}
  centre_of_gravity: {at: [0.3 m, 0 m, 1 m]}
  lugs:
    A: {at: [1.5 m, 0 m, 2 m], capacity: 20 t}
    B: {at: [-1.5 m, 0 m, 2 m], capacity: 20 t}
    spare: {at: [0 m, 0 m, 2 m]}
cranes:
  hook:
    type: fixed_hook
    at: [0.3 m, 0 m, 8 m]
    rated_capacity: 20 t
    hoist: {speed: 30 m/min, acceleration: 0.5 m/s^2}
sling_defaults: {rope: sling}
slings:
  A: {from: hook, to: box.A, length: 5.14 m}
  B: {from: hook, to: box.B, length: 5.31 m}
plan:
  - {step: hang, hold: 6 s}
  - {step: down, lower: hook, by: 1.5 m, speed: 30 m/min}
  - {step: stand, hold: 1 s}
"""


def content(lift: str) -> dict[str, Any]:
    return FirstPage().content(Subject(gantline.simulate(gantline.parse_scenario(lift))))


def told(lift: str) -> list[str]:
    return [one["about"] for one in content(lift)["verdict"]["warned"]]


def test_what_happened_comes_before_what_nobody_said() -> None:
    about = told(LIFT)
    assert about[0] == "set down softly, box"
    assert (
        "rope factor on breaking force, sling.B" in about[1:]
        or "rope factor on breaking force, sling.A" in about[1:]
    )


def test_why_there_is_no_verdict_comes_first() -> None:
    """A note above the verdict says it, so it does not stand among the warnings again."""
    more = "  - {step: up, hoist: hook, by: 1 m, speed: 6 m/min}\n"
    lift = LIFT.replace("hold: 1 s", "hold: 60 s") + more
    assert content(lift)["ending"]["head"] == "The plan was not finished"
    about = told(lift)
    assert about[0] == "set down softly, box"
    assert "plan finished" not in about
