"""Derivatives of an equilibrium from its factorised tangent, against equilibria of lifts that differ."""

from __future__ import annotations

import copy
import json
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from gantline import _core
from gantline.scenario import Scenario, parse_scenario
from gantline.scenario.file.variants import with_value
from gantline.statics import Equilibrium, Losses, Statics
from hooked_lift import TWO_HOOKS, two_hooks
from mechanics import Floats, G, Json, body, document, end, free, half_turn, rope, slider
from resting import at_rest, four_slings, one_equalizer

STEPS = {
    "length": 2e-2,
    "stiffness": 8e6,
    "mass": 2000.0,
    "centre_x": 8e-3,
    "centre_y": 8e-3,
    "centre_z": 8e-3,
}
#: Central differences of eighth order (Fornberg 1988): weights of what lies 1 to 4 steps to either side.
EIGHTH = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
REFERENCE = Path(__file__).resolve().parents[2] / "scenarios" / "equalizer" / "scenario.yaml"
LUGS = ((-2.5, 2.5), (2.5, 2.5), (0, 0), (-2.5, -2.5), (2.5, -2.5))


def changed(system: Json, kind: str, name: str, step: float) -> Json:
    other = copy.deepcopy(system)
    one = next(one for one in (*other["ropes"], *other["bodies"]) if one["name"] == name)
    if kind == "length":
        one["length"] += step
    elif kind == "stiffness":
        one["material"]["axial_stiffness"] += step
    elif kind == "mass":
        one["mass"] += step
    else:
        one["centre_of_gravity"]["xyz".index(kind[-1])] += step
    return other


def differences(system: Json, kind: str, name: str) -> Floats:
    """dT/dp by central differences of eighth order."""
    step = STEPS[kind]
    at = {k: at_rest(changed(system, kind, name, k * step)).tensions for k in range(-4, 5) if k}
    either_side = np.array([at[k] - at[-k] for k in (1, 2, 3, 4)])
    slope: Floats = np.array(EIGHTH) @ either_side / step
    return slope


@pytest.mark.parametrize("system", ["four slings", "equalizer"])
def test_sensitivities_are_the_derivatives(system: str) -> None:
    """Sensitivities from the tangent against differences of equilibria of lifts that differ."""
    if system == "four slings":
        lift = four_slings(2e8, 0.01)
        slings = [f"s{i}" for i in range(4)]
    else:
        lift = one_equalizer(LUGS, lengths=[23, 26, 26, 26.3, 23], offset=(0.1, -0.2))
        slings = [f"s{i}" for i in range(5)]
    wanted = [(kind, name) for kind in ("length", "stiffness") for name in slings]
    wanted += [(kind, "load") for kind in ("centre_x", "centre_y", "centre_z", "mass")]
    core = _core.Statics(json.dumps(lift))
    core.settle()
    clear = 0
    for (kind, name), found in zip(wanted, core.sensitivities(wanted)["rope_tension"], strict=True):
        derivative = differences(lift, kind, name)
        # Tensions are right to 1e-7 N: e = ℓ − L of 1e-14 m times EA/L of 9 MN/m. Weights add up to 2.1. What
        # is left out is 576 (h/p)⁸ of what goes with 1/p: 4e-9 of EA, which has the widest steps.
        noise = 4e-7 / STEPS[kind]
        assert found == pytest.approx(derivative, rel=1e-8, abs=noise), (kind, name)
        clear += np.abs(derivative).max() > 1e6 * noise
    # An equalizer takes the effect of most of them away.
    assert clear >= (11 if system == "four slings" else 3)


def test_the_weight_of_a_load_is_shared_alike() -> None:
    """Four plumb slings: dT/dm = g/4, dT/dL = ∓ k/4."""
    # Four plumb slings: dT/dm = g/4, dT/dL = −/+ k/4 with k = EA/L, but for their strain of 4e-5.
    core = _core.Statics(json.dumps(four_slings(2e10, 0.0)))
    core.settle()
    mass, length = core.sensitivities([("mass", "load"), ("length", "s0")])["rope_tension"]
    assert mass == pytest.approx([9.81 / 4] * 4, rel=1e-6)
    assert length == pytest.approx(np.array([-1, 1, -1, 1]) * 2e9 / 4, rel=1e-3)


def test_asking_for_what_is_not_there() -> None:
    """Ropes and quantities that there are not are refused by name."""
    core = _core.Statics(json.dumps(four_slings(2e8, 0.0)))
    core.settle()
    with pytest.raises(ValueError, match="there is no s9 to ask the length of"):
        core.sensitivities([("length", "s9")])
    with pytest.raises(ValueError, match="there is no parameter colour"):
        core.sensitivities([("colour", "s0")])


def test_what_nothing_holds_has_none() -> None:
    """Two equal weights over a sheave are in balance anywhere, and so is a load tilted about level lugs.

    A change of either weight sets both going: dT/dm = g/2 would be that of weights that gather speed. A
    longer rope does not. A load on two plumb slings whose lugs are level with its centre of gravity rolls
    where that is shifted across them; shifted along them it does not, T = W (1/2 ∓ x/2a).
    """
    weights = [body(name, slider(), 3000.0, position=(x, 0, 5)) for name, x in (("l", -0.5), ("r", 0.5))]
    over = half_turn(None, (0, 0, 10), 0.5, over=True)
    sling = rope("s", None, [end("l"), over, end("r")], 1e7)
    core = _core.Statics(json.dumps(document(weights, ropes=[sling])))
    assert core.settle()["neutral"] == 1
    found = core.sensitivities([("mass", "l"), ("length", "s"), ("mass", "r"), ("stiffness", "s")])
    assert found["held"].tolist() == [0, 1, 0, 1]

    half, length, mass = 4.0, 10.0, 60e3
    load = body("load", free((0, 0, 0)), mass, inertia=(2e5, 4e5, 4e5))
    slings = [
        rope(name, length, [end(None, (x, 0, length)), end("load", (x, 0, 0))], 1e9)
        for name, x in (("a", -half), ("b", half))
    ]
    core = _core.Statics(json.dumps(document([load], ropes=slings)))
    core.settle()
    found = core.sensitivities([("centre_x", "load"), ("centre_y", "load"), ("mass", "load")])
    assert found["held"].tolist() == [1, 0, 1]
    # The slings stretch by 3e-4 of their length, and tilt the load as the centre goes along.
    assert found["rope_tension"][0] == pytest.approx(mass * G / (2 * half) * np.array([-1, 1]), rel=1e-3)


def resolved(
    scenario: Scenario,
    path: str,
    given: float,
    step: float,
    losses: Losses,
    values: Callable[[Equilibrium], Floats],
) -> Floats:
    """Derivatives of what equilibria say over a quantity of the lift file, by differences of fourth order."""
    at = {
        k: values(Statics(with_value(scenario, path, f"{given + k * step!r} m")).equilibrium(losses=losses))
        for k in (-2, -1, 1, 2)
    }
    slope: Floats = (8 * (at[1] - at[-1]) - (at[2] - at[-2])) / (12 * step)
    return slope


@pytest.mark.parametrize("place", ["A.x", "A.y", "B.x", "B.z"])
def test_places_of_hooks(place: str) -> None:
    """Tensions, and place and attitude of the load, over the place of a hook and the length of a sling."""
    scenario = parse_scenario(two_hooks())
    hook, axis = place.split(".")
    slings = [f"sling.S{number}" for number in (1, 2, 3, 4)]

    def values(rest: Equilibrium) -> Floats:
        pose = rest.recording.column("body_position", "load")[-1]
        quaternion = rest.recording.column("body_orientation", "load")[-1]
        return np.array([*(rest.tension(rope) for rope in slings), *pose, *quaternion])

    given = TWO_HOOKS[hook]["xyz".index(axis)]
    wanted = resolved(scenario, f"cranes.{hook}.at.{axis}", given, 2e-3, "none", values)
    question = Statics(scenario)
    w, x, y, z = question.equilibrium().recording.column("body_orientation", "load")[-1]
    (found,) = question.sensitivities([(f"place_{axis}", hook)])
    assert [found.of(rope) for rope in slings] == pytest.approx(wanted[:4], rel=1e-6, abs=1e-3)
    motion = found.of_body("load")
    assert motion[:3] == pytest.approx(wanted[4:7], rel=1e-6, abs=1e-8)
    # dq/dp = ½ ω q of the unit quaternion q and the rotation vector ω in world axes.
    half = 0.5 * np.array([[-x, -y, -z], [w, z, -y], [-z, w, x], [y, -x, w]]) @ motion[3:]
    assert half == pytest.approx(wanted[7:], rel=1e-6, abs=1e-9)
    assert found.of_body(hook)[:3] == pytest.approx(np.eye(3)["xyz".index(axis)], abs=1e-15)


@pytest.mark.parametrize("losses", ["none", "forward", "backward"])
def test_where_sheaves_slip(losses: Losses) -> None:
    """Lengths of slings under an equalizer whose nine sheaves lose 2 % each, slipping either way."""
    text = REFERENCE.read_text(encoding="utf-8")
    scenario = parse_scenario(
        text.replace("efficiency: 1.0, rotating_mass: 0 kg", "efficiency: 0.98, rotating_mass: 100 kg")
    )
    slings = [f"sling.S{number}" for number in (1, 2, 3, 4, 5)]
    wanted = resolved(
        scenario, "slings.S2.length", 26.0, 5e-3, losses,
        lambda rest: np.array([*(rest.tension(rope) for rope in slings)]),
    )  # fmt: skip
    question = Statics(scenario)
    question.equilibrium(losses=losses)
    (found,) = question.sensitivities([("length", "sling.S2")])
    # Losses are followed to 1e-12 of 600 kN, over steps of 5 mm.
    assert [found.of(rope) for rope in slings] == pytest.approx(wanted, rel=1e-6, abs=1e-3)
    assert np.abs(wanted).max() > 200.0


SLOPE = """
format: 1
lift: {title: A box slides down a slope until its rope holds it}
duration: 10 s
start: rest
ropes: {line: {axial_stiffness: 2 MN}}
mechanics:
  bodies: {box: {joint: {type: point}, mass: 2000 kg}}
  ropes:
    line:
      rope: line
      length: 5 m
      route: [{type: end, body: world, at: [-4.2867607 m, 0 m, 2.475 m]}, {type: end, body: box}]
  contacts:
    foot:
      body: box
      plane: {point: [0 m, 0 m, 0 m], normal: [0.5, 0, 0.8660254037844386]}
      stiffness: 10 MN/m
      friction: 0.3
"""


def test_what_has_slid_sticks_where_it_stands() -> None:
    """Held, T = m g (sin 30° − µ cos 30°) by how the box came there; there rope and contact are springs side
    by side, k₁ = EA/L and k₂, for the weight along the slope: dT/dm = g sin 30° k₁/(k₁ + k₂). Without
    friction it is g sin 30° = T/m.
    """
    g, aside, stiffness, contact = 9.81, math.radians(30.0), 2e6 / 5.0, 1e7
    statics = Statics(parse_scenario(SLOPE))
    rest = statics.equilibrium(losses="held")
    assert rest.tension("line") == pytest.approx(
        2000 * g * (math.sin(aside) - 0.3 * math.cos(aside)), rel=1e-3
    )
    (found,) = statics.sensitivities([("mass", "box")])
    # The rope leaves the slope by the depth of the foot, and its stiffness is EA/ℓ, both a share of 1e-3.
    share = stiffness / (stiffness + contact)
    assert found.of("line") == pytest.approx(g * math.sin(aside) * share, rel=2e-3)
    statics.equilibrium()
    (found,) = statics.sensitivities([("mass", "box")])
    assert found.of("line") == pytest.approx(g * math.sin(aside), rel=1e-5)


@pytest.mark.parametrize("by", [1.0, 3.0])
def test_sensitivities_of_a_rope_that_a_drum_has_hauled_in(by: float) -> None:
    """A weight in a guide on two plumb ropes, one of them hauled in by a drum with a drive.

    With k = EA/L of the length L outside and the strain ε of that rope, T + T' = W gives
    dT/dL = -k k' (1 + ε)/(k + k') and dT/dEA = k' (ℓ - L)/L/(k + k'), and T' the opposite.
    """
    stiffness, weight = (2e6, 3e6), 4000.0 * G
    routes = [
        [
            {"type": "end", "body": "world", "at": [f"{x} m", "0 m", "10 m"], **drum},
            {"type": "end", "body": "box", "at": [f"{x} m", "0 m", "0 m"]},
        ]
        for x, drum in ((-1, {"drum": "d"}), (1, {}))
    ]
    given = {
        "format": 1,
        "lift": {"title": "A weight on two ropes"},
        "duration": "300 s",
        "ropes": {
            f"r{n}": {"axial_stiffness": f"{ea} N", "damping_time": "0.1 s"} for n, ea in enumerate(stiffness)
        },
        "mechanics": {
            "drums": {
                "d": {
                    "diameter": "1 m",
                    "rotating_mass": "100 kg",
                    "drive": {"speed": "1 m/min", "acceleration": "0.01 m/s^2"},
                }
            },
            "bodies": {"box": {"mass": "4 t", "joint": {"type": "slider", "axis": [0, 0, 1]}}},
            "ropes": {
                "hauled": {"rope": "r0", "length": f"{9.978 + by} m", "route": routes[0]},
                "fast": {"rope": "r1", "length": "9.98 m", "route": routes[1]},
            },
        },
        "plan": [
            {"step": "go", "haul_in": "d", "speed": "0.9 m/min", "by": f"{by} m"},
            {"step": "end", "hold": "until_end"},
        ],
    }
    question = Statics(parse_scenario(json.dumps(given)))
    rest = question.equilibrium()
    tension, other = rest.tension("hauled"), rest.tension("fast")
    assert min(tension, other) > 0.1 * weight
    strain, span = tension / stiffness[0], 9.98 * (1.0 + other / stiffness[1])
    long = span / (1.0 + strain)
    k, beside = stiffness[0] / long, stiffness[1] / 9.98
    found = question.sensitivities([("length", "hauled"), ("stiffness", "hauled")])
    expected = (-k * beside * (1.0 + strain) / (k + beside), beside * (span - long) / long / (k + beside))
    for one, slope in zip(found, expected, strict=True):
        assert one.of("hauled") == pytest.approx(slope, rel=1e-9)
        assert one.of("fast") == pytest.approx(-slope, rel=1e-9)
