"""The weight of ropes: which body carries what, and what the rig says of it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gantline
from gantline.assembly import Assembly, assemble
from gantline.assembly.parts import Parts, end, sheave
from gantline.assembly.ropes.catenary import end_mass, hang, node_masses
from gantline.assembly.ropes.route import route_lengths
from gantline.assembly.spatial import inertia_matrix
from gantline.scenario import parse_scenario
from lift_text import BASE, MECHANICS, spoiled
from mechanics import G, adaptive

THICK = "thick: {axial_stiffness: 100 MN, damping_time: 2 ms}"
HEAVY = BASE.replace("mass: none", "mass: 8 kg/m").replace(THICK, THICK.replace("2 ms", "2 ms, mass: 9 kg/m"))


def bodies(text: str) -> dict[str, dict[str, Any]]:
    return {body["name"]: body for body in assemble(parse_scenario(text)).document["bodies"]}


def total(assembly: Assembly) -> float:
    return math.fsum(body["mass"] for body in assembly.document["bodies"])


def rig_rope(text: str, name: str) -> dict[str, Any]:
    found: dict[str, Any] = next(r for r in assemble(parse_scenario(text)).rig["ropes"] if r["name"] == name)
    return found


# --- lumped ---------------------------------------------------------------------------------------


def test_an_equalizing_rope_with_a_known_mass_is_lumped_to_frame_and_moving_sheaves() -> None:
    """Four parts of 2 m; each sheave has half of two of them and its arc, each dead end half of one."""
    light, heavy = bodies(BASE), bodies(HEAVY)
    arc = math.pi * 0.4
    slings = 8 * 13 / 2
    for moving in ("e1.1", "e1.2"):
        assert heavy[moving]["mass"] - light[moving]["mass"] == pytest.approx(9 * (2 + arc) + slings)
        assert heavy[moving]["centre_of_gravity"] == [0, 0, 0]
    on_frame = 9 * (4 + arc)
    assert heavy["e1"]["mass"] == pytest.approx(5000 + on_frame)
    # dead ends and the fixed sheave are all 3 m below the hook, the frame's own centre of gravity 2 m
    depth = (5000 * 2 + on_frame * 3) / (5000 + on_frame)
    assert heavy["e1"]["centre_of_gravity"] == pytest.approx([0, 0, -depth])
    about_hook = np.array(light["e1"]["inertia"][:3]) + 5000 * np.array([4, 4, 0])
    ends = 2 * 9 * 1 * 1.2**2  # two dead ends with a metre of rope each, 1.2 m to either side
    added = np.array([on_frame * 9, on_frame * 9 + ends, ends])
    shift = heavy["e1"]["mass"] * depth**2 * np.array([1, 1, 0])
    assert heavy["e1"]["inertia"][:3] == pytest.approx(about_hook + added - shift)
    assert heavy["e1"]["inertia"][3:] == pytest.approx([0, 0, 0], abs=1e-9)


def test_weight_left_out_leaves_the_mechanics_as_without_mass() -> None:
    text = HEAVY.replace("    rope: thick\n", "    rope: thick\n    rope_weight: none\n")
    text = text.replace("\nslings:", "\nsling_defaults: {rope_weight: none}\nslings:")
    assert assemble(parse_scenario(text)).document == assemble(parse_scenario(BASE)).document
    assert rig_rope(text, "e1.equalizing")["weight"] == "none"
    assert rig_rope(text, "sling.S1")["mass_per_length"] == 0.0


def test_lumped_is_what_a_known_mass_means() -> None:
    text = HEAVY.replace("    rope: thick\n", "    rope: thick\n    rope_weight: lumped\n")
    text = text.replace("\nslings:", "\nsling_defaults: {rope_weight: lumped}\nslings:")
    assert assemble(parse_scenario(text)).document == assemble(parse_scenario(HEAVY)).document


def test_no_mass_is_lost_or_made() -> None:
    """Load, frame and sheaves weigh what they did; two slings of 13 m and the equalizing rope come to it."""
    light, heavy = (assemble(parse_scenario(text)) for text in (BASE, HEAVY))
    reeved = 8 + 3 * math.pi * 0.4
    assert total(heavy) - total(light) == pytest.approx(8 * 26 + 9 * reeved)
    ropes = {rope["name"]: rope for rope in heavy.rig["ropes"]}
    assert ropes["e1.equalizing"]["mass"] == pytest.approx(9 * reeved)
    assert (ropes["sling.S1"]["weight"], ropes["sling.S1"]["mass"]) == ("lumped", 8 * 13)
    assert all(rope["mass_on_world"] == 0 for rope in ropes.values())


def test_a_sling_says_for_itself_how_its_weight_acts() -> None:
    text = HEAVY.replace("\nslings:", "\nsling_defaults: {rope_weight: none}\nslings:")
    text = text.replace(
        "length: 13 m, rope: sling, tol", "length: 13 m, rope: sling, rope_weight: lumped, tol"
    )
    assert [rig_rope(text, f"sling.{name}")["mass"] for name in ("S1", "S2")] == [0.0, 8 * 13]


def test_hook_load_has_the_weight_of_rigging_and_rope() -> None:
    """Load 60 t, frame 5 t, two sheaves of 200 kg, ropes of 80 and 90 kg/m: all below the bearing."""
    text = HEAVY.replace("mass: 8 kg/m", "mass: 80 kg/m").replace("mass: 9 kg/m", "mass: 90 kg/m")
    text = text.replace("brake_from: 10 s", "brake_from: 25 s").replace("duration: 20 s", "duration: 60 s")
    recording = gantline.simulate(parse_scenario(text), integrator="adaptive")
    ropes = 80 * 26 + 90 * (8 + 3 * math.pi * 0.4)
    assert ropes > 0.04 * 65400
    static = recording.metrics()["static_hook_load"]
    assert static == pytest.approx((60e3 + 5e3 + 400 + ropes) * G, rel=1e-3)
    weight = recording.rig.loads[0].weight
    assert weight == pytest.approx((60e3 + 80 * 13) * G)
    assert recording["load_transferred"].values[0, 0] == pytest.approx(0.0, abs=1e-6)


PLAIN = """\
format: 1
lift: {title: A box on a rope}
duration: 2 s
ropes:
  heavy: {axial_stiffness: 20 MN, damping_time: 2 ms, mass: 10 kg/m}
mechanics:
  bodies:
    box:
      at: [0 m, 0 m, -8 m]
      mass: 500 kg
      inertia: {xx: 90 kg m^2, yy: 80 kg m^2, zz: 60 kg m^2}
      joint:
        type: free
        velocity: [0.4 m/s, 0.1 m/s, 0 m/s]
        angular_velocity: [0.1 rad/s, 0 rad/s, 0.2 rad/s]
  ropes:
    rope:
      rope: heavy
      length: 8 m
      route: [{type: end, body: world}, {type: end, body: box, at: [0.3 m, 0 m, 0.4 m]}]
"""


def test_what_hangs_on_the_world_is_borne_by_it_and_said() -> None:
    rope = rig_rope(PLAIN, "rope")
    assert (rope["mass"], rope["mass_on_world"]) == (80.0, 40.0)
    assert bodies(PLAIN)["box"]["mass"] == 540.0


def test_a_driven_body_takes_its_share() -> None:
    joint = "joint: {type: slider, axis: [0, 0, 1], motion: [{at: 0 s, duration: 1 s, velocity: 1 m/s}]}"
    text = PLAIN.replace("  bodies:\n", f"  bodies:\n    winch: {{{joint}}}\n")
    text = text.replace("body: world", "body: winch")
    assert bodies(text)["winch"]["mass"] == 40.0
    assert rig_rope(text, "rope")["mass_on_world"] == 0.0


def test_a_mass_lumped_on_a_free_body_moves_it_like_a_body_that_was_given_so() -> None:
    """The same body described about its new centre of gravity, without rope weight, has the same motion."""
    lumped = bodies(PLAIN)["box"]
    shift = np.array(lumped["centre_of_gravity"])
    assert shift == pytest.approx(40 / 540 * np.array([0.3, 0, 0.4]))
    document = assemble(
        parse_scenario(PLAIN.replace("length: 8 m", "length: 8 m\n      rope_weight: none"))
    ).document
    box = document["bodies"][0]
    joint = box["joint"]
    box.update(mass=540.0, inertia=lumped["inertia"])
    joint["position"] = [float(part) for part in shift]
    joint["velocity"] = [
        float(part) for part in joint["velocity"] + np.cross(joint["angular_velocity"], shift)
    ]
    document["ropes"][0]["route"][1]["at"] = [float(part) for part in np.array([0.3, 0, 0.4]) - shift]
    runs = [adaptive(given, 2.0) for given in (assemble(parse_scenario(PLAIN)).document, document)]
    place, same = (run.body("box") for run in runs)
    assert np.abs(place - same).max() < 1e-6  # the tolerance of both is 1e-7 a step
    assert np.abs(place - place[0]).max() > 0.4
    assert runs[0].energy_remainder < 1e-8


def test_inertia_of_lumps_is_that_of_point_masses() -> None:
    box = bodies(PLAIN)["box"]
    arm = np.array([0.3, 0, 0.4])
    reduced = 500 * 40 / 540  # two masses about their common centre of gravity
    expected = np.diag([90.0, 80.0, 60.0]) + reduced * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    assert inertia_matrix(box["inertia"]) == pytest.approx(expected)


def test_a_rope_of_mechanics_on_the_load_counts_in_its_weight() -> None:
    extra = """\
mechanics:
  bodies:
    post: {at: [20 m, 0 m, 0 m], joint: {type: fixed}}
  ropes:
    tag:
      rope: sling
      length: 30 m
      route: [{type: end, body: post}, {type: end, body: 'block', at: [4 m, 0 m, 0 m]}]
"""
    assembly = assemble(parse_scenario(HEAVY + extra))
    before = assemble(parse_scenario(HEAVY))
    own = before.rig["loads"][0]
    (load,) = assembly.rig["loads"]
    assert load["weight"] - own["weight"] == pytest.approx(8 * 15 * G)
    share = 8 * 15 * G / load["weight"] * 4.0
    centre, was = load["centre_of_gravity_from_datum"], own["centre_of_gravity_from_datum"]
    assert np.subtract(centre, was) == pytest.approx([share, 0, 0], abs=1e-9)


# --- over sheaves ---------------------------------------------------------------------------------


def test_half_turns_take_their_arc() -> None:
    """3 m down on either side of half a turn of 0.4 m; as routed, and by its share if the rope is longer."""
    text = MECHANICS.replace("{inextensible: true}", "{inextensible: true, mass: 10 kg/m}")
    plain, heavy = bodies(MECHANICS), bodies(text)
    arc = math.pi * 0.2
    assert heavy["left"]["mass"] - plain["left"]["mass"] == pytest.approx(15.0)
    assert heavy["beam"]["mass"] - plain["beam"]["mass"] == pytest.approx(10 * (3 + arc))
    longer = bodies(text.replace("length: as_routed", "length: 10 m"))
    assert longer["left"]["mass"] - plain["left"]["mass"] == pytest.approx(100 * 1.5 / (6 + arc))
    assert longer["beam"]["centre_of_gravity"] == pytest.approx([0, 0, 0])


@pytest.mark.parametrize("across", [0.0, 0.7], ids=["in a plane", "askew"])
def test_lengths_over_sheaves_with_true_tangents_are_those_of_the_core(across: float) -> None:
    """Straight segments agree with what the core finds by its own means, and both with the whole route."""
    text = f"""\
format: 1
lift: {{title: Over two sheaves}}
duration: 1 s
ropes: {{rope: {{axial_stiffness: 20 MN, mass: 10 kg/m}}}}
mechanics:
  bodies:
    beam: {{joint: {{type: fixed}}}}
  ropes:
    rope:
      rope: rope
      length: as_routed
      route:
        - {{type: end, body: world, at: [0 m, 0 m, 0 m]}}
        - {{type: sheave, body: beam, at: [1 m, {across} m, 5 m], axis: [0, 1, 0], diameter: 1 m}}
        - {{type: sheave, body: world, at: [4 m, 0 m, 1 m], axis: [0, -1, 0], diameter: 0.8 m}}
        - {{type: end, body: beam, at: [6 m, 0 m, 6 m]}}
"""
    simulation = gantline.Simulation(parse_scenario(text))
    recording = simulation.run()
    guides = [
        end(None, (0, 0, 0)),
        sheave("beam", (1, across, 5), (0, 1, 0), 0.5),
        sheave(None, (4, 0, 1), (0, -1, 0), 0.4),
        end("beam", (6, 0, 6)),
    ]
    parts = Parts()
    parts.add_body("beam", {"type": "fixed"})
    straight, arcs = route_lengths(parts, guides)
    assert straight == pytest.approx(recording["segment_length"].values[0], rel=1e-9)
    rope = rig_rope(text, "rope")
    assert rope["mass"] == pytest.approx(10 * (straight.sum() + arcs.sum()))
    on_world = straight[0] / 2 + arcs[2] + straight[1] / 2 + straight[2] / 2
    assert rope["mass_on_world"] == pytest.approx(10 * on_world)


# --- distributed ----------------------------------------------------------------------------------


def test_nodes_share_the_mass_of_the_rope() -> None:
    for nodes in (1, 2, 3, 4, 50):
        masses = node_masses(30.0, nodes)
        assert masses.shape == (nodes,)
        assert (masses > 0).all()
        assert masses.sum() + 2 * end_mass(30.0, nodes) == pytest.approx(30.0, rel=1e-14)
        assert masses == pytest.approx(masses[::-1])


def test_a_sling_of_distributed_weight() -> None:
    text = HEAVY.replace(
        "length: 13 m, rope: sling, tol", "length: 13 m, rope: sling, rope_weight: distributed, tol"
    )
    assembly = assemble(parse_scenario(text))
    document = assembly.document
    pieces = [rope for rope in document["ropes"] if rope["name"].startswith("sling.S2")]
    assert [piece["name"] for piece in pieces] == [f"sling.S2/{k}" for k in range(51)]
    assert all(piece["length"] == pytest.approx(13 / 51) for piece in pieces)
    assert pieces[0]["route"][0]["body"] == "e1.2" and pieces[-1]["route"][1]["body"] == "block"
    nodes = [body for body in document["bodies"] if body["name"].startswith("sling.S2/")]
    assert [node["name"] for node in nodes] == [f"sling.S2/{k}" for k in range(1, 51)]
    assert all(node["joint"]["type"] == "point" and node["parent"] is None for node in nodes)
    assert total(assembly) == pytest.approx(total(assemble(parse_scenario(HEAVY))))
    assert [rope["name"] for rope in assembly.rig["ropes"]] == ["e1.equalizing", "sling.S1", "sling.S2"]
    assert [rope["name"] for rope in assembly.scene["ropes"]] == ["e1.equalizing", "sling.S1", "sling.S2"]
    assert not any("/" in body["name"] for body in assembly.scene["bodies"])


ANGLES = st.floats(-math.pi / 2, math.pi / 2, allow_subnormal=False)


@settings(max_examples=200)
@given(
    nodes=st.integers(1, 80),
    elevation=st.one_of(ANGLES, st.sampled_from([math.pi / 2, -math.pi / 2, 0.0])),
    heading=st.floats(-math.pi, math.pi, allow_subnormal=False),
    distance=st.one_of(
        st.floats(0.01, 1.02), st.floats(-9, -2).map(lambda power: 1 - 10**power), st.just(1.0)
    ),
    stiffness=st.floats(3, 9).map(lambda power: 10**power),
)
def test_a_place_at_rest_is_found_wherever_the_ends_are(
    nodes: int, elevation: float, heading: float, distance: float, stiffness: float
) -> None:
    """Slack or taut, plumb or level, EA of 1e3 to 1e9 times the weight: every node is in balance."""
    length, weight = 40.0, 1000.0
    along = np.array([math.cos(elevation) * math.cos(heading), math.cos(elevation) * math.sin(heading)])
    last = distance * length * np.array([*along, math.sin(elevation)])
    weights = node_masses(weight, nodes)
    rest = hang(np.zeros(3), last, length, stiffness * weight, weights)
    part = length / (nodes + 1)
    tension = np.linalg.norm(rest.forces, axis=1)
    largest = max(float(tension.max()), weight)
    assert np.diff(rest.forces, axis=0)[:, :2] == pytest.approx(0.0, abs=1e-9 * largest)
    assert np.diff(rest.forces, axis=0)[:, 2] == pytest.approx(weights, abs=1e-9 * largest)
    reach = np.diff(rest.points, axis=0)
    size = np.linalg.norm(reach, axis=1)
    stretched = part * (1 + tension / (stiffness * weight))
    assert (size <= stretched + 1e-9 * length).all()
    taut = tension > 0
    assert size[taut] == pytest.approx(stretched[taut], abs=1e-9 * length)
    assert (~taut).sum() <= 1
    assert reach[taut] * tension[taut, None] == pytest.approx(
        rest.forces[taut] * size[taut, None], abs=1e-7 * largest * part
    )


def test_a_rope_that_cannot_be_placed_is_said_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gantline.assembly.ropes.catenary._MOST_STEPS", 0)
    text = PLAIN.replace("length: 8 m", "length: 8 m\n      rope_weight: distributed")
    with pytest.raises(gantline.ScenarioError, match=r"mechanics.ropes.rope: no place was found"):
        assemble(parse_scenario(text))


def test_without_gravity_nodes_have_no_place_to_hang() -> None:
    text = PLAIN.replace("length: 8 m", "length: 8 m\n      rope_weight: distributed")
    with pytest.raises(
        gantline.ScenarioError, match="without gravity a rope with nodes has no place to hang"
    ):
        parse_scenario(text + "simulation: {gravity: 0 m/s^2}\n")


def test_the_type_of_an_equalizer_may_say_it_for_its_rope() -> None:
    text = HEAVY.replace("    rope: thick\n", "    type: two\n").replace(
        "equalizers:\n", "equalizer_types:\n  two: {rope: thick, rope_weight: none}\nequalizers:\n"
    )
    assert rig_rope(text, "e1.equalizing")["weight"] == "none"
    own = text.replace("    type: two\n", "    type: two\n    rope_weight: lumped\n")
    assert rig_rope(own, "e1.equalizing")["weight"] == "lumped"
    wrong = text.replace("rope_weight: none", "rope_weight: distributed")
    with pytest.raises(
        gantline.ScenarioError, match=r"equalizer_types\.two\.rope_weight: an equalizing rope runs"
    ):
        parse_scenario(wrong)


def test_a_mass_of_zero_is_no_weight() -> None:
    assert rig_rope(spoiled("mass: none", "mass: 0 kg/m"), "sling.S1")["weight"] == "none"
