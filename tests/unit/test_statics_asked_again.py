"""A lift that is followed from rest to rest goes on from the nearest place that it has come by.

What was asked before makes no difference to any answer, to the last bit.
"""

from __future__ import annotations

import contextlib

import numpy as np
import pytest

from gantline.scenario import load_scenario, parse_scenario
from gantline.statics import Equilibrium, Losses, NoEquilibriumError, Statics

#: Within parts of 5 s and of what waits, at their ends, twice the same, back again, to the end of the lift.
TIMES = (0.0, 7.0, 7.0, 23.4, 60.0, 60.1, 33.3, 60.0, None, None)

KEEL = (
    "supports: {keel: {under: block, grid: {x: [-3 m, 3 m], y: [-2 m, 2 m]}, "
    "height: 1 m, stiffness: 1000 MN/m}}"
)


def assert_same(one: Equilibrium, other: Equilibrium) -> None:
    assert (one.time, one.residual, one.neutral, one.unstable, one.slides) == (
        other.time,
        other.residual,
        other.neutral,
        other.unstable,
        other.slides,
    )
    assert one.recording.variables.keys() == other.recording.variables.keys()
    for name, variable in one.recording.variables.items():
        np.testing.assert_array_equal(variable.values, other.recording.variables[name].values, name)


@pytest.mark.parametrize("losses", ["none", "forward", "held"])
def test_what_was_asked_before_makes_no_difference(losses: Losses) -> None:
    asked_before = Statics("reeved_hoist")
    for time in TIMES:
        alone = Statics("reeved_hoist").equilibrium(time, losses=losses)
        assert_same(asked_before.equilibrium(time, losses=losses), alone)


def test_neither_do_other_losses_and_what_was_looked_at_since() -> None:
    question = Statics("reeved_hoist")
    alone = question.equilibrium(60.0)
    question.equilibrium(losses="backward")
    question.modes(3)
    assert_same(question.equilibrium(60.0), alone)
    with contextlib.suppress(NoEquilibriumError):
        question.lose(question.rig.loads[0].name)
    assert_same(question.equilibrium(60.0), alone)


def test_nor_does_another_start() -> None:
    question, other = Statics("reeved_hoist"), Statics("reeved_hoist")
    alone = question.equilibrium(20.0)
    aside = [0.01] * 24  # one for each degree of freedom
    assert_same(question.equilibrium(20.0, increment=aside), other.equilibrium(20.0, increment=aside))
    assert_same(question.equilibrium(20.0), alone)


@pytest.mark.parametrize("lift", ["reeved_hoist", "equalizer"])
def test_where_steps_begin_and_end_is_found_on_the_same_way(lift: str) -> None:
    """Times of steps are those of the whole way, and the whole way is that without having asked for them.

    The plan of `equalizer` waits for nothing, and says its times by itself.
    """
    whole = Statics(lift)
    alone = whole.equilibrium()
    steps = [step.step for step in whole.scenario.plan]
    found = [whole.times_of(step) for step in steps]
    assert found[0][0] == 0.0 and found[0][1] is not None
    question = Statics(lift)
    for step, (begin, end) in zip(reversed(steps), reversed(found), strict=True):
        assert Statics(lift).when(step, "begins") == begin
        assert (question.when(step, "begins"), question.when(step, "ends")) == (begin, end)
    assert_same(question.equilibrium(), alone)


def test_a_step_ends_whatever_becomes_of_the_lift_after_it() -> None:
    """Slings are cut at 140 s over no ground, where the support has been taken away: the load falls."""
    text = load_scenario("reeved_hoist").text
    changes = {
        "ground: {level: 0 m, friction: 0.4}": KEEL,
        "stands_on: ground": "stands_on: keel",
        "position: [0 m, 0 m, 0 m]": "position: [0 m, 0 m, 1 m]",
        "16.75 m": "17.75 m",
    }
    for old, new in changes.items():
        assert text.count(old) == 1
        text = text.replace(old, new)
    ends = Statics(parse_scenario(text)).when("look round", "ends")
    assert ends is not None
    assert 90.0 < ends < 120.0
    falling = text.replace("rope: sling}", "rope: sling, cut_at: 140 s}")
    falls = Statics(parse_scenario(falling.replace("height: 1 m", "height: 1 m, removed_at: 120 s")))
    with pytest.raises(NoEquilibriumError, match="it falls without end"):
        falls.equilibrium()
    assert falls.when("look round", "ends") == ends
    # Nothing was asked for that modes could be of: they are of the end of the lift, where there is no rest.
    with pytest.raises(NoEquilibriumError):
        falls.modes()
