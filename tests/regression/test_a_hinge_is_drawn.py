"""The hinge of a load is drawn, with its name, while it holds its load.

A load turned about nothing: sketches had no mark, pictures a black square and the player a grey ball without
a name, as of any body without a shape, and both stayed after the hinge had let its load go.
"""

from __future__ import annotations

import json

import numpy as np
import pytest
from matplotlib.figure import Figure

from gantline.plot.drawing import SIDE, draw, norm_of
from gantline.plot.scene import snapshot
from gantline.report.sketch import sketches
from gantline.report.subject import Subject
from gantline.results.recording import Recording
from gantline.scenario import parse_scenario
from gantline.simulation import simulate
from gantline.viewer import pack
from hinged_mast import PINS, mast

OPEN = "  - {step: hold, hold: 4 s}\n  - {step: let go, hold: 2 s, open_hinges: foot}\n"


def short(plan: str) -> Recording:
    more = "simulation: {sample_interval: 0.1 s}"
    text = mast(plan, hook=(19.0, 0.0, 60.0), more=more).replace("900 s", "6 s")
    return simulate(parse_scenario(text))


@pytest.fixture(scope="module")
def opened() -> Recording:
    return short(OPEN)


def test_pictures_have_it_until_it_opens(opened: Recording) -> None:
    start, end = (snapshot(opened, sample) for sample in (0, len(opened.time) - 1))
    assert dict(start.hinges).keys() == {"foot"} and not end.hinges
    assert start.hinges["foot"] == pytest.approx(PINS, abs=1e-6)
    assert "foot" not in {*start.points, *end.points}
    for snap, names in ((start, ["foot"]), (end, [])):
        figure = Figure()
        panel = figure.add_subplot()
        draw(panel, snap, SIDE, norm_of([("", snap)]))
        assert [text.get_text() for text in panel.texts] == names


def test_sketches_have_it_while_it_holds() -> None:
    side, plan = sketches(Subject(short("  - {step: hold, hold: until_end}\n")))
    for sketch in (side, plan):
        (ring,) = (mark for mark in sketch.marks if mark.style == "sk-hinge")
        (lug,) = (mark for mark in sketch.marks if mark.style == "sk-lug")
        # 39 m from the lug, to scale.
        assert (lug.x - ring.x) * sketch.scale == pytest.approx(39.0, abs=0.01)
    named = [mark for mark in side.marks if mark.kind == "text" and "foot" in mark.text]
    assert len(named) == 1


def test_the_player_knows_when_it_opens(opened: Recording) -> None:
    header = json.loads(pack(opened).header_text())
    (hinge,) = header["hinges"]
    body = header["bodies"][hinge["body"]]
    assert (body["name"], body["kind"], hinge["openedAt"]) == ("foot", "hinge", 4.0)
    # Its own y is the axis: that of the load, which lies along x.
    turn = opened.column("body_orientation", "foot")[0]
    assert np.abs(turn) == pytest.approx([1.0, 0.0, 0.0, 0.0], abs=1e-2)
    assert json.loads(pack(short("  - {step: hold, hold: until_end}\n")).header_text())["hinges"] == [
        {"body": hinge["body"], "openedAt": None}
    ]
