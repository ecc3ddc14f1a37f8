"""A load that a hinge had held before it could not be lost: `gantline statics --lost` found no equilibrium.

Such a load is fixed to the joints of its hinge, which are bodies without mass and move it once the hinge is
open. They were not taken off with the load: its slings still held them, at nothing that weighs. `monopile`,
whose pile hangs free over the side in the end, was said to have "no equilibrium at t = 3800 s: no step brings
its forces closer to balance (bucket/upright)".
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from afloat import barge, lift_of, written
from gantline.statics import Statics
from gantline.study import LostLoad, lose_load

HINGE = {
    "hinges": {"foot": {"at": ["-3 m", "0 m", "1 m"], "axis": [0, 1, 0], "held_by": "barge"}},
    "plan": [
        {"step": "hold", "hold": "1 s"},
        {"step": "open", "hold": "until_end", "open_hinges": "foot"},
    ],
}


def lost(folder: Path, **changes: Any) -> LostLoad:
    """What is left in a barge that loses 400 t off its port side, all of which hangs there in one rope."""
    load = {
        "name": "module",
        "shape": {"box": ["8 m", "8 m", "4 m"]},
        "position": ["50 m", "20 m", "22 m"],
        "weight": {"calculated": "400 t"},
        "centre_of_gravity": {"at": ["0 m", "0 m", "2 m"]},
    }
    route = [
        {"type": "end", "body": "barge", "at": ["50 m", "20 m", "60 m"]},
        {"type": "end", "body": "module", "at": ["0 m", "0 m", "4 m"]},
    ]
    given = lift_of(
        barge(),
        ropes={"falls": {"axial_stiffness": "4000 MN", "damping_time": "20 ms"}},
        load=load,
        mechanics={"ropes": {"falls": {"rope": "falls", "length": "30 m", "route": route}}},
        **changes,
    )
    question = Statics(written(folder, {**given, "duration": "4 s"}))
    return lose_load(question, question.equilibrium(), "module")


def test_as_one_that_no_hinge_has_held(tmp_path: Path) -> None:
    """An open hinge holds nothing, so that neither rest nor arms know of it: the same angles and areas.

    They differ by what searches leave, 1e-9 of all forces over GM of some metres.
    """
    (found,), (wanted,) = lost(tmp_path, **HINGE).swings, lost(tmp_path).swings
    for name in ("before", "farthest", "left", "taken"):
        value = getattr(wanted, name)
        assert value, name
        assert getattr(found, name) == pytest.approx(value, rel=1e-6), name
