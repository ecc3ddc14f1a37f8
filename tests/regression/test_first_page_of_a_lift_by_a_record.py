"""The report of a barge that moves by a record of its motion, in a lift file without waves, knew none.

It was to stop if *a* load cell differs by 10 %, which a single wave does; at 25, 50 and 75 % the table of
hooks had what a wave left at that sample. Nothing said that more motion than recorded stops the lift, and
that the water below the freeboard and in the player stays still while the barge pitches.
"""

from __future__ import annotations

import numpy as np
import pytest

import gantline
from compensated import BARGE
from gantline.checks import check_recording
from gantline.cli.vessels import vessels
from gantline.report.afloat import afloat_facts, vessel_tables
from gantline.report.carried import hook_row
from gantline.report.first_page import stop_if
from gantline.report.subject import Subject
from gantline.results.afloat.vessels import Vessel
from gantline.results.recording import Recording
from gantline.results.rig import Rig
from gantline.scenario import load_scenario, parse_scenario
from recorded_motion import written_record
from shown import ROOT

STILL = "none in the lift file: the water stays still, barge by a record of motions"


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    """The crane barge without waves by a record: heave of 0.2 m within 8 s."""
    folder = tmp_path_factory.mktemp("record")
    times = np.arange(0.0, 160.0, 0.2)
    heave = 0.2 * np.cos(2.0 * np.pi / 8.0 * times)
    written_record(heave[:, None] * [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], 0.2, folder / "motion.csv")
    text = BARGE.read_text(encoding="utf-8")
    text = text.replace(text[text.index("waves:") : text.index("ropes:")], "")
    forces = text[text.index("    radiation:") : text.index("mooring_lines:")]
    text = text.replace(forces, "    wave_motion: {record: motion.csv, at: [45 m, 0 m, 3 m]}\n\n")
    text = text.replace("duration: 300 s", "duration: 80 s").replace("hold: 150 s", "hold: 60 s")
    return gantline.simulate(parse_scenario(text, str(folder / "lift.yaml")))


def test_the_lift_is_stopped_by_means_over_waves_and_by_more_motion(recording: Recording) -> None:
    told = stop_if(Subject(recording))
    assert told[0].startswith("the mean of a load cell over some waves differs")
    assert "barge moves more than its record has it" in told


def test_the_water_is_told_to_stay_still(recording: Recording) -> None:
    subject = Subject(recording)
    assert ("sea", STILL) in afloat_facts(subject)
    assert vessel_tables(subject)[0]["when"].split("; ")[1].endswith(", over still water")
    assert any(line.endswith("freeboard: the least of all, over still water") for line in vessels(recording))


def test_a_record_holds_waves_as_a_sea_does() -> None:
    assert Rig(vessels=(Vessel("barge", "barge", grows_over=36.0),)).is_in_waves
    assert not Rig(vessels=(Vessel("barge", "barge"),)).is_in_waves
    assert not Rig(vessels=(Vessel("barge", "barge"),)).moved_in_still_water


def test_readings_and_what_helps_a_bounce_are_those_of_waves() -> None:
    """A module off a barge: the run is that of `off_a_barge`, as if a record had moved the vessels.

    It has come off the deck within 115 s.
    """
    run = gantline.Simulation(load_scenario(ROOT / "scenarios/off_a_barge/scenario.yaml")).run(until=115.0)
    of_sea = Subject(run)
    rig = {key: value for key, value in run.attributes["rig"].items() if key != "sea"}
    carried = [{**one, "grows_over": run.rig.time_to_average} for one in rig["vessels"]]
    moved = {**run.attributes, "rig": {**rig, "vessels": carried}}
    recorded = Recording(run.variables, run.coordinates, moved)
    of_record = Subject(recorded)
    assert recorded.rig.sea is None
    (hook,) = run.rig.hooks
    assert hook_row(of_record, hook)["readings"] == hook_row(of_sea, hook)["readings"]
    told = [one.remark for one in check_recording(recorded) if one.name == "set_down_softly"]
    assert told and told[0].endswith("it had just lifted off; hoist it off faster, or wait for less sea")
