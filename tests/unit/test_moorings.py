"""Mooring lines and fenders: what becomes of them in the document, the rig and the checks."""

from __future__ import annotations

import math

import pytest

from gantline.assembly import assemble
from gantline.checks import check_recording
from gantline.scenario import ScenarioError, load_scenario, parse_scenario
from gantline.scenario.shipped import shipped
from gantline.simulation import Simulation
from lift_text import MOORED, spoiled


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
    with pytest.raises(ScenarioError, match=r"mooring\.stern.*pretension of 1000 N; its weight alone .* 6059 N"):
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


def test_falls_out_of_plumb_waits_for_hooks_that_hang_in_ropes() -> None:
    """From the upper sheaves to the bearing; all hooks, or those that are named."""
    text = load_scenario(shipped()["goliath"]).text
    begin = text.index("plan:")
    end = text.index("\nlimits:", begin)
    for of, hooks in (("", 3), (", of: [U1]", 1)):
        plan = f"plan:\n  - {{step: wait, hold: until_met, until: {{falls_out_of_plumb: 0.5 deg{of}}}}}\n"
        document = assemble(parse_scenario(text[:begin] + plan + text[end:])).document
        until = document["plan"][0]["until"]
        assert until["type"] == "plumb"
        assert until["at_most"] == pytest.approx(math.radians(0.5))
        assert len(until["falls"]) == hooks
        [above, below] = until["falls"][0]
        assert above[0] == f"{below[0]}/upper_sheaves"
