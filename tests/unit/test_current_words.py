"""What results say of the current that a lift is in."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import gantline
from gantline.cli.app import app
from gantline.cli.summary import heading
from gantline.report.attitude import attitude
from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.results import Recording
from json_lift import plain_lift

AREA = {"area": "10 m^2", "coefficient": 1.0, "along": "x"}
SAID = "0.8 m/s towards 180 deg"


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A body in a current, which presses it onto a stop."""
    stop = {"lower": "0 m", "stiffness": "3 kN/m", "damping": "2 kN s/m"}
    joint = {"type": "slider", "axis": [1, 0, 0], "stops": stop}
    body = {"joint": joint, "mass": "2 t", "current_areas": {"side": AREA}}
    current = {"speed": "0.8 m/s", "direction": "180 deg"}
    return plain_lift(tmp_path_factory.mktemp("current"), {"body": body}, current=current)


def test_head_and_report_have_it(path: Path) -> None:
    """As they have waves and wind, and the first page as what stops the lift."""
    run = gantline.simulate(path)
    assert heading(run.rig)[-1] == f"Current: {SAID}"
    subject = Subject(run)
    assert dict(attitude(subject))["current"] == SAID
    assert "current is over 0.8 m/s, or from elsewhere" in stop_if(subject)


@pytest.mark.parametrize("verb", ["check", "statics"])
def test_heads_without_a_run_have_it(path: Path, verb: str) -> None:
    """Statics know the current too."""
    assert f"Current: {SAID}\n" in CliRunner().invoke(app, [verb, str(path)]).output


def test_a_recording_from_before_says_nothing_of_it(path: Path) -> None:
    run = gantline.simulate(path)
    rig = json.loads(json.dumps(run.attributes["rig"]))
    del rig["current"]
    old = Subject(Recording(run.variables, run.coordinates, {**run.attributes, "rig": rig}))
    assert not any(line.startswith("Current") for line in heading(old.rig))
    assert "current" not in dict(attitude(old))
    assert not any(line.startswith("current") for line in stop_if(old))
