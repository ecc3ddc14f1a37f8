"""Equalizers without sheaves: what the lift file says of them, and what becomes of it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gantline
from gantline.assembly import assemble
from gantline.cli.summary import summary
from gantline.overrides import SettingError
from gantline.plot import figures
from gantline.scenario import ScenarioError
from gantline.scenario.file.reading import parse_scenario
from lift_text import BASE, spoiled

FRAME = {"mass": 5e3, "depth": 2.0}
SHEAVE = {"mass": 200.0, "depth": 5.0}
APPROXIMATED = spoiled(
    "    rope: thick\n", "    mechanism: approximated\n    adjusting_factor: 0.02\n    rope: thick\n"
)
SCENARIO = Path(__file__).resolve().parents[2] / "scenarios" / "mechanisms"


def refused(text: str) -> str:
    with pytest.raises(ScenarioError) as error:
        parse_scenario(text, "lift.yaml")
    return str(error.value)


def test_slings_hang_from_the_frame_and_sheaves_are_masses_on_it() -> None:
    document = assemble(parse_scenario(APPROXIMATED, "lift.yaml")).document
    assert [body["name"] for body in document["bodies"]] == ["hook", "e1", "block"]
    assert [rope["name"] for rope in document["ropes"]] == ["sling.S1", "sling.S2"]
    tops = [rope["route"][0] for rope in document["ropes"]]
    assert [(top["body"], top["at"]) for top in tops] == [("e1", [-0.8, 0, -5.0]), ("e1", [0.8, 0, -5.0])]
    assert document["adjusters"] == [{"name": "e1", "ropes": ["sling.S1", "sling.S2"], "factor": 0.02}]
    frame = document["bodies"][1]
    assert frame["mass"] == FRAME["mass"] + 2 * SHEAVE["mass"]
    centre = FRAME["mass"] * FRAME["depth"] + 2 * SHEAVE["mass"] * SHEAVE["depth"]
    assert frame["centre_of_gravity"] == pytest.approx([0, 0, -centre / frame["mass"]])
    assert assemble(parse_scenario(BASE, "lift.yaml")).document["adjusters"] == []


def test_a_type_may_say_the_mechanism() -> None:
    kind = "equalizer_types:\n  old: {mechanism: approximated, adjusting_factor: 0.5}\nequalizers:\n"
    text = spoiled("equalizers:\n", kind).replace("    hangs_from", "    type: old\n    hangs_from")
    assert assemble(parse_scenario(text, "lift.yaml")).document["adjusters"][0]["factor"] == 0.5


def test_adaptive_is_refused_in_the_file_and_as_a_setting() -> None:
    message = refused(APPROXIMATED.replace("integrator: del, step: 1 ms", "integrator: adaptive"))
    assert "adjusts lengths once per step, and 'adaptive' chooses its steps" in message
    with pytest.raises(ScenarioError, match="fixed step only; use del or explicit"):
        gantline.Simulation(parse_scenario(APPROXIMATED, "lift.yaml"), integrator="adaptive")


def test_slings_that_cannot_be_adjusted_are_refused() -> None:
    nodes = APPROXIMATED.replace("tolerance: 0.25 %}", "rope_weight: distributed, rope_nodes: 3}")
    assert "has nodes, and 'e1' is approximated" in refused(
        nodes.replace("damping_time: 2 ms, mass: none", "damping_time: 2 ms, mass: 9 kg/m")
    )
    stiff = APPROXIMATED.replace(
        "sling: {axial_stiffness: 100 MN, damping_time: 2 ms, mass: none}", "sling: {inextensible: true}"
    )
    assert "is inextensible, and 'e1' is approximated" in refused(stiff)
    one = "\n".join(line for line in APPROXIMATED.split("\n") if not line.startswith("  S2:"))
    assert "there are 1, at least 2 are right" in refused(one)


def test_a_step_belongs_to_either_method_of_fixed_step() -> None:
    text = spoiled("integrator: del", "integrator: explicit")
    assert assemble(parse_scenario(text, "lift.yaml")).settings["integrator"] == {
        "type": "explicit",
        "step": 1e-3,
    }
    message = refused(spoiled("integrator: del", "integrator: adaptive"))
    assert (
        "'step' belongs to 'integrator: del' and 'integrator: explicit', this lift has 'adaptive'" in message
    )
    paper = refused(spoiled("integrator: del,", "integrator: explicit, paper: true,"))
    assert "'paper' belongs to 'integrator: del', this lift has 'explicit'" in paper


def test_the_factor_is_a_setting() -> None:
    lift = parse_scenario(APPROXIMATED, "lift.yaml")
    assert (
        gantline.Simulation(lift, adjusting_factor=0.7).assembly.rig["equalizers"][0]["adjusting_factor"]
        == 0.7
    )
    with pytest.raises(SettingError, match="adjusting_factor: -1 is not a number above zero"):
        gantline.Simulation(lift, adjusting_factor=-1)
    with pytest.raises(SettingError, match="no equalizer of this lift has 'mechanism: approximated'"):
        gantline.Simulation(parse_scenario(BASE, "lift.yaml"), adjusting_factor=0.5)


def test_what_a_recording_says_of_it() -> None:
    recording = gantline.simulate(SCENARIO, duration=4.0)
    assert np.all(recording["sheave_travel"].values == 0.0)
    lengthening = recording["rope_lengthening"].values
    assert np.abs(lengthening.sum(axis=1)).max() < 1e-12
    assert lengthening.max() > 0.1
    metrics = recording.metrics()
    assert metrics["largest_rope_lengthening"] == lengthening.max()
    assert "travel_used_down" not in metrics
    text = "\n".join(summary(recording, [], lambda verdict: verdict.name))
    assert "approximated, adjusting factor 0.01: no sheave moves" in text
    assert "not limited" in text
    assert "travel used" not in text
    drawn = [name for name, _ in figures(recording)]
    assert "sling_lengthening" in drawn
    assert not {"sheave_travel", "equalizing_rope_tension", "equalizer_e1"} & set(drawn)
