"""What first page, charts and tables say of a lift in waves, against the recording that they are made of."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import gantline
from gantline.cli.summary import heading
from gantline.report.afloat import afloat_facts, vessel_tables
from gantline.report.first_page import stop_if
from gantline.report.plots import Vessels
from gantline.report.subject import Subject
from gantline.results import Recording
from gantline.results.afloat.sea import WaveTrain
from gantline.viewer import pack
from gantline.viewer.curves import curves
from packed_arrays import unpacked
from waves import in_waves

WAVES = {
    "swell": {"significant_height": "0.8 m", "peak_period": "7 s", "direction": "150 deg"},
    "wash": {"height": "0.2 m", "period": "4 s", "direction": "180 deg"},
}


@pytest.fixture(scope="module")
def sailed(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    plan = [{"step": "wait", "hold": "20 s"}, {"step": "stay", "hold": "until_end"}]
    lift = in_waves(tmp_path_factory.mktemp("waves"), WAVES, duration="60 s", plan=plan)
    return gantline.simulate(lift)


def test_the_first_page_says_which_sea_and_from_where_it_comes(sailed: Recording) -> None:
    """They run to 150 deg, aft and to port (y), so from 30 deg off the starboard bow."""
    facts = afloat_facts(Subject(sailed))
    assert facts[0] == (
        "sea",
        "swell: 0.80 m significant height, 7.0 s peak period, running towards 150 deg, record 1",
    )
    assert facts[1] == ("sea", "wash: 0.20 m height, 4.0 s period, running towards 180 deg")
    highest = float(sailed.column("vessel_wave_elevation", "barge").max())
    assert facts[2][0] == "waves at barge"
    assert facts[2][1].startswith("from 30 deg off the bow to starboard, from ahead, −")
    assert facts[2][1].endswith(f" to {highest:.2f} m amidships")
    reasons = stop_if(Subject(sailed))
    assert "swell is over 0.80 m significant height or 7.0 s peak period, or from elsewhere" in reasons


@pytest.mark.parametrize(
    ("direction", "heading", "said"),
    [
        (180.0, 0.0, "from ahead"),
        (0.0, 0.0, "from astern"),
        (-90.0, 0.0, "from 90 deg off the bow to port"),
        (90.0, 0.0, "from 90 deg off the bow to starboard"),
        (-90.0, 90.0, "from ahead"),
        (210.0, 0.0, "from 30 deg off the bow to port"),
    ],
)
def test_from_where_waves_come(direction: float, heading: float, said: str) -> None:
    train = WaveTrain("swell", math.radians(direction), 1.0, 7.0)
    assert train.comes_from(math.radians(heading)) == said


def test_a_vessel_in_waves_lies_as_it_does_on_the_mean(sailed: Recording) -> None:
    """Over the time in which waves grow, three of the longest period; freeboard is the least in a step."""
    (table,) = vessel_tables(Subject(sailed))
    # The step `wait` takes 20 s.
    said = "mean over the last 21 s of each step, or all of a shorter one; freeboard: the least in it"
    assert table["when"] == said
    first, wait, stay = table["rows"]
    time = sailed.time
    draft, freeboard = (sailed.column(f"vessel_{one}", "barge") for one in ("draft_aft", "freeboard"))
    assert first["lies"][0] == f"{draft[0]:.2f}"
    assert wait["lies"][0] == f"{draft[time <= 20.0].mean():.2f}"
    assert stay["lies"][0] == f"{draft[time >= 39.0].mean():.2f}"
    assert stay["lies"][4] == f"{freeboard[time >= 20.0].min():.2f}"


def test_a_report_has_a_plot_of_the_waves(sailed: Recording) -> None:
    content = Vessels().content(Subject(sailed))
    assert content is not None
    last = json.loads(content["plots"][-1]["spec"])
    assert (last["groups"], last["unit"]) == (["waves"], "m")
    (curve,) = [one for one in curves(sailed) if one.group == "waves"]
    assert np.array_equal(curve.values, sailed.column("vessel_wave_elevation", "barge"))


def test_the_head_of_the_table_says_which_sea(sailed: Recording) -> None:
    lines = heading(sailed.rig)
    assert lines[-1].startswith("Waves: swell: 0.80 m significant height, 7.0 s peak period")


def test_a_recording_from_before_says_no_more_than_it_knows(sailed: Recording) -> None:
    rig = json.loads(json.dumps(sailed.attributes["rig"]))
    del rig["sea"]["trains"]
    old = Recording(sailed.variables, sailed.coordinates, {**sailed.attributes, "rig": rig})
    (name, text), *_ = afloat_facts(Subject(old))
    assert name == "waves at barge" and text.startswith("−")


def test_the_player_gets_the_waves_that_run(sailed: Recording) -> None:
    """ω, k, amplitude and phase of each, which make what vessels are held against."""
    packed = pack(sailed)
    frequency, along_x, along_y, amplitude, phase = unpacked(packed, "waves").T
    time, place = np.array([25.0, 60.0]), np.array([[10.0, -5.0], [80.0, 20.0]])
    sea = sailed.rig.sea
    assert sea is not None
    assert packed.header["riseTime"] == sea.rise_time < time[0]
    angle = (
        np.outer(place[:, 0], along_x) + np.outer(place[:, 1], along_y) - np.outer(time, frequency) + phase
    )
    assert np.cos(angle) @ amplitude == pytest.approx(sea.at(time, place), abs=1e-12)


def test_still_water_has_none() -> None:
    packed = pack(gantline.simulate("equalizer", duration=0.1))
    assert packed.header["riseTime"] is None
    assert packed.header["arrays"]["waves"]["shape"][0] == 0
