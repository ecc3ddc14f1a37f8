"""A tugger of constant pull that statics took for a brake.

A motor that pulls all it can was held where it had been dragged to as soon as an equilibrium was looked for
once more at the same time: where drums had wound rope under another tension, or where friction held on the
way and no longer in the end. Its line then had the right pull and the stiffness of one that is made fast, so
that modes, sensitivities and matrices were those of another lift.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.statics import NoEquilibriumError, Statics

#: Pull of the tugger [N].
PULL = 3e3

LIFT = """
format: 1
lift: {title: A load on a hook and a tugger}
duration: 300 s
ground: {level: 0 m, friction: 0.3}
ropes:
  sling: {axial_stiffness: 100 MN, damping_time: 10 ms, mass: none}
  hoist: {axial_stiffness: 60 MN, damping_time: 10 ms, mass: none, diameter: 42 mm}
  tag: {axial_stiffness: 1 MN, damping_time: 50 ms, mass: none}
load:
  name: load
  shape: {box: [10 m, 4 m, 4 m]}
  position: [0 m, 0 m, 0 m]
  weight: {calculated: 40 t, contingency: 1.0}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  stands_on: ground
  lugs:
    A: {at: [3 m, 1.5 m, 4 m]}
    B: {at: [3 m, -1.5 m, 4 m]}
    C: {at: [-3 m, 1.5 m, 4 m]}
    D: {at: [-3 m, -1.5 m, 4 m]}
cranes:
  hook:
    type: fixed_hook
    at: [0 m, 0 m, 11.9 m]
    block: {mass: 2 t, height: 2 m}
    reeving: {ropes: 1, parts_each: 4, rope: hoist, sheave_diameter: 0.8 m, upper_sheaves_at: 40 m}
    drum: {diameter: 1 m}
    hoist: {speed: 10 m/min, acceleration: 0.05 m/s^2}
sling_defaults: {rope: sling, length: 8.8 m}
slings:
  A: {from: hook, to: load.A}
  B: {from: hook, to: load.B}
  C: {from: hook, to: load.C}
  D: {from: hook, to: load.D}
tag_lines:
  line: {at: [5 m, 0 m, 2 m], to: [60 m, 0 m, 6 m], rope: tag, pull: 3 kN}
plan:
  - {step: hoist, hoist: hook, speed: 5 m/min, by: 5 m}
  - {step: hold, hold: until_end}
"""


@pytest.mark.parametrize(
    "changes",
    [{}, {"ground.friction": "0"}],
    ids=["friction on the way", "without friction"],
)
def test_a_tugger_gives_at_rest(changes: dict[str, str]) -> None:
    """T = P, no brake that holds in the linear model, and no tension of the line that anything changes."""
    statics = Statics(parse_scenario(LIFT).changed(changes))
    rest = statics.equilibrium()
    # What drums hold is followed to 1e-9 of it.
    assert rest.tension("tag.line") == pytest.approx(PULL, rel=1e-8)
    assert statics.linear_model().held.size == 0
    asked = [("centre_x", "load"), ("centre_y", "load"), ("mass", "load"), ("length", "sling.A")]
    for found in statics.sensitivities(asked):
        assert abs(found.of("tag.line")) < 1e-6 * np.abs(found.tension).max(), found


def test_it_is_no_stiffer_than_its_direction() -> None:
    """Modes slower than those of a tugger on its rope are the same with a rope a hundred times as stiff."""
    squares = []
    for stiffness in ("1 MN", "100 MN"):
        statics = Statics(
            parse_scenario(LIFT).changed({"ground.friction": "0", "ropes.tag.axial_stiffness": stiffness})
        )
        statics.equilibrium()
        squares.append([mode.square for mode in statics.modes(4)])
    # 20 kg on 55 m of 1 MN swing at ω² = 909 1/s²: of slower motions they take some 20 kg/40 t.
    assert squares[0] == pytest.approx(squares[1], rel=1e-4)


@pytest.mark.parametrize("time", [20.0, 60.0])
def test_friction_that_is_found_in_many_rounds_is_no_contradiction(time: float) -> None:
    """A line askew drags the load as its friction goes: what holds was set anew more than 40 times.

    Moves of multipliers were counted over all of that: "lengths that cannot change contradict one another".
    """
    askew = LIFT.replace("to: [60 m, 0 m, 6 m]", "to: [60 m, 15 m, 6 m]")
    rest = Statics(parse_scenario(askew)).equilibrium(time, losses="held")
    assert rest.tension("tag.line") == pytest.approx(PULL, rel=1e-8)


#: A weight between two ropes of 2 m whose other ends are 4 m apart, and 4.9 m once the upper one has gone up.
BETWEEN = """
format: 1
lift: {title: Two inextensible ropes}
duration: 1 s
start: as_given
ropes:
  rod: {inextensible: true, mass: none}
mechanics:
  bodies:
    weight: {joint: {type: slider, axis: [0, 0, 1]}, mass: 1 t}
    top:
      at: [0 m, 0 m, 2 m]
      joint: {type: slider, axis: [0, 0, 1], motion: [{at: 0 s, duration: 0.2 s, velocity: 1 m/s}]}
  ropes:
    above: {rope: rod, length: 2 m, route: [{type: end, body: top}, {type: end, body: weight}]}
    below:
      rope: rod
      length: 2 m
      route: [{type: end, body: weight}, {type: end, body: world, at: [0 m, 0 m, -2 m]}]
"""


def test_lengths_that_contradict_are_still_told() -> None:
    with pytest.raises(NoEquilibriumError, match="lengths that cannot change contradict one another"):
        Statics(parse_scenario(BETWEEN)).equilibrium(1.0)
