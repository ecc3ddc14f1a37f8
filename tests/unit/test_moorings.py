"""Mooring lines and fenders: what becomes of them in the document, the rig and the checks."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from gantline.assembly import assemble
from gantline.assembly.origin import origin_of
from gantline.checks import check_recording
from gantline.scenario import ScenarioError, load_scenario, parse_scenario
from gantline.scenario.afloat.mooring import is_moored, lines_at
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


TUG = "    tug: {at: [-60 m, 0 m, 10 m], mass: 300 t, joint: {type: slider, axis: [1, 0, 0]}}\n"
BETWEEN = spoiled(
    "to: [-100 m, 0 m, 5 m], rope: moor_44, pretension: 150 kN",
    "to: [2 m, 0 m, 0 m], held_by: tug, rope: moor_44, pretension: 150 kN, type: spring",
    spoiled("mooring_lines:", f"{TUG}mooring_lines:", MOORED),
)


def test_a_line_and_a_fender_between_two_bodies() -> None:
    """A rope from one to the other; a plane in the axes of the other."""
    wall = spoiled(
        "wall: [-1 m, 0 m], facing", "wall: [3 m, 0 m], wall_of: tug, thickness: 0.5 m, facing", BETWEEN
    )
    document = assemble(parse_scenario(wall)).document
    [rope] = document["ropes"]
    assert [(one["body"], one["at"]) for one in rope["route"]] == [("barge", [0, 0, 0]), ("tug", [2, 0, 0])]
    stiffness = rope["material"]["axial_stiffness"]
    assert rope["length"] == pytest.approx(58.0 / (1 + 150e3 / stiffness))
    [fender] = document["contacts"]
    assert (fender["body"], fender["plane_body"]) == ("barge", "tug")
    assert fender["plane_point"] == pytest.approx([3.5, 0.0, 0.0])


def test_what_a_line_leads_to_holds_it() -> None:
    """By way of others or not; a line between two bodies that nothing else holds holds neither."""
    held = parse_scenario(BETWEEN)
    assert [is_moored(held, body) for body in ("barge", "tug")] == [True, True]
    assert lines_at(held, "tug") == ["stern"]
    to_tug = "to: [30 m, 0 m, 0 m]\n    held_by: tug\n    type: spring"
    adrift = spoiled("to: [100 m, 0 m, -15 m]", to_tug, BETWEEN)
    loose = parse_scenario(spoiled("    sea_bed: -15 m\n", "", adrift))
    assert [is_moored(loose, body) for body in ("barge", "tug")] == [False, False]


def test_a_distributed_line_waits_and_is_cut_at_its_fairlead() -> None:
    """Its tension is that of its first piece for conditions, the largest along it in results."""
    nodes = spoiled("type: spring", "type: distributed, rope_nodes: 8", BETWEEN)
    plan = spoiled("by: 0.2 m", "until: {mooring_tension: {line: stern, above: 160 kN}}", nodes)
    document = assemble(parse_scenario(plan)).document
    assert document["plan"][0]["until"]["segments"] == [["mooring.stern/0", 0]]
    recording = Simulation(parse_scenario(spoiled("by: 0.2 m", "by: 0.2 m, cut: mooring.stern", nodes))).run()
    assert recording.column("mooring_tension", "stern")[-1] == 0.0
    whole = Simulation(parse_scenario(nodes)).run(until=0.1)
    assert whole.column("rope_end_tension", "mooring.stern")[0, 0] == pytest.approx(150e3, rel=1e-9)
    assert whole.column("mooring_tension", "stern")[0] >= 150e3


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        ("held_by: tug", "held_by: tog", r"mooring_lines\.stern\.held_by: 'tog' is not a vessel.*'tug'"),
        (
            "held_by: tug",
            "held_by: barge",
            r"held_by: 'barge' is the vessel that it holds; a line has two ends",
        ),
        (
            "type: spring",
            "type: catenary",
            r"held_by: the lower end of a catenary stands still; .*'distributed'",
        ),
        ("type: spring", "type: spring, rope_nodes: 5", r"rope_nodes: only a distributed line has nodes"),
        (
            "type: spring",
            "type: distributed, under_water: true",
            r"'under_water' is for catenaries; leave it out$",
        ),
        (
            "type: spring",
            "type: distributed, winch: {speed: 5 m/min, acceleration: 0.01 m/s^2}",
            r"winch: a line with nodes has no winch; leave it out, or write 'type: spring'$",
        ),
        ("wall: [-1 m, 0 m]", "wall: [-1 m, 0 m], wall_of: barge", r"wall_of: 'barge' is the vessel itself"),
        (
            "wall: [-1 m, 0 m]",
            "wall: [-1 m, 0 m], wall_of: quay",
            r"fenders\.f1\.wall_of: 'quay' is not a vessel",
        ),
    ],
)
def test_what_lines_and_fenders_between_bodies_refuse(right: str, wrong: str, message: str) -> None:
    with pytest.raises(ScenarioError, match=message):
        parse_scenario(spoiled(right, wrong, BETWEEN))


def test_the_least_pretension_of_a_distributed_line_is_named() -> None:
    """No length pulls less than what its weight does at best; one without mass has none to hang by."""
    nodes = spoiled("type: spring", "type: distributed", BETWEEN)
    with pytest.raises(
        ScenarioError, match=r"mooring_lines\.stern\.pretension: no length .* of 1 kN; its weight"
    ):
        assemble(parse_scenario(spoiled("pretension: 150 kN, type", "pretension: 1 kN, type", nodes)))
    with pytest.raises(
        ScenarioError, match=r"rope: the mass of rope 'bare' is not known, and a distributed line"
    ):
        parse_scenario(spoiled("rope: moor_44, pretension", "rope: bare, pretension", nodes))


def test_a_distributed_line_that_hangs_in_the_water_is_told() -> None:
    """A slack one of 70 m between ends 62 m apart, 1 m above the water."""
    nodes = spoiled("pretension: 150 kN, type: spring", "length: 70 m, type: distributed", BETWEEN)
    wet = spoiled("mechanics:", "water: {density: 1025 kg/m^3, level: 9 m}\nmechanics:", nodes)
    dry, told = assemble(parse_scenario(nodes)).doubts, assemble(parse_scenario(wet)).doubts
    [doubt] = [one for one in told if one not in dry]
    assert doubt.path == "mooring_lines.stern"
    assert re.search(
        r"stern hangs 1\d\.\d m deep in the water at the start, and its nodes weigh", doubt.sentence
    )
