"""Wind, current and areas that resist, against closed forms."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gantline
from gantline.assembly import assemble
from gantline.scenario import load_scenario
from gantline.statics import Statics
from json_lift import plain_lift, vessel
from lift_text import spoiled

G, AIR, SEA = 9.81, 1.225, 1025.0


def area(size: float, along: str = "x", **given: Any) -> dict[str, Any]:
    return {"area": f"{size!r} m^2", "coefficient": 1.2, "along": along, **given}


def blown(mass: float = 2000.0, **given: Any) -> dict[str, Any]:
    """A body that slides along x, with an area of 100 m² in the wind."""
    joint = {"type": "slider", "axis": [1, 0, 0], **given.pop("joint", {})}
    return {"joint": joint, "mass": f"{mass} kg", "wind_areas": {"side": area(100.0)}, **given}


def energies(recording: gantline.Recording) -> dict[str, Any]:
    table = recording.dataset["energy"]
    return {str(kind): table.sel(energy_kind=kind).values for kind in table["energy_kind"].values}


def carried(folder: Path, **simulation: str) -> gantline.Recording:
    """A body of 2 t at rest in wind of 20 m/s, for 10 s."""
    wind = {"speed": f"{SPEED} m/s", "direction": "0 deg"}
    path = plain_lift(folder, {"body": blown()}, wind=wind, duration="10 s", simulation=simulation)
    return gantline.simulate(path)


SPEED = 20.0
#: m/cu, the time in which the body comes to half of the wind's speed [s].
HALF = 2000.0 / (0.5 * AIR * 1.2 * 100.0 * SPEED)


def of_carried(recording: gantline.Recording) -> tuple[Any, Any]:
    """Speeds as they are and as they should be: m v̇ = c (u − v)², v = u − u/(1 + c u t/m) [m/s]."""
    time = recording.dataset["time"].values
    return recording.dataset["body_velocity"].values[:, 0, 0], SPEED - SPEED / (1 + time / HALF)


def test_a_body_is_carried_along(tmp_path: Path) -> None:
    """Wind puts in u times the momentum, half of m v² of it is kept and the rest lost. A step lets through an
    error of speed of ten position tolerances per second by the estimate of the method of order 4 in it, here
    0.1 mm/s, 5e-6 of the wind's speed. What goes on is of order 5, better by some h/T, T = m/cu = 1.36 s, and
    nears the wind's speed whatever it was before: 1e-6. The work is that of the course of steps, to the same.
    """
    recording = carried(tmp_path, integrator="adaptive", position_tolerance="0.01 mm")
    velocity, wanted = of_carried(recording)
    assert velocity == pytest.approx(wanted, abs=1e-6 * SPEED)
    found, last = energies(recording), wanted[-1]
    assert found["fluid_work"][-1] == pytest.approx(2000 * SPEED * last, rel=1e-6)
    assert found["drag"][-1] == pytest.approx(2000 * (SPEED * last - last**2 / 2), rel=1e-6)
    assert np.all(np.diff(found["drag"]) >= 0)
    # Both are booked at the same points of the course: that closes to rounding.
    assert np.abs(found["remainder"]).max() < 1e-12 * found["kinetic"][-1]


def test_a_body_is_carried_along_by_del(tmp_path: Path) -> None:
    """`del` has the resistance at the mean of the velocities before and after a step. With w = u − v,
    ẇ = −k w² and s = 1 + t/T that leaves h² (f' ẅ/8 − w⃛/24) = −h² k³ w⁴/4 of the equation, so that w is
    off by −u (h/T)² (s − 1)/4s³, most at s = 3/2: (h/T)²/27, and terms of (h/T)⁴. The momentum of a step is
    its force times h, so the work of the wind is u times the momentum to rounding; of the loss, ½ Σ m Δv²,
    h/6T (1 − 1/s³) of m u² and terms of (h/T)², is the method's own.
    """
    step = 5e-3
    recording = carried(tmp_path, integrator="del", step=f"{step} s")
    velocity, wanted = of_carried(recording)
    ratio = step / HALF
    error = np.abs(velocity - wanted).max() / SPEED
    assert error == pytest.approx(ratio**2 / 27, rel=0.01)
    found, last = energies(recording), velocity[-1]
    assert found["fluid_work"][-1] == pytest.approx(2000 * SPEED * last, rel=1e-12)
    lost = found["drag"][-1] + found["method"][-1]
    assert lost == pytest.approx(2000 * (SPEED * last - last**2 / 2), rel=1e-12)
    whole = 1 - (1 + 10 / HALF) ** -3
    assert found["method"][-1] == pytest.approx(2000 * SPEED**2 * ratio / 6 * whole, rel=2 * ratio)
    assert np.all(np.diff(found["drag"]) >= 0)
    assert np.abs(found["remainder"]).max() < 1e-12 * found["kinetic"][-1]


def test_terminal_speed_between_wind_and_water(tmp_path: Path) -> None:
    """Wind and standing water on one body: c_a (u − v)² = c_w v². It comes near like
    exp(−2 √(c_a c_w) u t/m), which is below 1e-13 at the end.
    """
    body = blown(current_areas={"below": area(3.0)})
    wind = {"speed": "25 m/s", "direction": "0 deg"}
    recording = gantline.simulate(plain_lift(tmp_path, {"body": body}, wind=wind, duration="20 s"))
    ratio = math.sqrt(SEA * 3.0 / (AIR * 100.0))
    assert recording.dataset["body_velocity"].values[-1, 0, 0] == pytest.approx(25 / (1 + ratio), rel=1e-6)
    found = energies(recording)
    assert np.abs(found["remainder"]).max() < 1e-6 * found["fluid_work"][-1]


def test_steady_offset_is_force_over_stiffness(tmp_path: Path) -> None:
    """A spring that wind presses: F/k, in statics and once a run has settled."""
    spring = {"upper": "0 m", "stiffness": "50 kN/m", "damping": "20 kN s/m"}
    body = blown(joint={"stops": spring})
    wind = {"speed": "30 m/s", "direction": "0 deg", "density": "1.3 kg/m^3"}
    path = plain_lift(tmp_path, {"body": body}, wind=wind, duration="10 s")
    offset = 0.5 * 1.3 * 1.2 * 100.0 * 30.0**2 / 50e3
    found = Statics(path).equilibrium().recording.dataset["body_position"].values[-1, 0, 0]
    assert found == pytest.approx(offset, rel=1e-9)
    assert gantline.simulate(path).dataset["body_position"].values[-1, 0, 0] == pytest.approx(
        offset, rel=1e-6
    )


def test_a_pendulum_leans_into_the_angle_of_its_own_area(tmp_path: Path) -> None:
    """An area that turns along with the bar it is on gets c u² cos θ along its axis: tan θ = c u²/mg. Small
    swings about it have ω² = (mgL cos θ + c u² L sin θ)/(mL² + I), the second term as the area turns.
    """
    mass, length, inertia, speed = 500.0, 8.0, 900.0, 25.0
    bar = {
        "joint": {"type": "hinge", "axis": [0, -1, 0]},
        "mass": f"{mass} kg",
        "centre_of_gravity": ["0 m", "0 m", f"{-length} m"],
        "inertia": {axis: f"{inertia} kg m^2" for axis in ("xx", "yy", "zz")},
        "wind_areas": {"face": area(8.0, at=["0 m", "0 m", f"{-length} m"])},
    }
    wind = {"speed": f"{speed} m/s", "direction": "0 deg"}
    question = Statics(plain_lift(tmp_path, {"bar": bar}, wind=wind))
    rest = question.equilibrium()
    push = 0.5 * AIR * 1.2 * 8.0 * speed**2
    angle = math.atan(push / (mass * G))
    sine, cosine = math.sin(angle), math.cos(angle)
    x, _, z = rest.recording.dataset["body_position"].values[-1, 0]
    # Forces balance to 1e-9 of their size.
    assert (x, z) == pytest.approx((length * sine, -length * cosine), rel=1e-8)
    stiffness = length * (mass * G * cosine + push * sine)
    (mode,) = question.modes()
    whole = mass * length**2 + inertia
    assert mode.square == pytest.approx(stiffness / whole, rel=1e-7)
    # Swinging changes |w| w_x by (u + u cos² θ) L.
    resistance = push / speed * (1 + cosine**2) * length**2
    assert mode.damping_ratio == pytest.approx(resistance / (2 * math.sqrt(stiffness * whole)), rel=1e-7)


def test_oblique_wind_pushes_both_areas(tmp_path: Path) -> None:
    """At 30° to areas of 20 and 50 m²: forces along x and y of 20 cos 30° and 50 sin 30° times the pressure
    of the whole speed; a weight on a rope leans by them over its weight.
    """
    weight = {
        "joint": {"type": "point", "position": ["0 m", "0 m", "-10 m"]},
        "mass": "3 t",
        "wind_areas": {"end": area(20.0), "side": area(50.0, "y")},
    }
    rope = {
        "rope": "r",
        "length": "10 m",
        "route": [{"type": "end", "body": "world"}, {"type": "end", "body": "w"}],
    }
    path = plain_lift(
        tmp_path,
        {"w": weight},
        mechanics={"ropes": {"hanger": rope}},
        ropes={"r": {"axial_stiffness": "1000 MN"}},
        wind={"speed": "18 m/s", "direction": "30 deg"},
    )
    x, y, z = Statics(path).equilibrium().recording.dataset["body_position"].values[-1, 0]
    pressure = 0.5 * AIR * 1.2 * 18.0**2
    along, across = pressure * 20 * math.cos(math.pi / 6), pressure * 50 * 0.5
    assert (x / -z, y / -z) == pytest.approx((along / (3000 * G), across / (3000 * G)), rel=1e-8)


def test_a_barge_on_one_rope_turns_its_bow_into_the_current(tmp_path: Path) -> None:
    """Held at the bow, at the height of its areas: it lies down-current, the rope stretched by ½ρCAu² L/EA,
    without trim; found from 25° off. Sway and yaw build up together about it, as of any vessel on one line
    (`tests/regression/test_turned_by_wind.py`).
    """
    hull = {"box": ["60 m", "16 m", "5 m"]}
    draft, speed = 2.5, 1.5
    areas = {
        "bow": area(40.0, at=["30 m", "0 m", "2.5 m"]),
        "side": area(150.0, "y", at=["30 m", "0 m", "2.5 m"]),
    }
    barge = vessel(
        SEA * 60 * 16 * draft,
        (30.0, 0.0, 3.0),
        draft,
        hull=hull,
        current_areas=areas,
        heading="155 deg",
        position=["60 m", "-15 m"],
    )
    route = [
        {"type": "end", "body": "world"},
        {"type": "end", "body": "barge", "at": ["60 m", "0 m", "2.5 m"]},
    ]
    path = plain_lift(
        tmp_path,
        {"post": {"joint": {"type": "fixed"}}},
        mechanics={"ropes": {"bow": {"rope": "r", "length": "40 m", "route": route}}},
        ropes={"r": {"axial_stiffness": "20 MN"}},
        vessels={"barge": barge},
        current={"speed": f"{speed} m/s", "direction": "0 deg"},
    )
    statics = Statics(path)
    rest = statics.equilibrium()
    assert rest.stability == "one motion leads away, swinging ever farther"
    assert min(mode.square for mode in statics.modes()) > -1e-6  # and nothing leads straight away
    force = 0.5 * SEA * 1.2 * 40.0 * speed**2
    tension = rest.recording.dataset["rope_tension"].values[-1, 0]
    assert tension == pytest.approx(force, rel=1e-6)
    names = [str(name) for name in rest.recording.dataset["body"].values]
    x, y, z = rest.recording.dataset["body_position"].values[-1, names.index("barge")]
    assert x == pytest.approx(40 * (1 + force / 20e6) + 30.0, rel=1e-6)
    # Forces F balance to 1e-9 of the weight, moments M to that times the radius of gyration, 30 m. With β and
    # ψ the angles of rope and barge, T the rope's pull, N = ½ρCAu² of the side, about the centre of gravity
    # 30 m T (β − ψ) = M and across the stream T (β − ψ) + Nψ = F; it lies 40 m β + 30 m ψ aside: 3.4e-5 m.
    left = 1e-9 * SEA * 60 * 16 * draft * G
    turn = 2 * left / (0.5 * SEA * 1.2 * 150.0 * speed**2)
    assert y == pytest.approx(0.0, abs=40 * (turn + left / tension) + 30 * turn)
    assert z == pytest.approx(3.0 - draft, abs=1e-6)


def test_areas_of_a_load_count_from_its_datum(tmp_path: Path) -> None:
    """The force acts at the place of the lift file, seen from the centre of gravity."""
    path = tmp_path / "lift.yaml"
    text = spoiled("limits: {", "wind: {speed: 12 m/s, direction: 90 deg}\nlimits: {")
    mark = "  lugs:\n"
    assert mark in text
    areas = "  wind_areas: {side: {area: 60 m^2, coefficient: 1.1, along: y, at: [1 m, 2 m, 3 m]}}\n"
    path.write_text(text.replace(mark, areas + mark, 1), encoding="utf-8")
    scenario = load_scenario(path)
    assembly = assemble(scenario)
    (force,) = assembly.document["forces"]
    assert scenario.load is not None
    assert force["body"] == scenario.load.name
    assert force["quadratic"] == pytest.approx([0, 0.5 * AIR * 1.1 * 60, 0, 0, 0, 0])
    assert force["stream"] == pytest.approx([0, 12, 0])
    scene = next(body for body in assembly.scene["bodies"] if body["name"] == scenario.load.name)
    half = np.array(scene["shape"]["size"]) / 2
    datum = np.array(scene["shape"]["centre"]) - [0, 0, half[2]]
    assert np.array(force["at"]) - datum == pytest.approx([1, 2, 3])


def test_without_wind_air_stands(tmp_path: Path) -> None:
    """v̇ = −c v²/m: v = v₀/(1 + c v₀ t/m); a bare speed or 'none' pushes nothing either."""
    body = blown(joint={"velocity": "10 m/s"})
    given = {"position_tolerance": "0.01 mm"}
    recording = gantline.simulate(
        plain_lift(tmp_path, {"body": body}, duration="5 s", wind="none", simulation=given)
    )
    factor, time = 0.5 * AIR * 120.0 / 2000.0, recording.dataset["time"].values
    # As where it is carried along: 0.1 mm/s a step by the estimate, 1e-5 of the speed, and an order better.
    assert recording.dataset["body_velocity"].values[:, 0, 0] == pytest.approx(
        10 / (1 + 10 * factor * time), rel=1e-6
    )
    assert "fluid_work" not in energies(recording)
