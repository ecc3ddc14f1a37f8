"""What a rope holds is lost once, and it pulls no more from the moment on at which it goes.

A weight hangs on two ropes of the stiffness k each, which both hold T²/2k, T = m g/2; one is taken off, the
weight sinks past where that had its length, and then it is cut as well.
"""

from __future__ import annotations

import json
from typing import Any

import pytest

from gantline._core import Statics
from in_water import lattice, submerged
from mechanics import G, Json, Run, adaptive, body, document, end, rope, simulate, slider

MASS, EA, LENGTH = 1000.0, 1e6, 5.0
STIFFNESS = EA / LENGTH
STRETCH = MASS * G / (2 * STIFFNESS)
METHODS: dict[str, Any] = {"adaptive": adaptive, "del": simulate}


def until(time: float) -> Json:
    return {"type": "duration", "duration": time}


@pytest.mark.parametrize("method", METHODS)
def test_a_rope_that_is_off_and_cut_loses_nothing_more(method: str) -> None:
    """`parting` is T²/2k from when it is taken off, though its ends are farther apart as it is cut."""
    bodies = [body("weight", slider(position=-STRETCH), MASS)]
    ropes = [rope(name, LENGTH, [end(None, (0, 0, LENGTH)), end("weight")], EA) for name in ("one", "other")]
    plan = [
        {"name": "wait", "until": until(0.1)},
        {"name": "off", "detaches": ["other"], "until": until(0.15)},
        {"name": "cut", "cuts": ["other"], "until": until(0.1)},
    ]
    run: Run = METHODS[method](document(bodies, ropes=ropes, plan=plan), 0.5)
    off, cut = (run.time > at + 0.01 for at in (0.1, 0.25))
    assert run.joint("weight")[cut][0] < -1.5 * STRETCH
    assert [name for _, name in run.events("detached")] == ["other"]
    held = (MASS * G / 2) ** 2 / (2 * STIFFNESS)
    # By `del` the rope has rung by rounding until then.
    assert run.energy("parting")[off] == pytest.approx(held, rel=1e-9)
    assert run.tension("other")[off].max() == 0.0


def test_a_mooring_line_that_is_cut_pulls_no_more_in_that_step() -> None:
    """By steps of one length: between two lines of the pull F, one cut, the speed after a step h is F h/m.

    In eight steps it moves by 18 µm, which with EA/L are 15 N less of 100 kN.
    """
    mass, pull, step = 2e5, 1e5, 1e-3
    line = {"type": "mooring", "body": "barge", "at": [0, 0, 0], "weight": 1.0, "axial_stiffness": 5e7}
    forces = [
        {**line, "name": name, "to": [x, 0, 0], "pretension": pull}
        for name, x in (("ahead", 60.0), ("astern", -60.0))
    ]
    forces[1]["cut_at"] = 0.1
    run = simulate(document([body("barge", slider((1, 0, 0)), mass)], forces=forces), 0.11, step=step)
    at = int(abs(run.time - 0.1).argmin())
    gone = run.joint("barge") - run.joint("barge")[at]
    # Speeds F h/m, 2 F h/m, … of the steps after it.
    for steps in (1, 2, 3, 8):
        way = pull / mass * step**2 * steps * (steps + 1) / 2
        assert gone[at + steps] == pytest.approx(way, rel=1e-3)


@pytest.mark.parametrize("time", [0.15, 0.3, 0.5])
def test_a_rope_that_is_cut_and_taken_off_carries_nothing_at_rest(time: float) -> None:
    """The other rope bears the whole weight from the cut on, whatever steps say of the one that is gone."""
    bodies = [body("weight", slider(position=-STRETCH), MASS)]
    ropes = [rope(name, LENGTH, [end(None, (0, 0, LENGTH)), end("weight")], EA) for name in ("one", "other")]
    plan = [
        {"name": "wait", "until": until(0.1)},
        {"name": "cut", "cuts": ["other"], "until": until(0.1)},
        {"name": "off", "detaches": ["other"], "until": until(0.2)},
    ]
    statics = Statics(json.dumps(document(bodies, ropes=ropes, plan=plan)))
    statics.settle(time)
    one, other = statics.columns()["rope_tension"][-1]
    assert one == pytest.approx(MASS * G, rel=1e-9)
    assert other == 0.0


def test_mooring_lines_of_a_body_that_is_lost_carry_nothing() -> None:
    """Those of another body pull as they did, at their pretension."""
    pulls = {"lost": 1e5, "other": 2e5}
    line = {"type": "mooring", "at": [0, 0, 0], "weight": 1.0, "axial_stiffness": 5e7}
    forces = [
        {**line, "name": f"{name}.{way}", "body": name, "to": [x, 0, 0], "pretension": pull}
        for name, pull in pulls.items()
        for way, x in (("ahead", 60.0), ("astern", -60.0))
    ]
    bodies = [body(name, slider((1, 0, 0)), 2e5) for name in pulls]
    statics = Statics(json.dumps(document(bodies, forces=forces)))
    statics.settle()
    statics.lose("lost", "none")
    # Lines of 1 N/m sag by 5 mm, which is 3e-9 of their force along.
    assert statics.columns()["rope_tension"][-1] == pytest.approx([0.0, 0.0, 2e5, 2e5], rel=1e-6)


def test_a_load_that_is_lost_in_the_water_stays_where_it_was() -> None:
    """Nothing weighs on it or lifts it any more, and its rope carries nothing."""
    bodies = [body("load", slider(), 1000.0)]
    water = submerged("load", lattice((0, 0, -2.0), half=(0.5, 0.5), height=0.5, layers=2, volume=0.6))
    ropes = [rope("fall", 5.0, [end(None, (0, 0, 5.0)), end("load")], EA)]
    statics = Statics(json.dumps(document(bodies, ropes=ropes, forces=[water])))
    statics.settle()
    hung = statics.columns()
    assert hung["rope_tension"][-1] == pytest.approx(1000 * G - 1025 * G * 0.6, rel=1e-9)
    statics.lose("load", "none")
    lost = statics.columns()
    assert lost["joint_position"][-1] == pytest.approx(hung["joint_position"][-1], abs=1e-12)
    assert lost["rope_tension"][-1] == 0.0
