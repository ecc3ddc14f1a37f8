"""A lift that is followed from rest to rest goes on from where it was followed to last.

What was asked before makes no difference to any answer, to the last bit.
"""

from __future__ import annotations

import contextlib

import numpy as np
import pytest

from gantline.statics import Equilibrium, Losses, NoEquilibriumError, Statics

#: Within parts of 5 s and of what waits, at their ends, twice the same, back again, to the end of the lift.
TIMES = (0.0, 7.0, 7.0, 23.4, 60.0, 60.1, 33.3, 60.0, None, None)


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
