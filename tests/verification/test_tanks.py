"""Slack tanks against closed forms: moments of their contents, stability, and lifts with vessels that have
tanks.
"""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

import gantline
from floating import SEA, box_hull, buoyancy, pitch_and_roll
from gantline._core import Statics
from lift_text import spoiled
from mechanics import G, Json, adaptive, body, document, free

LENGTH, BREADTH, DEPTH, DRAFT, KG = 100.0, 30.0, 8.0, 4.0, 5.0
TANK = (20.0, 24.0, 6.0)  # length, breadth, depth
FILLED = 2.0
LIQUID = SEA * TANK[0] * TANK[1] * FILLED


def tank(volume: float = LIQUID / SEA, name: str = "tank") -> Json:
    """A tank in the barge's middle, its bottom on the keel."""
    vertices, triangles = box_hull(TANK)
    found: Json = {"type": "tank", "name": name, "body": "barge", "density": SEA, "volume": volume}
    return {**found, "vertices": vertices, "triangles": triangles}


def barge(*, heel: float = 0.0) -> Json:
    """12 300 t with the liquid frozen in them; inertia about the common centre of gravity."""
    mass = SEA * LENGTH * BREADTH * DRAFT
    turned = [math.cos(heel / 2), math.sin(heel / 2), 0, 0]
    return body(
        "barge",
        free([0, 0, -DRAFT], orientation=turned),
        mass,
        centre_of_gravity=(0, 0, KG),
        inertia=(mass * 11.0**2, mass * 27.0**2, mass * 27.0**2),
    )


def water() -> Json:
    return buoyancy("barge", box_hull((LENGTH, BREADTH, DEPTH)))


def test_natural_roll_and_pitch_feel_the_free_surface() -> None:
    """ω² = g (m GM − ρ i)/I: free-surface correction ρ i/m, i = l b³/12 for roll and b l³/12 for pitch."""
    question = Statics(json.dumps(document([barge()], forces=[water(), tank()])))
    question.settle()
    mass = SEA * LENGTH * BREADTH * DRAFT
    wanted = [SEA * G * LENGTH * BREADTH / mass]
    for size, surface, radius in (
        (BREADTH, TANK[0] * TANK[1] ** 3 / 12, 11.0),
        (LENGTH, TANK[1] * TANK[0] ** 3 / 12, 27.0),
    ):
        gm = DRAFT / 2 + size**2 / (12 * DRAFT) - KG - SEA * surface / mass
        wanted.append(G * gm / radius**2)
    assert np.sort(question.modes()["square"])[3:] == pytest.approx(sorted(wanted), rel=1e-9)


@pytest.mark.parametrize("fill", [0.0, TANK[2]])
def test_tanks_that_are_empty_or_full_move_nothing(fill: float) -> None:
    """Without a free surface the contents are as good as frozen: the same modes as without the tank."""
    plain = Statics(json.dumps(document([barge()], forces=[water()])))
    pressed = tank(TANK[0] * TANK[1] * fill)
    with_tank = Statics(json.dumps(document([barge()], forces=[water(), pressed])))
    found = []
    for question in (plain, with_tank):
        question.settle()
        found.append(np.sort(question.modes()["square"])[3:])
    assert found[1] == pytest.approx(found[0], rel=1e-9)


def test_contents_shift_as_a_box_says() -> None:
    """A barge with GM < 0 by its slack tank lolls. With t = tan φ both water and liquid follow the wall-
    sided formula, (BM − ρ i/m)(1 + t²/2) + KB − KG = 0, as long as bottoms and tops of tank and hull are
    not met.
    """
    mass = SEA * LENGTH * BREADTH * DRAFT
    bm = BREADTH**2 / (12 * DRAFT) - SEA * TANK[0] * TANK[1] ** 3 / 12 / mass
    tangent = math.tan(math.radians(5))
    kg = DRAFT / 2 + bm * (1 + tangent**2 / 2)
    heavy = {**barge(heel=0.02), "centre_of_gravity": [0, 0, kg]}
    question = Statics(json.dumps(document([heavy], forces=[water(), tank()])))
    assert question.settle()["unstable"] == 0
    _, side = pitch_and_roll(question.columns()["body_orientation"][0, 0])
    assert math.tan(side) == pytest.approx(tangent, rel=1e-6)


def test_energy_with_liquid_about_balances() -> None:
    """A barge rolls by ten degrees and more with a slack tank: kinetic, gravity and fluid energy are kept."""
    start = {**barge(heel=math.radians(12))}
    run = adaptive(document([start], forces=[water(), tank()]), 60.0, sample_interval=0.1)
    stored = run.energy("kinetic") + run.energy("gravity") + run.energy("fluid")
    # What the method takes by its own account aside, 1e-6 of the motion.
    assert np.ptp(stored + run.energy("method")) < 1e-6 * run.energy("kinetic").max()
    assert run.energy_remainder < 1e-6


LIFT = """\
format: 1
lift: {title: A barge lists over its starboard tank}
duration: 10 s
start: rest
water: {density: 1.025 t/m^3, level: 2 m}
mechanics:
  bodies:
    barge:
      joint: {type: free, position: [0 m, 0 m, 3 m]}
      mass: 12000 t
      inertia: {xx: 1.2e6 t m^2, yy: 1.0e7 t m^2, zz: 1.0e7 t m^2}
      hull: {box: [100 m, 30 m, 8 m], keel: [0 m, 0 m, -5 m]}
      added_mass: {heave: 15000 t, roll: 600000 t m^2, pitch: 9.0e6 t m^2}
      water_damping: {heave: 4 MN s/m, roll: 100 MN m s, pitch: 2000 MN m s}
      tanks:
        starboard: {box: [20 m, 10 m, 6 m], bottom: [0 m, -8 m, -5 m], content: 300 t}
"""


def test_a_lift_file_with_a_barge(tmp_path: Path) -> None:
    """Displacement 12 300 t, T = 4 m; the list follows from G and the wall-sided formula with the tank's
    own surface: t (GM + BM' t²/2) = y_G, BM' = BM − ρ i/m, while it rests.
    """
    path = tmp_path / "lift.yaml"
    path.write_text(LIFT, encoding="utf-8")
    recording = gantline.simulate(path)
    mass, fill = 12.3e6, 300e3 / SEA / 200
    bm = BREADTH**2 / (12 * DRAFT) - SEA * 20 * 10**3 / 12 / mass
    centre = (12e6 * 5 + 300e3 * fill / 2) / mass
    gm, lever = DRAFT / 2 + bm - centre, 300e3 * 8 / mass
    (tangent,) = (
        root.real for root in np.roots([bm / 2, 0, gm, -lever]) if abs(root.imag) < 1e-9 and root.real > 0
    )
    heel = pitch_and_roll(recording["body_orientation"].values[:, 0])[1]
    assert np.tan(heel[0]) == pytest.approx(tangent, rel=1e-7)
    assert np.ptp(heel) < 1e-7, "it starts at rest and stays there"
    assert recording.coordinates["energy_kind"][3] == "fluid"


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("content: 300 t", "content: 3000 t", "3000 t do not go into it; it holds 1230 t"),
        ("level: 2 m", "level: 2", "'2' has no unit"),
        ("density: 1.025 t/m^3, level", "density: 0 t/m^3, level", "density"),
        ("roll: 600000 t m^2", "roll: -1 t m^2", "added inertia must be zero or more"),
        ("duration: 10 s", "duration: 10 s\nsimulation: {gravity: 0 m/s^2}", "water needs gravity"),
    ],
)
def test_mistakes_about_water_have_a_line(old: str, new: str, sentence: str, tmp_path: Path) -> None:
    """One message with the line for each."""
    path = tmp_path / "lift.yaml"
    path.write_text(spoiled(old, new, LIFT), encoding="utf-8")
    with pytest.raises(gantline.ScenarioError) as raised:
        gantline.load_scenario(path)
    assert sentence in str(raised.value)
    assert "lift.yaml:" in str(raised.value)
