"""From yard words to mechanics: bodies, ropes, contacts, drives and plan of the document."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.assembly import Assembly, assemble
from gantline.scenario import load_scenario, parse_scenario, template
from lift_text import BASE, MECHANICS, spoiled

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"
G = 9.81


def reference() -> Assembly:
    return assemble(load_scenario(SCENARIOS / "equalizer"))


def named(items: list[dict[str, Any]], name: str) -> dict[str, Any]:
    return next(item for item in items if item["name"] == name)


def test_bodies_of_the_reference_lift() -> None:
    bodies = reference().document["bodies"]
    sheaves = [f"e1.{place}" for place in range(1, 6)]
    assert [body["name"] for body in bodies] == ["test_hook", "e1", *sheaves, "block"]
    hook, frame, load = bodies[0], bodies[1], bodies[-1]
    assert hook["joint"]["type"] == "slider" and hook["joint"]["axis"] == [0, 0, 1]
    assert hook["joint"]["drive"] == "test_hook.hoist" and hook["mass"] == 0.0
    assert hook["placement"]["position"] == [0, 0, 36.483]
    assert (
        frame["parent"] == "test_hook"
        and frame["joint"]["type"] == "hinge"
        and frame["joint"]["axis"] == [0, 0, 1]
    )
    # a box of 8 m, 1.6 m, 3.3 m and 20 t about its axes: m/12 (a² + b²)
    box = [20e3 / 12 * (1.6**2 + 3.3**2), 20e3 / 12 * (8**2 + 3.3**2), 20e3 / 12 * (8**2 + 1.6**2), 0, 0, 0]
    assert frame["inertia"] == pytest.approx(box, rel=1e-8)
    assert frame["centre_of_gravity"] == [0, 0, -5]
    for place, along in enumerate((-3.2, -1.6, 0.0, 1.6, 3.2)):
        sheave = bodies[2 + place]
        assert sheave["parent"] == "e1" and sheave["joint"]["axis"] == [0, 0, -1]  # travel down is positive
        assert sheave["placement"]["position"] == [along, 0, -8.65] and sheave["mass"] == 300
    # a homogeneous box of 10 m, 10 m, 5 m and 300 t
    assert load["inertia"] == pytest.approx([3125e3, 3125e3, 5000e3, 0, 0, 0])
    # at rest on four springs: 2.5 m - 300 t g/(4 * 200 MN/m)
    assert load["joint"]["position"] == pytest.approx([0, 0, 2.5 - 300e3 * G / 8e8], abs=1e-14)
    assert load["joint"]["position"][2] == pytest.approx(2.49632125, abs=1e-12)


def test_a_frame_that_tilts_hangs_in_what_turns() -> None:
    """About the vertical, then about its length and its width, each with its friction and damping."""
    hinge = "hinge: {friction: 3 kN m, tilts: true, tilt_friction: 2 kN m, tilt_damping: 1 kN m s}"
    hinge += "\n    heading: 30 deg"
    adaptive = spoiled("integrator: del, step: 1 ms, ", "")
    tilting = assemble(parse_scenario(spoiled("hinge: {damping: 1 kN m s}", hinge, adaptive)))
    turn, over, frame = (named(tilting.document["bodies"], name) for name in ("e1/turn", "e1/over", "e1"))
    assert [one["parent"] for one in (turn, over, frame)] == ["hook", "e1/turn", "e1/over"]
    assert [one["joint"]["axis"] for one in (turn, over, frame)] == [[0, 0, 1], [1, 0, 0], [0, 1, 0]]
    assert [one["joint"]["friction"] for one in (turn, over, frame)] == [3e3, 2e3, 2e3]
    assert [one["joint"]["damping"] for one in (turn, over, frame)] == [0.0, 1e3, 1e3]
    assert turn["joint"]["position"] == pytest.approx(math.radians(30))
    assert [one["mass"] for one in (turn, over)] == [0.0, 0.0]
    (equalizer,) = tilting.rig["equalizers"]
    assert (equalizer["heading_joint"], equalizer["tilts"]) == ("e1/turn", True)
    assert equalizer["bearing"] == pytest.approx([0.0, 0.0, 2.0])


def test_the_rig_knows_every_rope() -> None:
    text = spoiled(
        "thick: {axial_stiffness: 100 MN,", "thick: {construction: 6x36WS-IWRC, diameter: 46 mm, grade: 1960,"
    )
    assembly = assemble(parse_scenario(text.replace("mass: none}", "mass: 9 kg/m}")))
    ropes = assembly.rig["ropes"]
    assert [rope["name"] for rope in ropes] == [rope["name"] for rope in assembly.document["ropes"]]
    equalizing, sling = ropes[0], named(ropes, "sling.S1")
    assert (equalizing["construction"], equalizing["diameter"]) == ("6x36WS-IWRC", pytest.approx(0.046))
    assert equalizing["mass_per_length"] == pytest.approx(0.409 * 46**2 / 100)  # kg/m
    assert equalizing["minimum_breaking_force"] == pytest.approx(0.356 * 46**2 * 1960)  # N
    assert (sling["construction"], sling["diameter"], sling["minimum_breaking_force"]) == (None, None, None)
    assert sling["mass_per_length"] == 9.0


def test_plain_ropes_are_in_the_rig() -> None:
    text = spoiled("{inextensible: true}", "{inextensible: true, minimum_breaking_force: 25 kN}", MECHANICS)
    (rope,) = assemble(parse_scenario(text)).rig["ropes"]
    assert (rope["name"], rope["minimum_breaking_force"], rope["mass_per_length"]) == ("rope", 25e3, 0.0)


def test_ropes_of_the_reference_lift() -> None:
    ropes = reference().document["ropes"]
    assert [rope["name"] for rope in ropes] == [
        "e1.equalizing",
        *(f"sling.S{place}" for place in range(1, 6)),
    ]
    equalizing = ropes[0]
    # ten parts of 2 m and nine half turns of 0.8 m diameter
    assert equalizing["length"] == pytest.approx(20 + 9 * math.pi * 0.4, rel=1e-14)
    assert equalizing["material"] == {"type": "elastic", "axial_stiffness": 100e6, "damping_time": 0.002}
    route = equalizing["route"]
    assert [guide["body"] for guide in route[1:-1:2]] == [f"e1.{place}" for place in range(1, 6)]
    assert all(guide["bulge"] == [0, 0, -1] for guide in route[1:-1:2])
    assert [guide["body"] for guide in route[2:-1:2]] == ["e1"] * 4
    assert all(guide["bulge"] == [0, 0, 1] for guide in route[2:-1:2])
    assert route[0] == {"type": "end", "body": "e1", "at": [-3.6, 0, -6.65]}
    assert route[-1] == {"type": "end", "body": "e1", "at": [3.6, 0, -6.65]}
    uppers = [-3.6, -2.8, -2.0, -1.2, -0.4, 0.4, 1.2, 2.0, 2.8, 3.6]  # every part is plumb
    ends = [route[0]["at"][0]]
    for guide in route[2:-1:2]:
        ends += [guide["enter"][0], guide["leave"][0]]
    assert [*ends, route[-1]["at"][0]] == pytest.approx(uppers, abs=1e-12)
    sling = named(ropes, "sling.S4")
    assert sling["length"] == 26 and sling["material"]["axial_stiffness"] == 200e6
    assert sling["route"] == [
        {"type": "end", "body": "e1.4", "at": [0, 0, 0]},
        {"type": "end", "body": "block", "at": [-2.5, -2.5, 2.5]},
    ]


def test_contacts_of_the_reference_lift() -> None:
    contacts = reference().document["contacts"]
    assert [contact["name"] for contact in contacts] == [f"block.corner_{place}" for place in range(1, 9)]
    corners = {tuple(contact["at"]) for contact in contacts}
    assert corners == {(x, y, z) for x in (-5, 5) for y in (-5, 5) for z in (-2.5, 2.5)}
    assert [contact["at"][2] for contact in contacts] == [-2.5] * 4 + [2.5] * 4
    for contact in contacts:
        assert contact["group"] == contact["body"] == "block"
        assert (contact["stiffness"], contact["damping_time"], contact["friction"]) == (200e6, 0.01, 0.5)


def test_plan_and_settings_of_the_reference_lift() -> None:
    assembly = reference()
    hoist, hold = assembly.document["plan"]
    move = {"drive": "test_hook.hoist", "velocity": 0.1, "acceleration": 0.1, "shape": "linear"}
    assert hoist == {
        "name": "hoist",
        "moves": [move],
        "start_at": 0.0,
        "until": {"type": "brake_from", "time": 25.0},
    }
    assert hold == {"name": "hold", "moves": [], "start_at": None, "until": {"type": "end_of_run"}}
    assert assembly.document["drives"] == [{"name": "test_hook.hoist", "ramps": []}]
    assert assembly.document["gravity"] == [0, 0, -9.81]
    method = {"type": "adaptive", "tension_tolerance": None, "position_tolerance": None}
    run = {"duration": 40.0, "sample_interval": 0.02, "start": "as_given"}
    assert assembly.settings == {"integrator": method, **run}


def test_the_creep_plan() -> None:
    plan = assemble(load_scenario(SCENARIOS / "equalizer_yard")).document["plan"]
    assert [step["until"]["type"] for step in plan] == [
        "load_transferred", "duration", "load_transferred", "duration",
        "clear", "distance", "duration", "distance",
    ]  # fmt: skip
    half = {"type": "load_transferred", "group": "block", "weight": pytest.approx(300e3 * G), "at_least": 0.5}
    assert plan[2]["until"] == half
    assert plan[2]["moves"][0]["velocity"] == pytest.approx(0.5 / 60)
    assert plan[2]["moves"][0]["acceleration"] == 0.1  # the hoist's own


def test_lowering_goes_down() -> None:
    step = "{step: down, lower: hook, speed: 3 m/min, acceleration: 0.05 m/s^2, by: 2 m}"
    text = spoiled("{step: hold, hold: until_end}", step)
    lower = assemble(parse_scenario(text)).document["plan"][1]
    assert lower["moves"][0]["velocity"] == pytest.approx(-0.05) and lower["moves"][0]["acceleration"] == 0.05
    assert lower["until"] == {"type": "distance", "distance": -2.0}


def test_masses_of_slings_and_shackles_are_lumped() -> None:
    text = BASE.replace("mass: none}", "mass: 10 kg/m}").replace("mass: 0 kg}", "mass: 21 kg}")
    assembly = assemble(parse_scenario(text))
    bodies = assembly.document["bodies"]
    half = 10 * 13 / 2  # half of a sling of 13 m at each end
    assert named(bodies, "e1.1")["mass"] == pytest.approx(200 + half + 21)
    assert named(bodies, "e1.2")["mass"] == pytest.approx(200 + half)  # sling S2 has no shackles
    load = named(bodies, "block")
    first, second = half + 21, half  # at lugs L1 (-3, 0, 3) and L2 (3, 0, 3)
    mass = 60e3 + first + second
    centre = np.array([3 * (second - first), 0, 60e3 * 1.5 + 3 * (first + second)]) / mass
    assert load["mass"] == pytest.approx(mass)
    assert assembly.rig["loads"][0]["centre_of_gravity_from_datum"] == pytest.approx(centre, abs=1e-12)
    assert assembly.rig["loads"][0]["weight"] == pytest.approx(mass * G)
    # about the vertical: the box, and points 3 m from the middle, all brought to the common centre of gravity
    about_vertical = 60e3 / 12 * (8**2 + 6**2) + (first + second) * 3**2 - mass * centre[0] ** 2
    assert load["inertia"][2] == pytest.approx(about_vertical, rel=1e-12)
    about_across = 60e3 / 12 * (8**2 + 3**2) + 60e3 * 1.5**2 + (first + second) * (3**2 + 3**2)
    about_across -= mass * (centre[0] ** 2 + centre[2] ** 2)
    assert load["inertia"][1] == pytest.approx(about_across, rel=1e-12)
    assert assembly.rig["loads"][0]["lugs"]["L1"]["at"] == pytest.approx(np.array([-3, 0, 3]) - centre)


def test_the_design_weight_can_be_simulated() -> None:
    text = spoiled("contingency: 1.05}", "contingency: 1.05, simulate: design}")
    assembly = assemble(parse_scenario(text))
    assert named(assembly.document["bodies"], "block")["mass"] == pytest.approx(63e3)
    assert assembly.rig["loads"][0]["calculated_mass"] == 60e3
    assert assembly.rig["loads"][0]["design_mass"] == pytest.approx(63e3)


def test_a_load_that_leans_on_one_side() -> None:
    text = spoiled("{at: [0 m, 0 m, 1.5 m]}", "{at: [0.5 m, 0 m, 1.5 m]}")
    load = named(assemble(parse_scenario(text)).document["bodies"], "block")
    # small tilt about y on four springs at x = ±4 m: k (4 * 4²) tilt = W (0.5 m + 1.5 m * tilt)
    tilt = 60e3 * G * 0.5 / (200e6 * 64 - 60e3 * G * 1.5)
    w, x, y, z = load["joint"]["orientation"]
    assert 2 * math.asin(y) == pytest.approx(tilt, rel=1e-3)
    assert w == pytest.approx(1) and x == pytest.approx(0, abs=1e-12) and z == pytest.approx(0, abs=1e-12)
    sunk = 60e3 * G / (4 * 200e6) + 0.5 * tilt  # the centre of gravity is 0.5 m down the slope
    assert load["joint"]["position"][2] == pytest.approx(1.5 - sunk, abs=1e-8)


def test_a_load_that_is_turned() -> None:
    text = spoiled("  position: [0 m, 0 m, 0 m]", "  position: [1 m, 2 m, 0 m]\n  heading: 90 deg")
    text = text.replace("{at: [0 m, 0 m, 1.5 m]}", "{at: [0.5 m, 0 m, 1.5 m]}").replace("13 m", "15 m")
    load = named(assemble(parse_scenario(text)).document["bodies"], "block")
    # the load's x axis is world y: the centre of gravity is 0.5 m further along world y
    assert load["joint"]["position"][:2] == pytest.approx([1.0, 2.5])
    w, x, y, z = load["joint"]["orientation"]
    assert 2 * math.atan2(z, w) == pytest.approx(math.pi / 2, abs=1e-6)
    # leaning about world -x, seen from the load's axes about its y
    assert math.hypot(x, y) == pytest.approx(60e3 * G * 0.5 / (200e6 * 64) / 2, rel=1e-3)


def test_an_equalizer_with_a_heading() -> None:
    assembly = assemble(
        parse_scenario(spoiled("    hangs_from: hook", "    hangs_from: hook\n    heading: 30 deg"))
    )
    frame = named(assembly.document["bodies"], "e1")
    assert frame["joint"]["position"] == pytest.approx(math.radians(30))
    assert frame["joint"]["damping"] == 1e3
    assert named(assembly.document["ropes"], "e1.equalizing")["length"] == pytest.approx(
        8 + 3 * math.pi * 0.4
    )


def test_slings_right_under_a_hook() -> None:
    assembly = assemble(parse_scenario(template()))
    bodies, ropes = assembly.document["bodies"], assembly.document["ropes"]
    assert [body["name"] for body in bodies] == ["hook", "block"]
    assert ropes[0]["route"][0] == {"type": "end", "body": "hook", "at": [0, 0, 0]}
    # upper halves of four slings of 44 mm (0.409 * 44²/100 kg/m), and four shackles of 21 kg
    lengths = [rope["length"] for rope in ropes]
    assert bodies[0]["mass"] == pytest.approx(0.409 * 44**2 / 100 * sum(lengths) / 2 + 4 * 21)
    hook = assembly.rig["hooks"][0]
    assert hook["bearing_joints"] == ["hook"] and hook["direct_slings"] == []


def test_a_hook_block_counts_in_the_hoist_load_only() -> None:
    text = spoiled("    rated_capacity: 100 t", "    rated_capacity: 100 t\n    hook_block_mass: 2 t")
    assembly = assemble(parse_scenario(text))
    assert assembly.rig["hooks"][0]["hoist_weight_extra"] == pytest.approx(2e3 * G)
    assert assembly.document["bodies"][0]["mass"] == 0.0


def test_plain_mechanics_one_to_one() -> None:
    assembly = assemble(parse_scenario(MECHANICS))
    beam, left, right = assembly.document["bodies"]
    assert beam["joint"] == {"type": "fixed"} and beam["parent"] is None
    assert left["parent"] == "beam" and left["placement"]["position"] == [-0.2, 0, -3] and right["mass"] == 11
    rope = assembly.document["ropes"][0]
    assert rope["material"] == {"type": "inextensible"}
    assert rope["length"] is None, "as routed: the core lays it along its route"
    assert rope["route"][1] == {
        "type": "half_turn", "body": "beam", "enter": [-0.2, 0, 0], "leave": [0.2, 0, 0], "bulge": [0, 0, 1]
    }  # fmt: skip
    contact = assembly.document["contacts"][0]
    assert contact["group"] == "right" and contact["damping_time"] == 0
    assert assembly.scene["sheaves"] == [
        {"body": "beam", "centre": [0, 0, 0], "axis": [0, 1, 0], "radius": 0.2, "kind": "fixed"}
    ]


JOINTS = """\
format: 1
lift: {title: All joints}
duration: 1 s
mechanics:
  bodies:
    tip:
      parent: arm
      at: [1 m, 0 m, 0 m]
      joint: {type: ball, orientation: {about: [0, 0, 2], angle: 90 deg}}
      mass: 1 kg
    arm:
      orientation: {about: [0, 0, 1], angle: 90 deg}
      joint: {type: hinge, axis: [0, 1, 0], motion: [{at: 1 s, duration: 2 s, velocity: 6 deg/s}]}
      mass: 2 kg
      centre_of_gravity: [0.5 m, 0 m, 0 m]
      inertia: {xx: 1 kg m^2, yy: 2 kg m^2, zz: 2 kg m^2, xy: 0.1 kg m^2}
    node: {at: [0 m, 0 m, 1 m], joint: {type: point, velocity: [1 m/s, 0 m/s, 0 m/s]}, mass: 1 kg}
    top:
      joint: {type: free, angular_velocity: [1 rad/s, 0, 0]}
      mass: 1 kg
      inertia: {xx: 1 kg m^2, yy: 1 kg m^2, zz: 1 kg m^2}
"""


def test_every_joint_of_mechanics() -> None:
    document = assemble(parse_scenario(JOINTS)).document
    assert [body["name"] for body in document["bodies"]] == ["arm", "tip", "node", "top"]  # parents first
    arm, tip, node, top = document["bodies"]
    half = math.sqrt(0.5)
    assert arm["placement"]["orientation"] == pytest.approx([half, 0, 0, half])
    assert arm["joint"]["drive"] == "arm.motion" and arm["inertia"] == [1, 2, 2, 0.1, 0, 0]
    ramp = {"at": 1.0, "duration": 2.0, "velocity": pytest.approx(math.radians(6)), "shape": "smooth"}
    assert document["drives"] == [{"name": "arm.motion", "ramps": [ramp]}]
    assert tip["joint"]["orientation"] == pytest.approx([half, 0, 0, half])
    assert node["joint"] == {"type": "point", "position": [0, 0, 0], "velocity": [1, 0, 0]}
    assert top["joint"]["type"] == "free" and top["joint"]["angular_velocity"] == [1, 0, 0]


@pytest.mark.parametrize(
    "text", [BASE, MECHANICS, JOINTS, template()], ids=["base", "mechanics", "joints", "template"]
)
def test_everything_that_is_handed_on_is_json(text: str) -> None:
    assembly = assemble(parse_scenario(text))
    assert json.loads(assembly.document_text()) == assembly.document
    for part in (assembly.settings, assembly.rig, assembly.scene):
        assert json.loads(json.dumps(part, allow_nan=False)) == part


@pytest.mark.parametrize("lift", sorted(path.parent.name for path in SCENARIOS.glob("*/scenario.yaml")))
def test_what_every_scenario_hands_to_the_core_comes_back_as_it_was(lift: str) -> None:
    """Every number of the document keeps its bits as text, and is finite."""
    assembly = assemble(load_scenario(SCENARIOS / lift))
    assert json.loads(assembly.document_text()) == assembly.document


def test_the_rig_in_si_units() -> None:
    rig = reference().rig
    assert rig["hooks"][0]["rated_capacity"] == pytest.approx(400e3 * G)
    assert rig["hooks"][0]["bearing_joints"] == ["e1"]
    assert rig["equalizers"][0]["slings"] == [f"sling.S{place}" for place in range(1, 6)]
    assert (rig["equalizers"][0]["travel_up"], rig["equalizers"][0]["travel_down"]) == (1.4, 1.9)
    assert rig["slings"][0]["shackles"]["top"] == {
        "name": "wb75",
        "working_load_limit": pytest.approx(75e3 * G),
        "minimum_breaking_force": None,
        "proof_load": None,
        "bow_diameter": 0.12,
        "pin_diameter": 0.07,
    }
    assert rig["slings"][0]["tolerance"] == pytest.approx(0.0025)
    assert rig["loads"][0]["lugs"]["L1"]["main_plate_normal"] == [0, 1, 0]
    assert rig["limits"]["smallest_sling_tension_when_clear"] == 10e3
    steps = assemble(load_scenario(SCENARIOS / "equalizer_yard")).rig["plan"]
    assert steps[6]["require"] == {
        "load_tilt": {"below": math.radians(1)},
        "equalizer_travel_used": {"below": pytest.approx(0.9)},
    }
    assert steps[0]["drives"] == ["test_hook.hoist"] and steps[1]["kind"] == "hold"


def test_the_scene_has_all_that_is_drawn() -> None:
    scene = reference().scene
    kinds = {body["name"]: body["kind"] for body in scene["bodies"]}
    assert kinds == {
        "test_hook": "hook",
        "e1": "frame",
        **{f"e1.{n}": "sheave" for n in range(1, 6)},
        "block": "load",
    }
    assert named(scene["bodies"], "block")["shape"] == {
        "type": "box",
        "size": [10, 10, 5],
        "centre": [0, 0, 0],
    }
    assert [sheave["kind"] for sheave in scene["sheaves"]] == ["moving", "fixed"] * 4 + ["moving"]
    assert all(sheave["radius"] == pytest.approx(0.4) for sheave in scene["sheaves"])
    assert [rope["kind"] for rope in scene["ropes"]] == ["equalizing"] + ["sling"] * 5
    assert scene["ground"] == {"level": 0.0}


@pytest.mark.parametrize(("height", "off"), [(5.8, None), (6.4, "1.4 m")])
def test_a_lug_in_mid_air_is_told(height: float, off: str | None) -> None:
    """The load is 5 m high; lugs up to 1 m off its box stand on something that the box leaves out."""
    text = (SCENARIOS / "equalizer" / "scenario.yaml").read_text(encoding="utf-8")
    text = text.replace("L3: {at: [ 0 m,    0 m,   5 m]", f"L3: {{at: [ 0 m,    0 m,   {height} m]")
    text = text.replace("to: block.L3, length: 26 m", f"to: block.L3, length: {31 - height:g} m")
    told = [one for one in assemble(parse_scenario(text)).warnings if "lug" in one]
    assert told == ([] if off is None else [f"lug L3 lies {off} outside the load's box"])
