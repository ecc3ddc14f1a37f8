"""The player drew slack mooring and tag lines straight where their dampers were felt.

How long a line is by itself it took from length and tension, which its damper raises and lowers: of nylon
with `damping_time: 0.1 s` that varied by more than 0.02 %, and the line was taken for one on a drum.
"""

from __future__ import annotations

import pytest

import gantline
from gantline.scenario import parse_scenario
from gantline.viewer.turning import natural_lengths

LIFT = """\
format: 1
lift: {title: A mass between two lines}
duration: 12 s
start: as_given
ropes:
  nylon: {KIND, mass: none, damping_time: 0.1 s}
mechanics:
  bodies:
    mass: {joint: {type: slider, axis: [1, 0, 0], velocity: 4 m/s}, mass: 500 t}
mooring_lines:
  right: {vessel: mass, fairlead: [0 m, 0 m, 0 m], to: [30 m, 0 m, 0 m], rope: nylon, type: spring,
    length: 28 m}
  left: {vessel: mass, fairlead: [0 m, 0 m, 0 m], to: [-30 m, 0 m, 0 m], rope: nylon, type: spring,
    length: 28 m WINCH}
plan: [{step: hold, hold: until_end}]
"""


@pytest.mark.parametrize(
    "kind", ["axial_stiffness: 4 MN", "curve: {strain: [5 %, 10 %, 30 %], tension: [30 kN, 90 kN, 900 kN]}"]
)
def test_lines_made_fast_are_as_long_as_the_lift_file_has_them(kind: str) -> None:
    """Both go slack in turn; 28 m each."""
    recording = gantline.simulate(parse_scenario(LIFT.replace("KIND", kind).replace("WINCH", "")))
    assert all(recording.column("rope_tension", f"mooring.{one}").min() == 0.0 for one in ("right", "left"))
    assert natural_lengths(recording, list(range(len(recording.time)))) == [28.0, 28.0]


def test_one_on_a_winch_says_no_length() -> None:
    """What a winch pays out changes it."""
    winch = ", winch: {speed: 5 m/min, acceleration: 0.1 m/s^2}"
    lift = LIFT.replace("KIND", "axial_stiffness: 4 MN").replace("WINCH", winch)
    ropes = gantline.simulate(parse_scenario(lift)).rig.ropes
    assert {rope.name: rope.length for rope in ropes} == {"mooring.right": 28.0, "mooring.left": None}
