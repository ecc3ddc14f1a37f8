"""`Simulation.now` ended in an IndexError in every lift that has a rope with nodes: a moment has no peaks."""

from __future__ import annotations

from pathlib import Path

import pytest

from afloat import barge, lift_of, written
from gantline.scenario import load_scenario
from gantline.simulation import Simulation


def test_a_moment_has_ropes_with_nodes(tmp_path: Path) -> None:
    line = {
        "vessel": "barge",
        "fairlead": ["100 m", "0 m", "8 m"],
        "to": ["220 m", "0 m", "6 m"],
        "rope": "steel",
        "type": "distributed",
        "rope_nodes": 8,
        "pretension": "150 kN",
    }
    rope = {"axial_stiffness": "60 MN", "mass": "20 kg/m", "damping_time": "10 ms"}
    given = lift_of(barge(), ropes={"steel": rope}, mooring_lines={"bow": line}, start="as_given")
    run = Simulation(load_scenario(written(tmp_path, given)))
    run.run()
    recording = run.recording()
    assert recording.time[-1] == run.time
    for variable, name in (("body_position", "barge"), ("rope_tension", "mooring.bow")):
        last = recording.column(variable, name)[-1]
        assert run.now(variable, name) == pytest.approx(last, rel=1e-12)
