"""A vessel that comes back from losing the simulated weight of a load, and not from losing its design weight.

`gantline statics --lost` took the load as it was simulated, with its calculated weight. What it leaves in a
vessel goes with the square of the angle at which it held her: with a contingency of 1.2 that is 1.44 times as
much and a little more, and a vessel of A2/A1 = 1.27 was told to come back; she is at 0.84.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from afloat import BREADTH, KG, LENGTH, MASS, barge, lift_of, written
from floating import SEA
from gantline.statics import Statics
from gantline.study import lose_load
from gantline.study.lost_load import Swing
from program import called

#: Load and its contingency [kg], where it hangs, to port and above the keel [m], and the rope there [m].
LOAD, CONTINGENCY, ASIDE, ABOVE, ROPE = 400e3, 1.2, 35.0, 60.0, 30.0
DRAFT = MASS / (SEA * LENGTH * BREADTH)
BM = BREADTH**2 / (12 * DRAFT)
GM = DRAFT / 2 + BM - KG


def work(angle: float) -> float:
    """Of righting a box that is wall-sided, over its weight [m rad]."""
    return GM * (1 - math.cos(angle)) + BM * (1 / math.cos(angle) + math.cos(angle) - 2) / 2


def held_at(load: float) -> float:
    """The heel with a load on, to first order: its moment over all that rights barge and load [rad].

    Wall-sided with the load at its height: D GM of both is that of the barge and what the load adds to it.
    """
    whole = MASS + load
    draft = whole / (SEA * LENGTH * BREADTH)
    gm = draft / 2 + BREADTH**2 / (12 * draft) - (MASS * KG + load * ABOVE) / whole
    return load * ASIDE / (whole * gm)


def lift(vent: float, simulate: str = "calculated", contingency: float = CONTINGENCY) -> dict[str, Any]:
    """The load hangs beside the barge; water comes in by a vent at the other edge, so high [m]."""
    side = f"{-BREADTH / 2} m"
    return lift_of(
        barge(openings={"vent": [f"{LENGTH / 2} m", side, f"{vent} m"]}),
        ropes={"falls": {"axial_stiffness": "4000 MN", "damping_time": "20 ms"}},
        load={
            "name": "module",
            "shape": {"box": ["8 m", "8 m", "4 m"]},
            "datum": "bottom_centre",
            "position": [f"{LENGTH / 2} m", f"{ASIDE} m", f"{ABOVE - ROPE - 8.0} m"],
            "weight": {"calculated": f"{LOAD} kg", "contingency": contingency, "simulate": simulate},
            "centre_of_gravity": {"at": ["0 m", "0 m", "2 m"]},
        },
        mechanics={
            "ropes": {
                "falls": {
                    "rope": "falls",
                    "length": f"{ROPE} m",
                    "route": [
                        {
                            "type": "end",
                            "body": "barge",
                            "at": [f"{LENGTH / 2} m", f"{ASIDE} m", f"{ABOVE} m"],
                        },
                        {"type": "end", "body": "module", "at": ["0 m", "0 m", "4 m"]},
                    ],
                }
            }
        },
    )


def swing(folder: Path, given: dict[str, Any]) -> Swing:
    question = Statics(written(folder, given))
    [found] = lose_load(question, question.equilibrium(), "module").swings
    return found


def vent_for(ratio: float) -> float:
    """The height of a vent at which the work up to it is so many times that of the simulated load [m]."""
    left = work(held_at(LOAD))
    low, high = 0.0, 0.5
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if work(middle) < ratio * left else (low, middle)
    return DRAFT + BREADTH / 2 * math.tan(low)


def test_what_the_design_weight_leaves(tmp_path: Path) -> None:
    """As of the lift that is simulated with it; by hand within what heel has of second order, 2 %."""
    found = swing(tmp_path, lift(7.0))
    then = swing(tmp_path, lift(7.0, "design"))
    assert found.left_at_design == pytest.approx(then.left, rel=1e-5)
    assert then.left_at_design is None and then.ratio_at_design is None
    assert found.left == pytest.approx(work(held_at(LOAD)), rel=0.03)
    assert found.left_at_design == pytest.approx(work(held_at(CONTINGENCY * LOAD)), rel=0.03)
    assert found.ratio_at_design == pytest.approx(then.ratio, rel=1e-5)


def test_a_vessel_that_does_not_come_back_from_it(tmp_path: Path) -> None:
    """A2/A1 of 1.25, and with 1.2 of contingency, squared and a little more, below 1."""
    vent = vent_for(1.25)
    path = written(tmp_path, lift(vent))
    found = swing(tmp_path, lift(vent))
    assert found.ratio > 1.1 and found.ratio_at_design is not None and found.ratio_at_design < 0.95
    assert not found.is_held
    ran = called("statics", path, "--lost", "module", "-o", tmp_path / "out")
    assert ran.returncode == 1
    left = math.degrees(found.left_at_design or 0.0)
    assert f"barge with the design weight on: A1 {left:.2f} m deg" in ran.stdout
    assert "WARNING: barge with the design weight does not swing back" in ran.stdout
    told = json.loads((tmp_path / "out" / "lost_load.json").read_text(encoding="utf-8"))
    assert told["sound"] is False
    assert told["swings"][0]["ratio_at_design"] == pytest.approx(found.ratio_at_design)


def test_one_that_has_no_more_weight_comes_back(tmp_path: Path) -> None:
    vent = vent_for(1.25)
    found = swing(tmp_path, lift(vent, contingency=1.0))
    assert found.is_held and found.left_at_design is None
