"""Mooring lines and fenders: what becomes of them in the document, the rig and the checks."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.assembly.origin import origin_of
from gantline.checks import check_recording
from gantline.scenario import ScenarioError, load_scenario, parse_scenario
from gantline.simulation import Simulation
from gantline.statics import Statics
from goliath_lift import TO_SHEAVES, goliath_lift
from lift_text import MOORED, spoiled
from reference_lift import SCENARIO


def test_lines_and_fenders_in_the_document() -> None:
    """A catenary is a force, its winch a flow on its body; a fender a contact in front of its wall."""
    thick = ("stiffness: 5 MN/m}", "stiffness: 5 MN/m, damping: 50 kN s/m, thickness: 0.5 m, friction: 0.3}")
    document = assemble(parse_scenario(spoiled(*thick, MOORED))).document
    bow, stern = document["forces"]
    assert (bow["name"], bow["body"], bow["winch"]) == ("mooring.bow", "barge", "mooring.bow.winch")
    assert bow["sea_bed"] == -15.0
    assert "pretension" not in bow
    assert stern["pretension"] == 150e3
    assert "sea_bed" not in stern
    # Steel under water weighs less by what it displaces: 1025 of 7850 kg/m^3.
    assert bow["weight"] == pytest.approx(stern["weight"] * (1 - 1025 / 7850))
    [flow] = [one for one in document["bodies"] if one["name"] == "mooring.bow.winch"]
    assert flow["parent"] == "barge"
    [fender] = document["contacts"]
    assert fender["plane_point"] == pytest.approx([-0.5, 0.0, 0.0])
    assert fender["plane_normal"] == pytest.approx([1.0, 0.0, 0.0])
    assert fender["damping_time"] == pytest.approx(0.01)
    [step] = document["plan"]
    [move] = step["moves"]
    assert move["velocity"] == pytest.approx(-3 / 60)  # hauling takes line in
    assert step["until"] == {"type": "distance", "distance": -0.2}


def test_a_spring_line_is_a_rope() -> None:
    """Of the length that pulls as it is told at the start, on a drum where it has a winch."""
    spring = ("rope: moor_44, pretension: 150 kN", "rope: moor_44, pretension: 150 kN, type: spring")
    document = assemble(parse_scenario(spoiled(*spring, MOORED))).document
    [rope] = document["ropes"]
    stiffness = rope["material"]["axial_stiffness"]
    assert rope["length"] == pytest.approx(math.hypot(100, 5) / (1 + 150e3 / stiffness))
    recording = Simulation(parse_scenario(spoiled(*spring, MOORED))).run()
    assert recording.column("mooring_tension", "stern")[0] == pytest.approx(150e3)
    assert recording.column("mooring_tension", "bow")[0] > 0


def test_the_least_pretension_is_named() -> None:
    """No length pulls less than what the weight of the line does at best."""
    text = spoiled("pretension: 150 kN", "pretension: 1 kN", MOORED)
    with pytest.raises(
        ScenarioError,
        match=r":\d+: mooring_lines\.stern: no length.*pretension of 1000 N; its weight alone .* 6059 N",
    ):
        Simulation(parse_scenario(text))
    with pytest.raises(ScenarioError, match=r":\d+: mooring_lines\.stern: no length"):
        Statics(parse_scenario(text))


def test_a_pretension_that_stretches_a_line_too_far_is_named() -> None:
    """150 kN on EA of 1 MN are 15 %: what was given is named, and not the length that it would take."""
    soft = MOORED.replace("  bare: {axial_stiffness: 90 MN}", "  bare: {axial_stiffness: 1 MN, mass: 2 kg/m}")
    text = spoiled("rope: moor_44, pretension: 150 kN", "rope: bare, pretension: 150 kN", soft)
    stretched = r"its pretension of 150000 N stretches it by 15\.\d %, and a start allows 10 %; give it less"
    with pytest.raises(ScenarioError, match=rf":\d+: mooring_lines\.stern: {stretched}"):
        Simulation(parse_scenario(text))


def test_cut_lines_and_limits() -> None:
    """A line is cut by its name among ropes; limits hold peak tension and force against what they may be."""
    cut = ("by: 0.2 m}", "by: 0.2 m, cut: mooring.stern}\nlimits: {mooring_tension_of_breaking_force: 1 %}")
    recording = Simulation(parse_scenario(spoiled(*cut, MOORED))).run()
    assert [name for _, _, name in recording.events("cut")] == ["mooring.stern"]
    assert recording.column("mooring_tension", "stern")[-1] == 0.0
    checks = {check.name: check for check in check_recording(recording)}
    tension = checks["mooring_tension_of_breaking_force"]
    assert tension.verdict.value == "failed"
    # The one that is cut as the plan begins had its pretension until then.
    assert tension.value == pytest.approx(150e3 / 1351e3, rel=1e-3)


def test_a_step_waits_until_falls_are_plumb() -> None:
    """A load swings after a traverse; the hold ends where its falls first are within 0.02 deg of plumb."""
    bound = math.radians(0.02)
    plan = """\
{step: go, traverse: one, speed: 30 m/min, by: 5 m}
{step: wait, hold: until_met, until: {falls_out_of_plumb: 0.02 deg, of: [A]}}
{step: hold, hold: until_end}"""
    scenario = parse_scenario(goliath_lift(plan, duration=60))
    [_, wait, _] = assemble(scenario).document["plan"]
    # From the upper sheaves to those of the hook block, as results have it.
    falls = [[["gol.A/upper_sheaves", [0.0, 0.0, 0.0]], ["gol.A", [0.0, 0.0, TO_SHEAVES]]]]
    assert wait["until"] == {"type": "plumb", "falls": falls, "at_most": bound}
    recording = Simulation(scenario).run()
    angle = recording.column("falls_out_of_plumb", "gol.A")
    times = {name: time for time, kind, name in recording.events() if kind == "step_end"}
    waiting = (recording.time > times["go"]) & (recording.time < times["wait"])
    assert waiting.any()
    assert (angle[waiting] > bound).all()
    at_end = np.interp(times["wait"], recording.time, angle)
    # Between samples 0.1 s apart the angle goes 1e-5 rad from a straight line.
    assert at_end == pytest.approx(bound, abs=2e-5)


@pytest.mark.parametrize(
    ("element", "path"),
    [
        ("barge", ("mechanics", "bodies", "barge")),
        ("barge.deck_edge", ("mechanics", "bodies", "barge")),
        ("mooring.bow.winch", ("mooring_lines", "bow")),
        ("nobody", None),
    ],
)
def test_elements_of_the_core_lead_back_to_the_lift_file(element: str, path: tuple[str, ...] | None) -> None:
    assert origin_of(parse_scenario(MOORED), element) == path


@pytest.mark.parametrize(
    ("element", "path"),
    [
        ("sling.S1", ("slings", "S1")),
        ("e1", ("equalizers", "e1")),
        ("e1.equalizing", ("equalizers", "e1")),
        ("e1.3", ("equalizers", "e1")),
        ("test_hook", ("cranes", "test_hook")),
        ("block.corner_1", ("load",)),
        ("hoist", ("plan", 0)),
    ],
)
def test_gear_leads_back_to_the_lift_file(element: str, path: tuple[str | int, ...]) -> None:
    assert origin_of(load_scenario(SCENARIO), element) == path
