"""GM of a vessel with a load on its deck, which slid while the vessel was inclined.

Equilibria are found without friction, and the inclining that tells GM was done on them: however rough a deck,
the load on it slid downhill as far as tag lines and slings let it, and took w^2/(k D g) of GM. The cargo
barge of `off_a_barge`, with 120 t on its grillage, had 17.2 m, a hull with an engine of 120 t set down in
it and its slings not yet off 9.9 m in place of 22.5 m; a limit `metacentric_height` failed by that. With
friction held, where fenders stick to the neighbour too, the barge had 33.9 m. By hand it is 23.3 m.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gantline
from gantline.scenario import load_scenario
from gantline.statics import Statics
from gantline.statics.answers import Losses
from gantline.statics.inclining import metacentric_heights

SCENARIO = Path(__file__).parents[2] / "scenarios" / "off_a_barge" / "scenario.yaml"
#: Sides of the pontoon's hull [m]; its mass and that of the module [t], and their heights over the keel [m].
LENGTH, BREADTH, DEPTH = 60.0, 24.0, 4.5
PONTOON, CENTRE, MODULE, STANDS = 2820.0, 1.5, 120.0, DEPTH + 2.5
LIFT = f"""\
format: 1
lift: {{title: A module on a pontoon}}
duration: 10 s
water: {{density: 1025 kg/m^3, level: 0 m}}
ropes:
  sling: {{axial_stiffness: 50 MN, damping_time: 20 ms, mass: none}}
  tag: {{axial_stiffness: 100 kN, damping_time: 0.2 s, mass: none}}
load:
  name: module
  shape: {{box: [8 m, 8 m, 6 m]}}
  position: [30 m, 0 m, {DEPTH - 1.992} m]
  weight: {{calculated: {MODULE} t}}
  centre_of_gravity: {{at: [0 m, 0 m, 2.5 m]}}
  lugs: {{top: {{at: [0 m, 0 m, 6 m]}}}}
vessels:
  pontoon:
    position: [0 m, 0 m]
    draft: 1.992 m
    hull: {{box: [{LENGTH} m, {BREADTH} m, {DEPTH} m]}}
    masses: {{all: {{mass: {PONTOON} t, at: [{LENGTH / 2} m, 0 m, {CENTRE} m]}}}}
    radii_of_gyration: [8 m, 17 m, 18 m]
cranes:
  hook: {{type: fixed_hook, at: [30 m, 0 m, 20 m], hoist: {{speed: 6 m/min, acceleration: 0.05 m/s^2}}}}
slings: {{s: {{from: hook, to: module.top, length: 14 m, rope: sling}}}}
tag_lines:
  ps: {{at: [0 m, 4 m, 1 m], to: [30 m, 11 m, {DEPTH} m], held_by: pontoon, rope: tag, pretension: 3 kN}}
  sb: {{at: [0 m, -4 m, 1 m], to: [30 m, -11 m, {DEPTH} m], held_by: pontoon, rope: tag, pretension: 3 kN}}
mechanics:
  body_contacts:
    on_deck: {{between: [module, pontoon], stiffness: 1000 MN/m, damping: 10 MN s/m, friction: 0.3}}
plan:
  - {{step: look, hold: until_end}}
"""


def by_hand() -> float:
    """KB + BM - KG of the pontoon with what stands on it."""
    draft = (PONTOON + MODULE) / (1.025 * LENGTH * BREADTH)
    centre = (PONTOON * CENTRE + MODULE * STANDS) / (PONTOON + MODULE)
    return draft / 2 + BREADTH**2 / 12 / draft - centre


@pytest.mark.parametrize("losses", ["none", "held"])
def test_a_load_on_deck_is_part_of_the_vessel(losses: Losses) -> None:
    """To 1e-3: the module rocks on its contacts by w h/(k r^2), 3 MN m over 1 GN/m x (4 m)^2 x 4, 5e-5."""
    question = Statics(gantline.parse_scenario(LIFT))
    rest = question.equilibrium(0.0, losses=losses)
    assert metacentric_heights(question, rest)["pontoon"].transverse == pytest.approx(by_hand(), rel=1e-3)


def test_fenders_do_not_count_where_friction_is_held() -> None:
    """Both give the barge the same GM, to 2 % for where lines and fenders have it then."""
    question = Statics(load_scenario(SCENARIO))
    heights = [
        metacentric_heights(question, question.equilibrium(0.0, losses=losses))["cargo"].transverse
        for losses in ("none", "held")
    ]
    assert heights[0] == pytest.approx(heights[1], rel=0.02)


def test_other_sensitivities_are_of_the_equilibrium() -> None:
    """What is asked without `standing` has friction as the equilibrium has it: the module slides."""
    question = Statics(gantline.parse_scenario(LIFT))
    question.equilibrium(0.0)
    slides, stands = (
        question.sensitivities([("centre_y", "pontoon")], standing=standing)[0].of_body("module")
        for standing in (False, True)
    )
    assert abs(slides[1]) > 5.0 * abs(stands[1])  # 1.98 and 0.22 m for each metre
