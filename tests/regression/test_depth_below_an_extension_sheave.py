"""A sling over an extension sheave with a lug at one end and a further extension sheave at the other.

`gantline statics` says how deep the centre of gravity of a load is below the lower ends of its slings, of
which the table of tilting has "its weight" and "the rig". The end at the further sheave counted as a lug of
the load, metres above it and beside the two lugs that the sheave serves: 1.79 m of depth were said to be
2.63 m, so that the rig seemed to take away from what keeps the load upright.
"""

from __future__ import annotations

import numpy as np
import pytest

from extension_lifts import DEEP
from gantline.results import series
from gantline.results.rotation import axes
from gantline.scenario import parse_scenario
from gantline.statics import Statics
from gantline.study.tilting import tilting_of
from lift_text import changed

#: Three lugs: one at an end of the upper sling, two below a sheave at its other end.
MIXED = (
    ("start: rest", "start: as_given"),
    ("at: [0 m, 0 m, 26.1 m]", "at: [-1 m, 0 m, 25 m]"),
    ("at: [0 m, 0 m, 1.5 m]", "at: [-1 m, 0 m, 1.5 m]"),
    ("    L4: {at: [ 3 m,  2 m, 3 m], main_plate: yz, capacity: 40 t}\n", ""),
    ("L3: {at: [ 3 m, -2 m, 3 m]", "L3: {at: [3 m, 0 m, 3 m]"),
    ("  X3: {mass: 150 kg}\n", ""),
    ("to: X1, length: 5 m", "to: X1, length: 5.4 m"),
    ("to: [X2, X3], length: 20 m", "to: [X2, block.L3], length: 30 m"),
    ("to: [block.L1, block.L2], length: 18 m", "to: [block.L1, block.L2], length: 10 m"),
    ("  S3: {over: X3, to: [block.L3, block.L4], length: 18 m}\n", ""),
    ("speed: 3 m/min, by: 1.5 m", "speed: 6 m/min, by: 5 m"),
)


def test_depth_is_below_lugs() -> None:
    question = Statics(parse_scenario(changed(DEEP, *MIXED)))
    rest = question.equilibrium(60.0)
    recording = rest.recording
    (load,) = recording.rig.loads
    assert series.load_is_clear(recording, load)[-1]
    turn = axes(recording.column("body_orientation", "block")[-1])
    centre = recording.column("body_position", "block")[-1]
    up, moment = [], []
    for lug, sheave, sling in (("L1", "X2", "S2"), ("L2", "X2", "S2"), ("L3", "X1", "S1")):
        lever = turn @ np.asarray(load.lugs[lug].at)
        way = recording.column("body_position", sheave)[-1] - centre - lever
        up.append(rest.tension(f"sling.{sling}") * way[2] / np.linalg.norm(way))
        moment.append(up[-1] * lever[2])
    assert sum(up) == pytest.approx(load.weight, rel=1e-6)  # all that bears it
    (found,) = tilting_of(question, rest, question.modes())
    # sum of vertical force x height of its lug over the centre of gravity, over their sum
    assert found.depth == pytest.approx(sum(moment) / sum(up), rel=1e-9)
