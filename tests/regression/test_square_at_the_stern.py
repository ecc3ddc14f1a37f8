"""Pictures have no mark for the foot of a crane that slews: its own frame is at the stern of its vessel.

Stages of `revolving_crane`, `monopile` and `heavy_lift_ship` had a black square at the after end of the
keel, and the player a grey ball, as of any body without a shape, where nothing is.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from gantline.plot.scene import snapshot
from gantline.results.recording import Recording
from gantline.scenario import load_scenario
from gantline.simulation import simulate
from gantline.viewer import pack

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
#: What the crane is seen by, besides its hook.
PARTS = {"rc.upper", "rc.boom"}


@pytest.fixture(scope="module")
def slews() -> Recording:
    return simulate(load_scenario(SCENARIOS / "revolving_crane").changed({"duration": "0.4 s"}))


def test_pictures_mark_no_foot(slews: Recording) -> None:
    shapes = {body["name"]: body.get("shape") for body in slews.attributes["scene"]["bodies"]}
    assert shapes["rc"] is None, "the foot has nothing to draw"
    snap = snapshot(slews, 0)
    assert not snap.points
    assert {box.name for box in snap.boxes} >= PARTS


def test_the_player_has_no_ball_for_it(slews: Recording) -> None:
    names = {body["name"] for body in json.loads(pack(slews).header_text())["bodies"]}
    assert "rc" not in names
    assert names >= {"barge", "module", *PARTS}
