"""Strand jacks from the guide alone, by the words that come to mind, and how they were answered.

`hoist: j1` and `haul: j1` of a drum said "'j1' is not a hook; there is none", `to: 480 mm` of a stroke listed
twelve keys, and so did `strand_jacks` under `mechanics`, `working_load_limit` of a drum, `pin_diameter` of a
sling. A jack of 3000 t on a bundle that breaks at 540 t, a digit too many, was in order.
"""

from __future__ import annotations

import pytest

from gantline.assembly import assemble
from gantline.scenario import ScenarioError, parse_scenario

JACKS = """\
format: 1
lift: {title: A section in two strand jacks}
duration: 100 s
ground: {level: 0 m, friction: 0.4}
ropes:
  bundle: {axial_stiffness: 556 MN, minimum_breaking_force: 5301 kN, mass: 22.4 kg/m, damping_time: 20 ms}
load:
  name: section
  shape: {box: [40 m, 12 m, 4 m]}
  weight: {calculated: 400 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  stands_on: ground
mechanics:
  drums:
    j1: {diameter: 1 m, rotating_mass: 1 t, rated_capacity: 300 t,
      drive: {speed: 1 m/min, acceleration: 5 mm/s^2}}
    j2: {diameter: 1 m, rotating_mass: 1 t, rated_capacity: 301 t,
      drive: {speed: 1 m/min, acceleration: 5 mm/s^2}}
  ropes:
    b1: {rope: bundle, length: as_routed, route: [{type: end, body: world, at: [-18 m, 0 m, 40 m], drum: j1},
      {type: end, body: section, at: [-18 m, 0 m, 2 m]}]}
    b2: {rope: bundle, length: as_routed, route: [{type: end, body: world, at: [18 m, 0 m, 40 m], drum: j2},
      {type: end, body: section, at: [18 m, 0 m, 2 m]}]}
plan:
  - {step: stroke, haul_in: [j1, j2], speed: 0.33 m/min, by: 480 mm}
"""


def said(old: str, new: str) -> str:
    """What is said first of the lift with a piece replaced, without file and line."""
    with pytest.raises(ScenarioError) as error:
        parse_scenario(JACKS.replace(old, new, 1))
    return error.value.problems[0].message


@pytest.mark.parametrize("verb", ["hoist", "haul"])
def test_a_drum_is_no_hook(verb: str) -> None:
    told = "'j1' is a drum of 'mechanics'; 'haul_in' winds its rope up, and 'pay_out' lets it out"
    assert said("haul_in", verb).endswith(told)


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("by: 480 mm", "to: 480 mm", "a drum has no place to go to; 'by' says how much rope it takes up"),
        ("  drums:", "  strand_jacks:", "'strand_jacks' is not a key of mechanics; did you mean 'drums'?"),
        (
            "mechanics:",
            "jacks: 4\nmechanics:",
            "not a key of a lift file: they are 'drums' under 'mechanics'",
        ),
        ("rated_capacity: 300 t", "working_load_limit: 300 t", "did you mean 'rated_capacity'?"),
    ],
)
def test_words_of_jacks(old: str, new: str, told: str) -> None:
    assert told in said(old, new)


@pytest.mark.parametrize(
    ("rated", "is_told"), [("300 t", False), ("360 t", False), ("361 t", True), ("3000 t", True)]
)
def test_a_jack_rated_for_what_its_bundle_breaks_at(rated: str, is_told: bool) -> None:
    """5301 kN are 540.4 t, and 1.5 times less 360.2 t."""
    doubts = assemble(parse_scenario(JACKS.replace("300 t", rated, 1))).doubts
    told = [one.sentence for one in doubts if one.sentence.startswith("j1 may carry ")]
    assert len(told) == is_told
    assert all(", and bundle, the rope on it, breaks at 540.4 t; " in one for one in told)
