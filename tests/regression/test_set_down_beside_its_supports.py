"""A load that came down beside the supports that were built for it was told nothing of.

A bow section was set down on bare ground, since the stools for it stood 100 m farther along the rails of its
crane by a slip of one digit: the run said nothing of it. Supports that bear nothing from
beginning to end, under a load that steps have set down, are a warning now.
"""

from __future__ import annotations

from typing import Any

import gantline
from gantline.checks import check_recording

_LIFT = """
format: 1
lift: {title: A module onto its foundation}
duration: 110 s
ground: {level: 0 m, friction: 0.4}
ropes: {sling: {axial_stiffness: 60 MN, damping_time: 10 ms}}
load:
  name: module
  shape: {box: [6 m, 4 m, 3 m]}
  position: [0 m, 0 m, 0.5 m]
  weight: {calculated: 40 t}
  centre_of_gravity: {at: [0 m, 0 m, 1.5 m]}
  stands_on: trailer
  lugs:
    A: {at: [-2.5 m,  1.5 m, 3 m]}
    B: {at: [ 2.5 m,  1.5 m, 3 m]}
    C: {at: [-2.5 m, -1.5 m, 3 m]}
    D: {at: [ 2.5 m, -1.5 m, 3 m]}
supports:
  trailer:
    under: module
    grid: {x: [-2 m, 2 m], y: [-1.5 m, 1.5 m]}
    height: 0.5 m
    stiffness: 50 MN/m
    damping: 1 MN s/m
    friction: 0.4
  foundation:
    under: module
    measured_from: world
    grid: {x: [-2 m, 2 m], y: [-1.5 m, 1.5 m]}
    foot: 0 m
    height: 0.3 m
    stiffness: 50 MN/m
    damping: 1 MN s/m
    friction: 0.4
cranes:
  crane: {type: fixed_hook, at: [0 m, 0 m, 11.5 m], hoist: {speed: 3 m/min, acceleration: 0.05 m/s^2}}
sling_defaults: {rope: sling, length: 8.53 m}
slings:
  A: {from: crane, to: module.A}
  B: {from: crane, to: module.B}
  C: {from: crane, to: module.C}
  D: {from: crane, to: module.D}
plan:
  - {step: lift off, hoist: crane, speed: 1 m/min, until: {supports: clear}}
  - {step: up, hoist: crane, speed: 3 m/min, by: 0.3 m}
  - {step: take it away, hold: 10 s, remove_supports: trailer}
  - {step: set down, lower: crane, speed: 1 m/min, until: {load_transferred: 2 %}}
  - {step: end, hold: until_end}
"""


def _told(changes: dict[str, Any]) -> list[str]:
    recording = gantline.simulate(gantline.parse_scenario(_LIFT).changed(changes))
    return [check.remark for check in check_recording(recording) if check.name == "comes_to_supports"]


def test_supports_that_stand_elsewhere_are_told() -> None:
    """100 m away, the load comes down on the ground, where its centre of gravity is 1.5 m up."""
    (said,) = _told({"supports.foundation.grid.x": ["98 m", "102 m"]})
    assert "it stands on something else, and foundation bears nothing all along" in said
    assert "its centre of gravity is at x 0.00 m, y 0.00 m and z 1.50 m then" in said


def test_what_the_load_stands_on_instead_is_named() -> None:
    """Back on the trailer, which nobody has taken away, the foundation beside it being lower."""
    lift = gantline.parse_scenario(_LIFT.replace(", remove_supports: trailer", ""))
    (said,) = [
        check.remark
        for check in check_recording(gantline.simulate(lift))
        if check.name == "comes_to_supports"
    ]
    assert "it stands on trailer, and foundation bears nothing all along" in said


def test_supports_that_bear_are_not() -> None:
    """Where the foundation is, the load comes down on it; the trailer was taken away and bore before."""
    assert _told({}) == []
