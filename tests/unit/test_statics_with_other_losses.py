"""What drums have wound on the way to an equilibrium is that of the losses asked for, not of earlier ones."""

from __future__ import annotations

import json

import pytest

from gantline._core import Statics
from mechanics import body, document, drum, end, flow, half_turn, rope, slider


def statics() -> Statics:
    """A weight on soft rope over a lossy sheave to a drum, which hauls 2 m; a slack sling is put on then."""
    bodies = [
        body("weight", slider(), 1000.0, position=(-0.5, 0, 0)),
        flow("sheave", 10.0),
        flow("winch", 10.0, drive="winch"),
    ]
    over = half_turn(None, (0, 0, 10), 0.5, over=True, flow="sheave", ratio=1.2)
    ropes = [
        rope("r", None, [end("weight"), over, drum(None, (0.5, 0, 0), "winch")], 2e5),
        rope("aside", 30.0, [end(None, (-0.5, 0, 5)), end("weight")], 1e6),
    ]
    move = {"drive": "winch", "velocity": -0.5, "acceleration": 1.0}
    plan = [
        {"name": "haul", "moves": [move], "until": {"type": "distance", "distance": -2.0}},
        {"name": "on", "attaches": ["aside"], "until": {"type": "duration", "duration": 1.0}},
    ]
    return Statics(json.dumps(document(bodies, ropes=ropes, drives=[{"name": "winch"}], plan=plan)))


def height(asked: Statics, losses: str) -> float:
    """Of the weight once the drum has stopped [m]."""
    asked.settle(5.0, None, losses)
    return float(asked.columns()["body_position"][-1][0][2])


def test_losses_asked_for_one_after_the_other() -> None:
    """At 10 kN a rope of 200 kN is 5 % longer; 20 % of that, up and down, on 2 m are some centimetres."""
    alone = {losses: height(statics(), losses) for losses in ("forward", "backward", "none")}
    assert abs(alone["forward"] - alone["backward"]) > 0.01
    asked = statics()
    for losses in ("forward", "backward", "none", "forward"):
        assert height(asked, losses) == pytest.approx(alone[losses], abs=1e-12)
