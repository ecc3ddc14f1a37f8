"""A tugger of constant pull that statics took for a brake.

A motor that pulls all it can was held where it had been dragged to as soon as an equilibrium was looked for
once more at the same time: where drums had wound rope under another tension, or where friction held on the
way and no longer in the end. Its line then had the right pull and the stiffness of one that is made fast, so
that modes, sensitivities and matrices were those of another lift.

A tugger also hauled in at its speed, from one part of the plan that was followed to the next: after a load
had slid, or the line of a run gone slack, it pulled less than it shall, or nothing, in what was called rest.
Friction then had to hold what nobody pulled at: of 150 such questions about a load that is dragged as it
comes off the ground 30 had no answer, and all but two of these have theirs since.
"""

from __future__ import annotations

import numpy as np
import pytest

from gantline.scenario import parse_scenario
from gantline.statics import Losses, NoEquilibriumError, Statics
from tugged_load import LIFT, PULL


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


@pytest.mark.parametrize("across", [-40, 15, 30, 60])
@pytest.mark.parametrize("losses", ["none", "held"])
def test_its_line_pulls_as_it_shall_at_any_time(across: int, losses: Losses) -> None:
    """T = P from the start on: standing, while the load comes clear, when it has slid, and hanging."""
    askew = LIFT.replace("to: [60 m, 0 m, 6 m]", f"to: [60 m, {across} m, 6 m]")
    statics = Statics(parse_scenario(askew))
    for time in (0.0, 0.2, 4.4, 4.5, 6.0, 20.0):
        rest = statics.equilibrium(time, losses=losses)
        assert rest.tension("tag.line") == pytest.approx(PULL, rel=1e-8), time


def test_a_tugger_whose_line_is_cut_holds_nothing() -> None:
    """It would haul without end, and the load hangs plumb: four slings, each a quarter of 40 t at 8.8 m."""
    cut = LIFT.replace("by: 5 m}", "by: 5 m, cut: [tag.line]}")
    rest = Statics(parse_scenario(cut)).equilibrium(250.0)
    plumb = 40e3 * 9.81 / 4 * 8.8 / np.sqrt(8.8**2 - 3.0**2 - 1.5**2)
    assert rest.tension("tag.line") == 0.0
    for sling in "ABCD":
        # Slings stretch by 1e-3 and are the steeper for it: 1.5e-4 of their force.
        assert rest.tension(f"sling.{sling}") == pytest.approx(plumb, rel=3e-4)


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
