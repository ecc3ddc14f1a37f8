"""A contact of `mechanics` that starts deep behind its plane shot its body away without a word.

A ball of 10 kg that begins 1 m under a plane of 1 MN/m is pushed with 1 MN and was 312 m up after a second,
with no warning, where a rope that begins stretched by more than 2 % is refused. Now a warning says how deep
it is.
"""

from __future__ import annotations

import pytest

import gantline

LIFT = """\
format: 1
lift: {title: A ball}
duration: 0.1 s
mechanics:
  bodies:
    ball: {at: [0, 0, HEIGHT], joint: {type: slider, axis: [0, 0, 1]}, mass: 10 kg}
  contacts:
    foot: {body: ball, plane: {point: [0, 0, 2 m], normal: [0, 0, 3]}, stiffness: 1 MN/m, damping: 10 kN s/m}
"""


@pytest.mark.parametrize(
    ("height", "warnings"),
    [
        # 1 m times 1 MN/m, and 10 kg times 9.81 m/s²; nine tenths of a millimetre carry 9 times the weight.
        (
            "1 m",
            [
                "scenario.yaml:8: mechanics.contacts.foot: starts 1000.0 mm behind its plane and pushes with "
                "1 MN, where all bodies weigh 98.1 N; it starts at its plane or outside"
            ],
        ),
        ("1.9991 m", []),
        ("3 m", []),
    ],
)
def test_what_starts_behind_its_plane(height: str, warnings: list[str]) -> None:
    recording = gantline.simulate(gantline.parse_scenario(LIFT.replace("HEIGHT", height)))
    assert recording.attributes["warnings"] == warnings
