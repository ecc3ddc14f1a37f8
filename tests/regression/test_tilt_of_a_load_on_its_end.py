"""What keeps a load upright was told in its own axes, as if it were level: wrong of one hung on its end.

A column of 20 t, 10 m long, on one sling at the middle of its end face is a pendulum of 5 m about any level
axis. It was said to have 687 kN m/rad about one, its rig to take 1.5 m away; that its centre of gravity was
not below its lugs, 5 m above; and `up` of its margins went aside.
"""

from __future__ import annotations

import re

import pytest

import gantline
from gantline.results.loads.tilting import loose_tilt
from gantline.study import margins_of, tilting_of

WEIGHT, DEPTH = 20e3 * 9.81, 5.0
COLUMN = gantline.parse_scenario("""\
format: 1
lift: {title: A column on its end}
duration: 20 s
ropes:
  r: {axial_stiffness: 100 MN, damping_time: 10 ms, mass: none, diameter: 40 mm}
load:
  name: column
  shape: {box: [10 m, 1 m, 1 m]}
  position: [0 m, 0 m, 5 m]
  weight: {calculated: 20 t}
  centre_of_gravity: {at: [0 m, 0 m, 0.5 m]}
  lugs: {A: {at: [5 m, 0 m, 0.5 m], main_plate: xz}}
cranes:
  hook: {type: fixed_hook, at: [5 m, 0 m, 10.6 m], hoist: {speed: 6 m/min, acceleration: 0.1 m/s^2}}
slings:
  A: {from: hook, to: column.A, length: 5.15 m, rope: r}
plan:
  - {step: end, hold: until_end}
""")


def test_a_column_is_a_pendulum_about_all_level_axes() -> None:
    """W h, (TS1), about both; the moments of both motions that have part in it are alike too."""
    question = gantline.Statics(COLUMN)
    (found,) = tilting_of(question, question.equilibrium(), question.modes())
    assert found.depth == pytest.approx(DEPTH, abs=1e-6)
    for axis in (found.soft, found.stiff):
        assert axis.stiffness == pytest.approx(WEIGHT * DEPTH, rel=1e-6)
        assert axis.rig == pytest.approx(0.0, abs=1e-5)


def test_margins_go_up_and_to_all_sides() -> None:
    """Up along the column to its end, 5 m, aside to its sides, 0.5 m: each to a millimetre."""
    found = {one.direction: one for one in margins_of(COLUMN, gantline.Statics(COLUMN).equilibrium())}
    assert set(found) == {"up", "+y", "−y", "+z", "−z"}
    for direction, one in found.items():
        assert one.distance == pytest.approx(DEPTH if direction == "up" else 0.5, abs=2e-3)
        assert one.cause == "nothing; further on it is outside the load"


def test_the_middle_of_lugs_is_above_a_load_on_its_end() -> None:
    """Five lugs on one side of the load of `equalizer`, which turns until that is up, 5 m over its centre."""
    text = gantline.load_scenario("equalizer").text
    lugs = {"L1": (2.5, 1.5), "L2": (-2.5, 1.5), "L3": (0.0, 2.5), "L4": (2.5, 3.5), "L5": (-2.5, 3.5)}
    for name, (y, z) in lugs.items():
        text = re.sub(rf"({name}: {{at: )\[.*?\]", rf"\1[5 m, {y} m, {z} m]", text)
    for old, new in (
        ("position: [0 m, 0 m, 0 m]", "position: [-5 m, 0 m, 8 m]"),
        ("ground: {level: 0 m", "ground: {level: -40 m"),
        ("length: 23 m", "length: 26 m"),
        ("start: settled", "start: rest"),
        ("  stands_on: ground\n", ""),
    ):
        text = text.replace(old, new)
    rest = gantline.Statics(gantline.parse_scenario(text)).equilibrium()
    loose = loose_tilt(rest.recording, rest.recording.rig.loads[0])
    assert loose is not None
    assert loose.depth == pytest.approx(5.0, abs=1e-3)
