"""When steps of a plan begin and end, in a lift that is followed from rest to rest."""

from __future__ import annotations

from gantline.statics import Statics

__all__ = ["begin_of_step", "end_of_step"]


def begin_of_step(question: Statics, name: str) -> float | None:
    """When a step of the plan begins [s]; None if that is not before the end of the lift.

    Args:
        question: A lift without cases; it goes on from there if an equilibrium is asked for next.
        name: Name of the step.

    Raises:
        NoEquilibriumError: If the lift cannot be followed.
    """
    return question.when(name, "begins")


def end_of_step(question: Statics, name: str) -> float | None:
    """When a step of the plan ends [s], with the lift where it lasts until then; None if it never begins.

    For arguments and exceptions see `begin_of_step`.
    """
    end = question.when(name, "ends")
    return question.scenario.duration if end is None and question.times_of(name)[0] is not None else end
