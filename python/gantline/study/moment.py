"""When steps of a plan begin and end, in a lift that is followed from rest to rest."""

from __future__ import annotations

from gantline.scenario import Scenario
from gantline.statics import Statics

__all__ = ["begin_of_step", "end_of_step"]


def begin_of_step(scenario: Scenario, name: str) -> float | None:
    """When a step of the plan begins [s]; None if that is not before the end of the lift.

    Args:
        scenario: A lift without cases.
        name: Name of the step.

    Raises:
        NoEquilibriumError: If the lift cannot be followed.
    """
    return _times(scenario, name)[0]


def end_of_step(scenario: Scenario, name: str) -> float | None:
    """When a step of the plan ends [s], with the lift where it lasts until then; None if it never begins.

    For arguments and exceptions see `begin_of_step`.
    """
    begin, end = _times(scenario, name)
    return None if begin is None else scenario.duration if end is None else end


def _times(scenario: Scenario, name: str) -> tuple[float | None, float | None]:
    question = Statics(scenario)
    question.equilibrium()
    return question.times_of(name)
