"""Words for ropes that break or are cut, and for stops."""

from __future__ import annotations

import math
from typing import Any

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario
from gantline.scenario.plan.parting import partings
from lift_text import BASE, MECHANICS, spoiled

SLING = "S1: {from: e1.1,"
KIND = "{axial_stiffness: 100 MN, damping_time: 2 ms, mass: none}"


def ropes(text: str) -> dict[str, dict[str, Any]]:
    return {rope["name"]: rope for rope in assemble(parse_scenario(text)).document["ropes"]}


def problem(text: str) -> str:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text)
    return str(caught.value)


def with_kind(more: str) -> str:
    return spoiled(KIND, f"{KIND[:-1]}, {more}}}")


def test_a_rope_does_not_part_unless_it_is_said() -> None:
    for rope in ropes(BASE).values():
        assert rope.keys().isdisjoint({"breaking_force", "cut_at"})


def test_a_kind_of_rope_breaks_and_a_sling_may_say_otherwise() -> None:
    text = with_kind("minimum_breaking_force: 900 kN, breaks_at: minimum_breaking_force")
    assert {name: rope.get("breaking_force") for name, rope in ropes(text).items()} == {
        "e1.equalizing": None,
        "sling.S1": 900e3,
        "sling.S2": 900e3,
    }
    for said, force in (("never", None), ("600 kN", 600e3)):
        own = text.replace(SLING, f"{SLING} breaks_at: {said},")
        assert ropes(own)["sling.S1"].get("breaking_force") == force
        assert ropes(own)["sling.S2"]["breaking_force"] == 900e3
        assert partings(parse_scenario(own))["sling.S1"].breaks_at == force


def test_all_slings_by_default() -> None:
    text = spoiled("slings:\n", "sling_defaults: {breaks_at: 700 kN}\nslings:\n")
    assert ropes(text)["sling.S2"]["breaking_force"] == 700e3
    rig = assemble(parse_scenario(text)).rig
    assert {rope["name"]: rope["breaks_at"] for rope in rig["ropes"]} == {
        "e1.equalizing": None,
        "sling.S1": 700e3,
        "sling.S2": 700e3,
    }


def test_an_equalizing_rope_breaks_by_its_kind() -> None:
    text = spoiled("thick: {axial_stiffness: 100 MN,", "thick: {axial_stiffness: 100 MN, breaks_at: 1 MN,")
    assert ropes(text)["e1.equalizing"]["breaking_force"] == 1e6


def test_cuts_at_a_time_and_as_a_step_begins() -> None:
    text = spoiled(SLING, f"{SLING} cut_at: 12 s,").replace(
        "{step: hold,", "{step: hold, cut: [sling.S2, e1.equalizing],"
    )
    assembly = assemble(parse_scenario(text))
    assert {rope["name"]: rope.get("cut_at") for rope in assembly.document["ropes"]} == {
        "e1.equalizing": None,
        "sling.S1": 12.0,
        "sling.S2": None,
    }
    assert [step.get("cuts") for step in assembly.document["plan"]] == [None, ["sling.S2", "e1.equalizing"]]


def test_a_rope_with_nodes_is_cut_at_its_first_end_and_breaks_anywhere() -> None:
    text = with_kind("breaks_at: 900 kN").replace("mass: none", "mass: 16 kg/m")
    text = text.replace(SLING, f"{SLING} cut_at: 3 s, rope_weight: distributed, rope_nodes: 3,")
    text = text.replace("{step: hold,", "{step: hold, cut: sling.S1,")
    assembly = assemble(parse_scenario(text))
    pieces = [rope for rope in assembly.document["ropes"] if rope["name"].startswith("sling.S1/")]
    assert [piece["breaking_force"] for piece in pieces] == [900e3] * 4
    assert [piece.get("cut_at") for piece in pieces] == [3.0, None, None, None]
    assert assembly.document["plan"][1]["cuts"] == ["sling.S1/0"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (with_kind("breaks_at: minimum_breaking_force"), "minimum breaking force of this rope is not known"),
        (with_kind("breaks_at: sometimes"), "or 'minimum_breaking_force' or 'never'"),
        (with_kind("breaks_at: 0 kN"), "breaks_at"),
        (
            spoiled(SLING, f"{SLING} breaks_at: minimum_breaking_force,"),
            "slings.S1.breaks_at: the minimum breaking force of 'sling' is not known",
        ),
        (spoiled(SLING, f"{SLING} cut_at: 21 s,"), "21 s is after the end of the lift at 20 s"),
        (spoiled("{step: hold,", "{step: hold, cut: S1,"), "'S1' is not a rope"),
    ],
)
def test_what_is_wrong_is_said(text: str, expected: str) -> None:
    assert expected in problem(text)


def test_travel_has_stops_where_it_is_said() -> None:
    def stops(text: str) -> dict[str, Any]:
        bodies = assemble(parse_scenario(text)).document["bodies"]
        return {body["name"]: body["joint"].get("stops") for body in bodies}

    assert set(stops(BASE).values()) == {None}
    travel = "travel: {up: 1 m, down: 1 m}"
    given = stops(spoiled(travel, "travel: {up: 0.9 m, down: 1.1 m, stops: true}"))
    law = {"stiffness": 100e6, "damping_time": 2e-3}
    assert given["e1.1"] == given["e1.2"] == {"lower": -0.9, "upper": 1.1, **law}
    assert given["e1"] is given["hook"] is None
    own = "travel: {up: 1 m, down: 1 m, stops: true, stop_stiffness: 50 MN/m, stop_damping_time: 5 ms}"
    assert stops(spoiled(travel, own))["e1.1"]["stiffness"] == 50e6


JOINT = "-3 m], joint: {type: slider, axis: [0, 0, 1]}, mass: 10 kg"


def with_stops(stops: str, kind: str = "slider", axis: str = "[0, 0, 1]") -> str:
    joint = f"joint: {{type: {kind}, axis: {axis}, stops: {{{stops}}}}}"
    return spoiled(JOINT, f"-3 m], {joint}, mass: 10 kg", MECHANICS)


def test_stops_of_plain_joints() -> None:
    text = with_stops("lower: -0.5 m, stiffness: 1 MN/m, damping: 5 kN s/m")
    law = {"lower": -0.5, "upper": None, "stiffness": 1e6, "damping_time": 5e-3, "loaded": False}
    assert stops_of_left(text) == law
    turned = with_stops(
        "upper: 90 deg, stiffness: 2 MN m/rad, damping: 4 kN m s", "hinge", "[0, 1, 0], position: 10 deg"
    )
    law = {"lower": None, "upper": math.pi / 2, "stiffness": 2e6, "damping_time": 2e-3, "loaded": False}
    assert stops_of_left(turned) == law


def stops_of_left(text: str) -> dict[str, Any]:
    bodies = assemble(parse_scenario(text)).document["bodies"]
    [joint] = [body["joint"] for body in bodies if body["name"] == "left"]
    given: dict[str, Any] = joint["stops"]
    return given


@pytest.mark.parametrize(
    ("stops", "expected"),
    [
        ("stiffness: 1 MN/m", "neither 'lower' nor 'upper'"),
        ("lower: 1 m, upper: -1 m, stiffness: 1 MN/m", "'lower' not below 'upper'"),
        ("lower: 1 m, stiffness: 1 MN/m", "a joint starts between its stops, unless they say 'loaded: true'"),
        ("lower: 0 m, upper: 0 m, stiffness: 1 MN/m", "'lower' not below 'upper'"),
        ("lower: -1 m", "stiffness"),
    ],
)
def test_what_is_wrong_with_stops_is_said(stops: str, expected: str) -> None:
    assert expected in problem(with_stops(stops))
