"""`--plumb` of one trolley of two that the plan moves `to` a place.

Where it starts acts on nothing then, but the derivatives took it to: the answer moved it by 800 mm for
nothing, beside the 800 mm of the other, in 24 steps that went half of the way each. With both moved so it
ended in "no change betters it any more".
"""

from __future__ import annotations

import pytest

from gantline.scenario import Scenario, parse_scenario
from gantline.study import CannotBeError, plumb_hooks
from trolley_pair import TROLLEYS

#: What hangs from the start.
HUNG = """\
load:
  name: load
  shape: {box: [24 m, 8 m, 4 m]}
  position: [0.5 m, 0.2 m, 0.2 m]
  weight: {calculated: 120 t}
  centre_of_gravity: {at: [0 m, 0 m, 2 m]}
  lugs:
    A1: {at: [-9 m, 2 m, 4 m]}
    A2: {at: [-9 m, -2 m, 4 m]}
    B1: {at: [8 m, 2 m, 4 m]}
    B2: {at: [8 m, -2 m, 4 m]}
sling_defaults: {rope: sling}
slings:
  A1: {from: gol.A, to: load.A1, length: 9.6 m}
  A2: {from: gol.A, to: load.A2, length: 9.6 m}
  B1: {from: gol.B, to: load.B1, length: 9.6 m}
  B2: {from: gol.B, to: load.B2, length: 9.6 m}
plan:
  - {step: go, traverse: gol.one, speed: 20 m/min, to: -9 m}
"""
BOTH = "  - {step: on, traverse: gol.two, speed: 20 m/min, to: 8.1 m, starts: with_previous}\n"
ONE, TWO = (f"cranes.gol.trolleys.{name}.position" for name in ("one", "two"))


def lift(more: str = "  - {step: rest, hold: until_end}\n") -> Scenario:
    return parse_scenario(TROLLEYS + HUNG + more)


def test_the_other_trolley_moves_alone() -> None:
    """It comes to 17 m from where the first ends, as far as their lugs are apart."""
    answer = plumb_hooks(lift())
    assert ONE not in answer.values
    assert answer.values[TWO] == pytest.approx(-9.0 + 17.0, abs=5e-3)
    assert answer.steps <= 3
    assert abs(answer.side_pulls["gol.B"][1]).max() < 1.0


def test_while_it_is_under_way_its_start_counts() -> None:
    assert ONE in plumb_hooks(lift(), time=1.0).values


def test_where_both_go_so_they_are_named() -> None:
    with pytest.raises(CannotBeError, match=r"'gol\.one' and 'gol\.two' are where the plan says, wherever"):
        plumb_hooks(lift(BOTH))
