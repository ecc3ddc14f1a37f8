"""Drums and winches from the words of a lift file to the document, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gantline.results.rig import Rig
from gantline.results.ropes.flows import rope_flows
from gantline.scenario import ScenarioError, parse_scenario
from gantline.simulation import simulate
from lift_text import MECHANICS, spoiled
from tackle import TACKLE, assembled, flows


def test_drums_and_their_plan() -> None:
    assembly = assembled(TACKLE)
    winch = flows(assembly)["winch"]
    assert (winch["inertia"], winch["drive"], winch["brake"]) == (2000.0, "winch.drive", 0.0)
    route = assembly.document["ropes"][0]["route"]
    assert route[-1]["drum"] == {"flow": "winch", "rate": 1.0} and "drum" not in route[0]
    assert assembly.document["drives"] == [{"name": "winch.drive", "ramps": []}]
    raising, lowering = assembly.document["plan"][:2]
    assert raising["moves"] == [
        {"drive": "winch.drive", "velocity": -0.2, "acceleration": 0.2, "shape": "linear"}
    ]
    assert raising["until"] == {"type": "distance", "distance": -2.0}
    assert lowering["moves"][0]["velocity"] == pytest.approx(0.1)
    assert lowering["moves"][0]["acceleration"] == 0.1
    assert [step["kind"] for step in assembly.rig["plan"]] == ["haul_in", "pay_out", "hold"]
    inertia = [flows(assembly)[f"fall/sheave_{place}"]["inertia"] for place in (1, 2, 3, 4)]
    assert inertia == pytest.approx([30.0] * 4)


def test_a_drive_with_limits() -> None:
    limited = spoiled(
        "acceleration: 0.2 m/s^2}", "acceleration: 0.2 m/s^2, capacity: 80 kN, power: 30 kW}", TACKLE
    )
    winch = flows(assembled(limited))["winch"]
    assert (winch["capacity"], winch["power"]) == (80e3, 30e3)
    assert "capacity" not in flows(assembled(TACKLE))["winch"]


def test_a_drive_with_limits_that_are_too_low_does_not_lift() -> None:
    """20 t on four parts with losses need 56 kN and more at the lead line."""
    strong, weak = (
        simulate(
            parse_scenario(spoiled("0.2 m/s^2}", f"0.2 m/s^2, capacity: {pull}}}", TACKLE)), duration=6.0
        )
        for pull in ("100 kN", "40 kN")
    )
    rises = [run.column("joint_position", "load")[-1] for run in (strong, weak)]
    assert rises[0] > 0.2 and rises[1] < -1.0


def test_two_drums_on_one_shaft() -> None:
    shaft = "shaft: {diameter: 0.6 m, moment_of_inertia: 4.5 t m^2, brake: 10 kN, damping: 1 kN s/m}"
    text = TACKLE.replace("    winch: ", f"    {shaft}\n    winch: ").replace(
        "plan:\n",
        """\
    bight:
      rope: hoist
      length: 20 m
      route:
        - {type: end, body: world, at: [5 m, 0 m, 10 m], drum: shaft}
        - {type: end, body: world, at: [5 m, 0 m, 0 m], drum: shaft, drum_diameter: 0.56 m, wound: against}
plan:
""",
    )
    assembly = assembled(text)
    ends = [guide["drum"] for guide in assembly.document["ropes"][1]["route"]]
    assert [one["flow"] for one in ends] == ["shaft", "shaft"]
    assert [one["rate"] for one in ends] == pytest.approx([1.0, -0.56 / 0.6])
    joint = flows(assembly)["shaft"]
    assert joint["inertia"] == pytest.approx(4500 / 0.3**2) and joint["drive"] is None
    assert (joint["brake"], joint["damping"]) == (10e3, 1e3)


def test_a_motion_given_in_advance() -> None:
    motion = "motion: [{at: 1 s, duration: 2 s, velocity: -6 m/min}]"
    text = TACKLE.replace("drive: {speed: 30 m/min, acceleration: 0.2 m/s^2}", motion)
    assembly = assembled(text[: text.index("plan:")])
    ramp = {"at": 1.0, "duration": 2.0, "velocity": -0.1, "shape": "smooth"}
    assert assembly.document["drives"] == [{"name": "winch.motion", "ramps": [ramp]}]
    assert flows(assembly)["winch"]["drive"] == "winch.motion"


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (
            "rotating_mass: 2 t, drive: {speed: 30 m/min, acceleration: 0.2 m/s^2}",
            "rotating_mass: 2 t",
            "drum 'winch' has no 'drive' that could turn it; give it one, such as",
        ),
        (
            "speed: 12 m/min",
            "speed: 60 m/min",
            "60 m/min is faster than 'winch' can turn; its highest speed is 30 m/min",
        ),
        ("acceleration: 0.1 m/s^2, by", "acceleration: 1 m/s^2, by", "1 m/s^2 is more than 'winch' can do"),
        (
            "acceleration: 0.2 m/s^2}",
            "acceleration: 0.2 m/s^2, power: 30 kW}",
            "'power' is given without 'capacity', the largest pull at low speed",
        ),
        ("haul_in: winch", "haul_in: [winch, winch]", "names a drum twice; each drum stands once"),
        ("haul_in: winch", "haul_in: wench", "'wench' is not a drum; did you mean 'winch'?"),
        ("haul_in: winch", "hoist: winch", "'winch' is a drum of 'mechanics'; 'haul_in' winds its rope up"),
        ("by: 1 m", "until: {supports: clear}", "this waits for a load to leave the ground"),
        ("body: world, at: [1.5", "body: nowhere, at: [1.5", "'nowhere' is not a body"),
        (
            "mass: none}",
            "mass: none}\nsimulation: {integrator: explicit}",
            "'explicit' knows no friction of sheaves and joints",
        ),
    ],
)
def test_errors_of_drums(old: str, new: str, says: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(spoiled(old, new, TACKLE))
    assert says in str(caught.value)


def test_a_rope_with_nodes_has_no_drum() -> None:
    text = spoiled("rope: ideal\n", "rope: ideal\n      rope_weight: distributed\n", MECHANICS)
    text = text.replace("inextensible: true", "axial_stiffness: 1 MN, mass: 1 kg/m")
    text = text.replace("{type: end, body: right}", "{type: end, body: right, drum: winch}")
    text = text.replace("  contacts:", "  drums: {winch: {diameter: 1 m, rotating_mass: 1 t}}\n  contacts:")
    with pytest.raises(ScenarioError, match="a rope with nodes cannot be paid out by a drum"):
        parse_scenario(text)


def test_layers_need_the_thickness_of_the_rope() -> None:
    many = "layers: 2, wraps_per_layer: 20, wraps_at_start: 5, "
    text = TACKLE.replace("winch: {diameter", "winch: {" + many + "diameter")
    with pytest.raises(
        ScenarioError, match="the diameter of rope 'hoist' is not known, which says how thick"
    ):
        parse_scenario(text, "tackle.yaml")
    known = text.replace("layers: 2", "layers: 2, layer_step: 30 mm, wound_under: 20 kN")
    given = assembled(known).document["ropes"][0]["route"][-1]["drum"]
    assert given["layers"] == {"radius": 0.4, "step": 0.03, "turns": 20.0, "start": 5.0}
    assert given["laid_under"] == 20e3


@pytest.mark.parametrize(
    ("turns", "more"),
    [(12.0, 0.0), (19.9, 0.15**2), (20.1, 0.35**2), (30.0, 10.0), (39.9, 20.0 - 0.1 + 0.15**2), (45.0, 30.0)],
)
def test_rope_hauled_in_layer_by_layer(turns: float, more: float) -> None:
    """n turns in layer k are n π (D + 2 (k − 1) δ); within the half turn x in which rope climbs the diameter
    grows by 4 δ x, so that x² of a turn of 2 π δ comes on. 5 turns of 20 in a layer are on at the start.
    """
    drum = {"diameter": 1.0, "layers": 3, "layer_step": 0.04, "wraps_at_start": 5.0, "wraps_per_layer": 20.0}
    rig = Rig.from_json({"drums": [{"name": "winch", "flow": "winch", **drum}]})
    columns = {"joint_position": np.array([[-(turns - 5.0) * math.pi]])}
    found, _ = rope_flows(columns, {"joint": ["winch"]}, rig)
    assert found["drum_wraps"].values[0, 0] == pytest.approx(turns, rel=1e-12)
    wound = math.pi * (turns - 5.0 + 0.08 * more)
    assert -found["rope_paid_out"].values[0, 0] == pytest.approx(wound, rel=1e-12)
