"""Mooring lines against the elastic catenary in closed form, and fenders against the law of their springs.

The simulator's forces are read off the joint that holds the upper end; closed forms are Irvine's (1981), and
with a sea bed Jonkman's (2007, eqs. 2-35 to 2-40, without friction).
"""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq, fsolve

from gantline._core import Statics
from gantline.assembly import assemble
from gantline.checks import check_recording
from gantline.results.rotation import axes
from gantline.scenario import parse_scenario
from gantline.simulation import Simulation
from hanging import Catenary, lift, run
from mechanics import Floats, Json, Run, adaptive, body, document, flow, simulate, slider

TABLE = Path(__file__).resolve().parents[3] / "shared" / "data" / "catenary" / "elastic_catenary_rows.csv"
FIXED: Json = {"type": "fixed"}


def mooring(name: str = "line", **given: Any) -> Json:
    """A line from `barge` to the origin of the world."""
    law = {"weight": 80.0, "axial_stiffness": 89e6, "damping_time": 0.0}
    return {
        "type": "mooring",
        "name": name,
        "body": "barge",
        "at": [0, 0, 0],
        "to": [0, 0, 0],
        **law,
        **given,
    }


def held(place: tuple[float, float], **line: Any) -> Run:
    """A line whose upper end is held at a place along x and up from its lower end; a mass beside it."""
    bodies = [
        body("barge", FIXED, 0.0, position=(place[0], 0, place[1])),
        body("aside", slider(axis=(1, 0, 0)), 1.0),
    ]
    return simulate(document(bodies, forces=[mooring(**line)]), 0.1, step=0.05)


def pull(place: tuple[float, float], **line: Any) -> Floats:
    """H and V of such a line [N]."""
    return held(place, **line).body("barge", "joint_force")[0, [0, 2]]


@pytest.mark.skipif(not TABLE.exists(), reason="the table of catenaries is not beside this checkout")
def test_rows_of_the_table() -> None:
    """H and V of every row to 1e-6: the last of the digits that MoorPy's table has."""
    with TABLE.open(newline="") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    assert rows
    for row in rows:
        line = {"length": row["L_m"], "axial_stiffness": row["EA_N"], "weight": row["w_N_per_m"]}
        found = pull((row["x_m"], row["z_m"]), **line)
        assert found == pytest.approx([row["H_N"], row["V_upper_end_N"]], rel=1e-6)


@pytest.mark.parametrize(
    "line",
    [
        Catenary(40e3, 70e3, 500.0, 5e9, 200.0),
        Catenary(0.9e6, 0.7e6, 100.0, 1e8, 150.0),
        Catenary(300e3, 15e3, 200.0, 1e9, 147.0),
        Catenary(5e3, 30e3, 120.0, 2e8, 160.0),
        Catenary(50.0, 30e3, 200.0, 89e6, 300.0),
    ],
    ids=["sagging", "stretched", "shallow", "steep", "folded"],
)
def test_forces_lead_back_to_the_closed_form(line: Catenary) -> None:
    """The ends come from chosen forces by the closed form; these come back to 1e-9 of the tension."""
    found = pull(line.reach, length=line.length, axial_stiffness=line.stiffness, weight=line.weight)
    tension = math.hypot(line.horizontal, line.upper)
    assert found == pytest.approx([line.horizontal, line.upper], abs=1e-9 * tension)


def test_an_inextensible_level_catenary() -> None:
    """L = 2 (H/w) sinh(w x/2H); EA of 1e13 N leaves 1e-8 of stretch."""
    horizontal, weight, span = 50e3, 100.0, 200.0
    length = 2 * horizontal / weight * math.sinh(weight * span / (2 * horizontal))
    found = pull((span, 0.0), length=length, axial_stiffness=1e13, weight=weight)
    # The stretch of 1e-8 in L is one of some 1e-8 · 24 (H/w x)² in H: dL/L = −(w x/H)²/12 dH/H.
    assert found == pytest.approx([horizontal, weight * length / 2], rel=1e-5)


def test_a_flat_line_is_a_parabola() -> None:
    """Sag w x²/8H; the parabola leaves out (w x/H)²/48 of it, here 3e-6, and the stretch adds 2e-6."""
    horizontal, weight, span = 200e3, 8.0, 300.0
    length = 2 * horizontal / weight * math.sinh(weight * span / (2 * horizontal))
    flat = held((span, 0.0), length=length, axial_stiffness=1e16, weight=weight)
    points = flat.columns["rope_point"][0]
    middle = points[len(points) // 2]
    assert middle[0] == pytest.approx(span / 2, abs=1e-9)
    assert -middle[2] == pytest.approx(weight * span**2 / (8 * horizontal), rel=1e-5)


def test_a_taut_line_is_a_spring() -> None:
    """T = EA (c/L - 1) along the chord; a weight of a millionth of that moves it by no more."""
    place, stiffness, length = (30.0, 40.0), 1e6, 49.0
    found = pull(place, length=length, axial_stiffness=stiffness, weight=1e-5)
    tension = stiffness * (50.0 / length - 1)
    assert found == pytest.approx([0.6 * tension, 0.8 * tension], rel=1e-6)


def test_a_plumb_line() -> None:
    """Between ends above each other: z = L + (V - w L/2) L/EA, and nothing aside."""
    stiffness, weight, length, height = 5e6, 200.0, 50.0, 50.1
    horizontal, vertical = pull((0.0, height), length=length, axial_stiffness=stiffness, weight=weight)
    assert vertical == pytest.approx(stiffness * (height / length - 1) + weight * length / 2, rel=1e-9)
    assert horizontal == 0.0


def on_bed(horizontal: float, rise: float, length: float, stiffness: float, weight: float) -> Floats:
    """Reach, V and what lies on the bed, of H and the height: Jonkman's equations without friction."""

    def height(vertical: float) -> float:
        ratio = vertical / horizontal
        return horizontal / weight * (math.hypot(1, ratio) - 1) + vertical**2 / (2 * stiffness * weight)

    vertical = brentq(lambda v: height(v) - rise, 0, 1e9, xtol=1e-9, rtol=1e-15)
    lies = length - vertical / weight
    reach = lies + horizontal / weight * math.asinh(vertical / horizontal) + horizontal * length / stiffness
    return np.array([reach, vertical, lies])


@pytest.mark.parametrize("horizontal", [200.0, 20e3, 100e3])
def test_a_line_with_a_part_on_the_sea_bed(horizontal: float) -> None:
    """Forces back from the closed form to 1e-8; drawn, the line leaves the bed where the closed form does."""
    rise, length, stiffness, weight = 20.0, 250.0, 89e6, 70.0
    reach, vertical, lies = on_bed(horizontal, rise, length, stiffness, weight)
    assert 0 < lies < length
    one = held((reach, rise), length=length, axial_stiffness=stiffness, weight=weight, sea_bed=0.0)
    assert one.body("barge", "joint_force")[0, [0, 2]] == pytest.approx([horizontal, vertical], rel=1e-8)
    points = one.columns["rope_point"][0]
    unstretched = np.linspace(length, 0, len(points))
    assert (points[unstretched <= lies, 2] == 0).all()
    assert (points[unstretched > lies, 2] > 0).all()
    assert points[-1] == pytest.approx([0, 0, 0], abs=1e-9)
    assert points[0] == pytest.approx([reach, 0, rise], abs=1e-9)


def test_a_line_that_lies_on_the_sea_bed_all_along() -> None:
    """H = EA (x/L - 1): a millimetre of height lifts 2 m, which that makes 3e-7 m longer: 2e-6 of H."""
    stiffness, length, reach = 89e6, 100.0, 100.2
    horizontal, vertical = pull((reach, 1e-3), length=length, axial_stiffness=stiffness, sea_bed=0.0)
    assert horizontal == pytest.approx(stiffness * (reach / length - 1), rel=3e-6)
    # z = V^2 (1/2wH + 1/2wEA); the corner at the bed is rounded over 0.1 mm, (0.1/2)^2/2 of V at 1 mm.
    plumb = math.sqrt(2 * 80.0 * 1e-3 * horizontal / (1 + horizontal / stiffness))
    assert vertical == pytest.approx(plumb, rel=1.5e-3)


def test_a_slack_line_hangs_down_to_its_heap() -> None:
    """More on the bed than fits: no horizontal force, and the weight of what hangs, z = V/w (1 + V/2EA)."""
    found = pull((30.0, 20.0), length=100.0, sea_bed=0.0)
    vertical = found[1]
    assert found[0] == 0.0
    assert vertical / 80.0 * (1 + vertical / (2 * 89e6)) == pytest.approx(20.0, rel=1e-12)


@pytest.mark.parametrize("bed", [{}, {"sea_bed": 0.0}], ids=["free", "on bed"])
def test_forces_are_slopes_of_the_energy(bed: Json) -> None:
    """-dE/dx and -dE/dz by central differences of 1 mm: their own error is some 1e-9 of the force."""
    place, line = (220.0, 25.0), {"length": 231.0, **bed}
    here = pull(place, **line)

    def energy(along: float, up: float) -> float:
        return float(held((place[0] + along, place[1] + up), **line).energy("elastic")[0])

    step = 1e-3
    slopes = [
        (energy(*(step * np.array(way))) - energy(*(-step * np.array(way)))) / (2 * step)
        for way in ((1, 0), (0, 1))
    ]
    assert slopes == pytest.approx(here, rel=1e-6)


def closed_form(reach: float, rise: float, length: float, stiffness: float, weight: float) -> Floats:
    """H and V by solving Irvine's equations from a guess."""

    def miss(force: Floats) -> Floats:
        line = Catenary(float(force[0]), float(force[1]), length, stiffness, weight)
        return np.array(line.reach) - [reach, rise]

    found: Floats = fsolve(miss, np.array([5e4, 1e4]), xtol=1e-12)
    return found


def test_the_surge_period_of_a_moored_mass() -> None:
    """omega^2 = 2 (dH/dx)/m between two lines; dH/dx by differences of the closed form, 1e-7 of it."""
    reach, rise, length, mass = 250.0, 20.0, 252.0, 12e6
    lines = [
        mooring("ahead", to=[reach, 0, -rise], length=length),
        mooring("astern", to=[-reach, 0, -rise], length=length),
    ]
    barge = body("barge", slider(axis=(1, 0, 0)), mass)
    question = Statics(json.dumps(document([barge], forces=lines)))
    question.settle()
    step = 1e-3
    ahead, behind = (closed_form(reach + way, rise, length, 89e6, 80.0)[0] for way in (step, -step))
    stiffness = 2 * (ahead - behind) / (2 * step)
    assert question.modes(1)["square"][0] == pytest.approx(stiffness / mass, rel=1e-6)


def hauled(distance: float, method: str, **line: Any) -> Run:
    """A mass on two lines, of which the one ahead is hauled in by a winch, or veered, in 30 s."""
    lines = [
        mooring("ahead", to=[200, 0, -20], length=201.3, winch="winch", damping_time=0.1, **line),
        mooring("astern", to=[-200, 0, -20], length=201.3, damping_time=0.1),
    ]
    speed = distance / 25.0
    ramps = [
        {"at": 0.0, "duration": 5.0, "velocity": -speed, "shape": "smooth"},
        {"at": 25.0, "duration": 5.0, "velocity": 0.0, "shape": "smooth"},
    ]
    bodies = [
        body("barge", slider(axis=(1, 0, 0), damping=2e5), 1e6),
        {**flow("winch", 1.0, drive="winch.drive"), "parent": "barge"},
    ]
    system = document(bodies, forces=lines, drives=[{"name": "winch.drive", "ramps": ramps}])
    if method == "del":
        return simulate(system, 60.0, step=5e-3, sample_interval=0.1)
    return adaptive(system, 60.0, sample_interval=0.1)


@pytest.mark.parametrize("method", ["adaptive", "del"])
@pytest.mark.parametrize("distance", [2.0, -2.0], ids=["hauled", "veered"])
def test_energy_balances_while_a_winch_moves_a_line(method: str, distance: float) -> None:
    """What the winch works is in lines, mass and dampers: 1e-6 with error control, 1e-3 of a fixed step."""
    moved = hauled(distance, method)
    assert moved.energy_remainder < (1e-6 if method == "adaptive" else 1e-3)
    assert moved.energy("rope_damping")[-1] > 0
    # Equilibrium in the end: both pull alike, the one ahead shorter by what was hauled, less its strain.
    tensions = [moved.tension(name)[-1] for name in ("ahead", "astern")]
    start = float(closed_form(200.0, 20.0, 201.3, 89e6, 80.0) @ [1, 0])
    strain = math.hypot(*closed_form(200.0, 20.0, 201.3, 89e6, 80.0)) / 89e6
    length = 201.3 - distance / (1 + strain)
    place = moved.body("barge")[-1, 0]
    ahead = closed_form(200.0 - place, 20.0, length, 89e6, 80.0)
    astern = closed_form(200.0 + place, 20.0, 201.3, 89e6, 80.0)
    assert tensions == pytest.approx([math.hypot(*ahead), math.hypot(*astern)], rel=1e-3)
    assert ahead[0] == pytest.approx(astern[0], rel=1e-2)  # the mass still moves a little
    assert (ahead[0] > start) == (distance > 0)


def test_a_rope_of_nodes_hangs_alike() -> None:
    """50 nodes of a heavy rope and the catenary, to 1e-5: the error of the nodes."""
    line = Catenary(40e3, 70e3, 500.0, 5e9, 200.0)
    nodes = run(lift(line.reach, line.length, line.stiffness, line.weight, 50))
    found = pull(line.reach, length=line.length, axial_stiffness=line.stiffness, weight=line.weight)
    assert found == pytest.approx(nodes.upper[-1], rel=1e-5)


def test_a_line_breaks_at_its_breaking_force_and_the_run_goes_on() -> None:
    """Hauled in until it breaks: it never pulls more, what it held is booked, and the other line remains."""
    force = 130e3
    broken = hauled(4.0, "adaptive", breaking_force=force)
    [(time, name)] = broken.events("broken")
    assert name == "ahead"
    assert 0 < time < 30
    # The moment is found to the last bit, what it pulls there to the error of the step's course.
    assert broken.peak("ahead") == pytest.approx(force, rel=1e-6)
    after = broken.time > time
    assert (broken.tension("ahead")[after] == 0).all()
    assert (broken.tension("astern")[after] > 0).all()
    assert broken.energy("parting")[-1] > 0
    assert broken.energy_remainder < 1e-6
    assert broken.time[-1] == 60.0


@pytest.mark.parametrize("method", ["adaptive", "del"])
def test_a_line_is_cut_at_a_time(method: str) -> None:
    """From then on the mass moves as the other line alone pulls it: a = H/m in the first moment."""
    cut = hauled(0.5, method, cut_at=40.0)
    assert cut.events("cut") == [(40.0, "ahead")]
    before, after = (int(np.searchsorted(cut.time, time)) for time in (39.95, 40.15))
    speed = cut.body("barge", "body_velocity")[:, 0]
    rate = (speed[after] - speed[before]) / (cut.time[after] - 40.0)
    place = cut.body("barge")[before, 0]
    alone = closed_form(200.0 + place, 20.0, 201.3, 89e6, 80.0)[0]
    # Within 0.2 s the damper of the slider takes some 2 % of it.
    assert rate == pytest.approx(-alone / 1e6, rel=0.05)


BARGE = """\
format: 1
lift: {title: A barge on its moorings}
duration: 200 s
water: {density: 1025 kg/m^3}
ropes:
  moor_44: {construction: 6x36 IWRC, grade: 1960, diameter: 44 mm, damping_time: 100 ms}
vessels:
  barge:
    draft: 4 m
    hull: {box: [100 m, 30 m, 8 m]}
    masses: {hull: {mass: 12300 t, at: [50 m, 0 m, 5 m]}}
    radii_of_gyration: [10 m, 28 m, 29 m]
    water_damping: {surge: 500 kN s/m, sway: 500 kN s/m, yaw: 500 MN m s}
mooring_lines:
  bow.ps: {vessel: barge, fairlead: [100 m, 12 m, 8 m], to: [250 m, 150 m, -15 m], rope: moor_44,
           pretension: 150 kN, sea_bed: -15 m, winch: {speed: 5 m/min, acceleration: 0.01 m/s^2}}
  bow.sb: {vessel: barge, fairlead: [100 m, -12 m, 8 m], to: [250 m, -150 m, -15 m], rope: moor_44,
           pretension: 150 kN, sea_bed: -15 m, winch: {speed: 5 m/min, acceleration: 0.01 m/s^2}}
  stern: {vessel: barge, fairlead: [0 m, 0 m, 8 m], to: [-60 m, 0 m, 4 m], type: spring, rope: moor_44,
          pretension: 400 kN, winch: {speed: 5 m/min, acceleration: 0.01 m/s^2}}
fenders:
  f1: {vessel: barge, at: [0 m, 10 m, 6 m], wall: [-0.4 m, 0 m], facing: 0 deg, thickness: 0.4 m,
       stiffness: 5 MN/m, damping: 1 MN s/m, capacity: 500 kN}
  f2: {vessel: barge, at: [0 m, -10 m, 6 m], wall: [-0.4 m, 0 m], facing: 0 deg, thickness: 0.4 m,
       stiffness: 5 MN/m, damping: 1 MN s/m}
"""


def test_pretension_is_what_a_line_pulls_where_its_vessel_is_given() -> None:
    """At the start as given, and the weight of a line on the sea bed is that under water."""
    recording = Simulation(parse_scenario(BARGE + "start: as_given\n")).run()
    first = [float(recording.column("mooring_tension", line)[0]) for line in ("bow.ps", "bow.sb", "stern")]
    assert first == pytest.approx([150e3, 150e3, 400e3], rel=1e-9)
    reach, rise = math.hypot(150, 138), 23.0 - 4.0
    weight = 0.409 * 44**2 / 100 * 9.81 * (1 - 1025 / 7850)
    stiffness = 89.1e6
    document = assemble(parse_scenario(BARGE)).document
    [line] = [one for one in document["forces"] if one["name"] == "mooring.bow.ps"]
    assert line["weight"] == pytest.approx(weight, rel=1e-3)
    assert line["axial_stiffness"] == pytest.approx(stiffness, rel=1e-2)
    points = recording["rope_point"].values[0]
    own = points[recording["rope_of_point"].values == "mooring.bow.ps"]
    assert own[0] == pytest.approx([100, 12, 4], abs=1e-9)
    assert np.hypot(*(own[0] - own[-1])[:2]) == pytest.approx(reach)
    assert own[0, 2] - own[-1, 2] == pytest.approx(rise)


def test_fenders_bear_what_the_lines_press_them_with() -> None:
    """At rest each is pressed by F/k, and both together bear what the lines pull astern."""
    recording = Simulation(parse_scenario(BARGE + "start: rest\n")).run()
    forces = recording["fender_force"].values[0]
    centre = recording.column("body_position", "barge")[0]
    turn = axes(recording.column("body_orientation", "barge")[:1])[0]
    pressed = [-(centre + turn @ (np.array([0, y, 6]) - [50, 0, 5]))[0] for y in (10, -10)]
    assert forces == pytest.approx(5e6 * np.array(pressed), rel=1e-9)
    points, names = recording["rope_point"].values[0], recording["rope_of_point"].values
    astern = 0.0
    for line in ("bow.ps", "bow.sb", "stern"):
        own = points[names == f"mooring.{line}"]
        way = own[1] - own[0]
        # The first of 40 chords of a catenary leads a little below its tangent: 1e-3 of the pull along x.
        astern -= float(recording.column("mooring_tension", line)[0]) * way[0] / np.linalg.norm(way)
    assert forces.sum() == pytest.approx(astern, rel=5e-3)
    metrics = recording.metrics()
    assert metrics["peak_fender_force_of_capacity"] == pytest.approx(metrics["peak_fender_force.f1"] / 500e3)
    checks = {check.name: check for check in check_recording(recording)}
    assert checks["fender_force_of_capacity"].value == pytest.approx(forces[0] / 500e3, rel=1e-3)
    strength = 0.356 * 44**2 * 1960 / 1000 * 1e3
    used = metrics["peak_mooring_tension_of_breaking_force"]
    assert used == pytest.approx(metrics["peak_mooring_tension.stern"] / strength, rel=1e-3)


PLAN = """\
start: rest
plan:
  - {step: haul, haul: stern, speed: 3 m/min, until: {mooring_tension: {line: stern, above: 500 kN}}}
  - {step: veer, veer: [bow.ps, bow.sb], speed: 3 m/min, by: 1 m}
  - {step: hold, hold: until_end}
"""


def test_winches_haul_and_veer_as_the_plan_says() -> None:
    """Hauls until the tension is there, then veers 1 m; the balance closes and both stop."""
    recording = Simulation(parse_scenario(BARGE + PLAN)).run()
    [(begun, _), *_] = [(time, name) for time, _, name in recording.events("step_begin") if name == "veer"]
    at = int(np.searchsorted(recording.time, begun))
    assert float(recording.column("mooring_tension", "stern")[at]) >= 0.99 * 500e3
    paid = {line: recording.column("joint_position", f"mooring.{line}.winch") for line in ("stern", "bow.ps")}
    assert paid["stern"][-1] < 0
    assert paid["bow.ps"][-1] == pytest.approx(1.0, abs=1e-9)
    assert recording.metrics()["energy_remainder"] < 1e-5
