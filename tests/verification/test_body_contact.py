"""Bodies with shapes that touch each other, against closed forms."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gantline.scenario import ScenarioError
from hull_lift import HULL, G, lift, simulated
from mechanics import Json, Run, adaptive, body, document, free, simulate

STIFFNESS = 1e8


def inertia(mass: float, size: tuple[float, float, float]) -> tuple[float, float, float]:
    x, y, z = (mass / 12 * side * side for side in size)
    return y + z, x + z, x + y


def box(name: str, mass: float, size: tuple[float, float, float], **start: Any) -> Json:
    """A free homogeneous box."""
    return body(name, free(**start), mass, inertia=inertia(mass, size))


def shape(name: str, size: Any, of: str | None = None, centre: Any = (0, 0, 0)) -> Json:
    return {"name": name, "body": of, "parts": [{"type": "box", "size": list(size), "centre": list(centre)}]}


def pair(one: str, other: str, friction: float = 0.4, damping_time: float = 0.01, **more: Any) -> Json:
    law = {"stiffness": STIFFNESS, "damping_time": damping_time, "friction": friction}
    return {"name": f"{one}.{other}", "group": one, "shapes": [one, other], **law, **more}


SLAB = shape("slab", (400, 400, 20), None, (0, 0, -10))


def force(run: Run, name: str) -> np.ndarray:
    """Sum of the normal forces of a pair (time,) [N]."""
    at = [index for index, one in enumerate(run.names["contact"]) if one.startswith(f"{name}/")]
    total: np.ndarray = run.columns["contact_force"][:, at].sum(axis=1)
    return total


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_boxes_in_a_stack_carry_the_weight_above_them(method: str) -> None:
    """Each of three boxes bears all that is above it; nothing creeps in ten minutes."""
    masses, sizes = (3000.0, 2000.0, 500.0), ((4, 4, 1), (2, 3, 2), (3, 1, 1))
    heights, level = [], 0.0
    for size in sizes:
        heights.append(level + size[2] / 2)
        level += size[2]
    names = ("low", "middle", "top")
    bodies = [
        box(name, mass, size, position=(0.1 * k, -0.1 * k, height))
        for k, (name, mass, size, height) in enumerate(zip(names, masses, sizes, heights, strict=True))
    ]
    shapes = [SLAB, *(shape(name, size, name) for name, size in zip(names, sizes, strict=True))]
    pairs = [pair("low", "slab"), pair("middle", "low"), pair("top", "middle")]
    system = document(bodies, shapes=shapes, pairs=pairs)
    run = (
        adaptive(system, 600.0, tension_tolerance=None, position_tolerance=None, sample_interval=10.0)
        if method == "adaptive"
        else simulate(system, 60.0, step=5e-3, sample_interval=1.0)
    )
    carried = np.cumsum(masses[::-1])[::-1] * G
    for name, below, weight in zip(names, ("slab", "low", "middle"), carried, strict=True):
        assert force(run, f"{name}.{below}")[-1] == pytest.approx(
            weight, rel=1e-9 if method == "del" else 1e-7
        )
    half = len(run.time) // 2
    for name in names:
        place = run.body(name)[half:]
        assert np.abs(place - place[0]).max() < 1e-8


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_a_box_comes_back_from_a_wall_as_fast_as_it_came(method: str) -> None:
    """Undamped and without friction: u₊ = −u, the wall's force on the way integrates to 2 m u."""
    size, mass, speed = (2.0, 1.0, 1.0), 1000.0, 1.0
    start = box("box", mass, size, position=(0, 0, 0), velocity=[speed, 0, 0])
    wall = shape("wall", (2, 10, 10), None, (3.0, 0, 0))
    system = {**document([start], shapes=[shape("box", size, "box"), wall]), "gravity": [0, 0, 0]}
    system["pairs"] = [pair("box", "wall", friction=0.0, damping_time=0.0)]
    run = adaptive(system, 3.0) if method == "adaptive" else simulate(system, 3.0, step=1e-4)
    velocity = run.body("box", "body_velocity")
    # It meets the wall with 4 corners: ω = √(4 k/m) = 632 rad/s. A step h of `del` loses ω h π of the energy.
    allowed = 1e-6 if method == "adaptive" else 0.5 * 632 * 1e-4 * math.pi * 1.2
    assert velocity[-1, 0] == pytest.approx(-speed, rel=allowed)
    assert np.abs(velocity[-1, 1:]).max() < 1e-9
    assert run.energy_remainder < (1e-6 if method == "adaptive" else 1e-3)


def test_two_free_boxes_that_meet_keep_their_momentum() -> None:
    """Equal masses, centre to centre, undamped: they exchange their velocities; momentum stays."""
    size, mass = (1.0, 1.0, 1.0), 500.0
    bodies = [
        box("one", mass, size, position=(0, 0, 0), velocity=[2.0, 0.0, 0.0]),
        box("other", mass, size, position=(3.0, 0, 0), velocity=[-1.0, 0.0, 0.0]),
    ]
    system = {**document(bodies), "gravity": [0, 0, 0]}
    system["shapes"] = [shape(name, size, name) for name in ("one", "other")]
    system["pairs"] = [pair("one", "other", friction=0.3, damping_time=0.0)]
    run = adaptive(system, 2.0)
    one, other = (run.body(name, "body_velocity") for name in ("one", "other"))
    assert one[-1, 0] == pytest.approx(-1.0, abs=1e-6)
    assert other[-1, 0] == pytest.approx(2.0, abs=1e-6)
    assert (one + other)[:, 0] == pytest.approx(np.full(len(run.time), 1.0), abs=1e-9)


def test_an_oblique_blow_turns_both_boxes_and_keeps_angular_momentum() -> None:
    """Off centre and with friction: momentum, and angular momentum about the origin, stay."""
    size, mass = (1.0, 1.0, 1.0), 500.0
    bodies = [
        box("one", mass, size, position=(0, 0.3, 0.2), velocity=[2.0, 0.5, 0.0]),
        box("other", mass, size, position=(1.6, 0, 0), velocity=[0.0, 0.0, 0.0]),
    ]
    system = {**document(bodies), "gravity": [0, 0, 0]}
    system["shapes"] = [shape(name, size, name) for name in ("one", "other")]
    system["pairs"] = [pair("one", "other", friction=0.5)]
    run = adaptive(system, 1.5)
    moments = np.zeros((len(run.time), 3))
    total = np.zeros((len(run.time), 3))
    for name in ("one", "other"):
        momentum = mass * run.body(name, "body_velocity")
        moments += np.cross(run.body(name), momentum) + run.spin(name, inertia(mass, size))[1]
        total += momentum
    spin = run.body("other", "body_angular_velocity")
    assert np.abs(spin[-1]).max() > 0.1  # it does turn
    assert np.abs(total - total[0]).max() < 1e-6 * mass
    # Spots that are found anew move by less than 0.1 mm: what that does to moments.
    assert np.abs(moments - moments[0]).max() < 1e-3 * np.abs(moments[0]).max()
    assert run.energy_remainder < 1e-4


@pytest.mark.parametrize("angle", [0.9, 1.1])
def test_a_box_slides_on_a_fixed_box_beyond_the_friction_angle(angle: float) -> None:
    """On a box that is turned by α: at rest below tan α = μ, a = g (sin α − μ cos α) above."""
    friction, size, mass = 0.4, (1.0, 1.0, 0.4), 800.0
    slope = angle * math.atan(friction)
    turned = [math.cos(slope / 2), 0.0, math.sin(slope / 2), 0.0]
    up = np.array([math.sin(slope), 0.0, math.cos(slope)])
    depth = mass * G * math.cos(slope) / (4 * STIFFNESS)
    start = box("box", mass, size, position=list((0.2 - depth) * up), orientation=turned)
    ramp = {"type": "box", "size": [200, 50, 2], "centre": list(-up), "orientation": turned}
    system = document(
        [start], shapes=[shape("box", size, "box"), {"name": "ramp", "body": None, "parts": [ramp]}]
    )
    system["pairs"] = [pair("box", "ramp", friction=friction)]
    run = adaptive(system, 3.0, tension_tolerance=1.0, position_tolerance=1e-5)
    down = np.array([math.cos(slope), 0.0, -math.sin(slope)])
    along = run.body("box") @ down
    if angle < 1.0:
        assert abs(along[-1] - along[150]) < 1e-6
        return
    velocity = run.body("box", "body_velocity") @ down
    late = run.time > 1.0
    rate = np.polyfit(run.time[late], velocity[late], 1)[0]
    assert rate == pytest.approx(G * (math.sin(slope) - friction * math.cos(slope)), rel=1e-3)


def test_a_box_hinged_to_the_world_lies_on_a_free_box() -> None:
    """Bodies on any joints: a beam hinged at one end rests on a box with half of its weight."""
    beam = body("beam", {}, 0.0)
    beam["joint"] = {"type": "hinge", "axis": [0, 1, 0], "position": 0.0}
    beam |= {
        "mass": 600.0,
        "centre_of_gravity": [2.0, 0, 0],
        "inertia": [*inertia(600.0, (4.0, 0.5, 0.5)), 0, 0, 0],
    }
    beam["placement"]["position"] = [0, 0, 1.25]
    hull = box("hull", 1000.0, (1.0, 1.0, 1.0), position=(3.6, 0, 0.5))
    system = document([beam, hull])
    system["shapes"] = [
        SLAB,
        shape("beam", (4.0, 0.5, 0.5), "beam", (2.0, 0, 0)),
        shape("hull", (1.0, 1.0, 1.0), "hull"),
    ]
    system["pairs"] = [pair("hull", "slab"), pair("beam", "hull")]
    run = adaptive(system, 20.0, tension_tolerance=1.0, position_tolerance=1e-6)
    # Between the hull's near edge at 3.1 m and the beam's end at 4 m: moment of the weight about the hinge.
    contact = force(run, "beam.hull")[-1]
    assert 600 * G * 2.0 / 4.0 <= contact <= 600 * G * 2.0 / 3.1
    assert force(run, "hull.slab")[-1] == pytest.approx(1000 * G + contact, rel=1e-6)


DOCK = {"type": "dock", "x": ["10 m", "70 m"], "y": ["-200 m", "200 m"], "floor": "-12 m"}


@pytest.mark.parametrize("integrator", ["adaptive", "del"])
def test_the_ground_around_a_dock_is_the_ground(tmp_path: Path, integrator: str) -> None:
    """The load on it rests as on the same ground without a dock: its lower corners, k at each."""
    load = {**HULL["load"], "stands_on": "ground", "position": ["-35 m", "0 m", "0 m"]}
    plain = lift(supports=None, load=load, slings=None, plan=[])
    one = simulated(tmp_path, plain, integrator=integrator)
    other = simulated(tmp_path, {**plain, "structures": {"dock": DOCK}}, integrator=integrator)
    expected = sorted(one.variables["contact_force"].values[-1])[-4:]
    found = sorted(other.variables["contact_force"].values[-1])
    assert found[-4:] == pytest.approx(expected, rel=1e-9)
    assert max(found[:-4]) == 0.0
    assert sum(found) == pytest.approx(350e3 * G, rel=1e-9)


def test_a_load_is_lowered_to_the_floor_of_a_dock(tmp_path: Path) -> None:
    """Hung over the dock it passes the level of the ground and stands on the floor."""
    load = {**HULL["load"], "position": ["40 m", "0 m", "-10.5 m"]}
    del load["stands_on"]
    given = lift(
        supports=None,
        load=load,
        structures={"dock": DOCK},
        start="as_given",
        duration="110 s",
        plan=[
            {"step": "down", "lower": "hook", "speed": "2 m/min", "by": "3 m"},
            {"step": "end", "hold": "until_end"},
        ],
        watch=[{"between": ["hull", "dock.walls"], "smallest": "9 m"}],
    )
    given["cranes"] = {"hook": {**HULL["cranes"]["hook"], "at": ["38 m", "0 m", "28.9 m"]}}
    recording = simulated(tmp_path, given, sample_interval=0.1)
    bottom = recording.variables["body_position"].values[:, -1, 2] - 4.8
    assert bottom[-1] == pytest.approx(-12.0, abs=0.01)
    assert recording.column("load_transferred", "hull")[-1] == pytest.approx(0.0, abs=1e-6)
    # 8.5 m from either end of the hull to the walls: too close from the start.
    assert recording.metrics()["smallest_clearance.hull - dock.walls"] == pytest.approx(8.5, abs=0.1)
    assert ("too_close", "hull - dock.walls") in {(kind, name) for _, kind, name in recording.events()}
    assert any("hull comes within 8." in warning for warning in recording.attributes["warnings"])


def test_a_load_is_set_down_on_another_body(tmp_path: Path) -> None:
    """`body_contacts` of `mechanics`: a table that is fixed to the world, 3 m high."""
    load = {**HULL["load"], "position": ["-35 m", "0 m", "3 m"]}
    del load["stands_on"]
    table = {
        "joint": {"type": "fixed"},
        "at": ["-36 m", "0 m", "0 m"],
        "mass": "10 t",
        "shape": {"box": ["20 m", "10 m", "3 m"], "centre": ["0 m", "0 m", "1.5 m"]},
    }
    contact = {"between": ["hull", "table"], "stiffness": "200 MN/m", "damping": "2 MN s/m", "friction": 0.3}
    mechanics = {"bodies": {"table": table}, "body_contacts": {"on_table": contact}}
    given = lift(supports=None, load=load, slings=None, plan=[], mechanics=mechanics, duration="20 s")
    recording = simulated(tmp_path, given)
    assert recording.column("load_transferred", "hull")[-1] == pytest.approx(0.0, abs=1e-7)
    contacts = [name for name in recording.coordinates["contact"] if name.startswith("on_table/")]
    carried = [float(recording.column("contact_force", name)[-1]) for name in contacts]
    # The four corners of the table's top, x = −46 and −26 m, about the centre of gravity at −37 m.
    assert sorted(carried)[-4:] == pytest.approx(
        [350e3 * G / 4 * 0.9] * 2 + [350e3 * G / 4 * 1.1] * 2, rel=1e-3
    )


@pytest.mark.parametrize(
    ("changes", "line"),
    [
        ({"structures": {"dock": {**DOCK, "floor": "1 m"}}}, "is not below the ground"),
        ({"structures": {"dock": {**DOCK, "x": ["70 m", "10 m"]}}}, "from less to more is right"),
        ({"structures": {"dock": DOCK, "pit": DOCK}}, "'dock' is a dock already"),
        ({"structures": {"hull": DOCK}}, "already the name of"),
        ({"watch": [{"between": ["hull", "dok"]}]}, "'dok' has no shape"),
        ({"watch": [{"between": ["slings", "ropes"]}]}, "distances between ropes are not recorded"),
        ({"watch": [{"between": ["hull", "ground"]}] * 2}, "is watched already"),
    ],
)
def test_structures_and_watches_that_cannot_be_are_refused(
    tmp_path: Path, changes: dict[str, Any], line: str
) -> None:
    """Each mistake has its own sentence."""
    with pytest.raises(ScenarioError) as refused:
        simulated(tmp_path, lift(**changes))
    assert line in str(refused.value)
