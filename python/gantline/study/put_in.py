"""Whether a run can start from a lift file that has an answer in it.

An answer is looked for among cases, which may pull from the start. The same values in the lift file itself
may leave slings too short for the load where that stands, which a run refuses.
"""

from __future__ import annotations

from collections.abc import Mapping

from gantline.assembly import assemble
from gantline.scenario import Scenario
from gantline.scenario.errors import StartError
from gantline.units import si_text

__all__ = ["refused_at_the_start"]


def refused_at_the_start(scenario: Scenario, values: Mapping[str, float]) -> tuple[str, ...]:
    """What keeps a run of the lift file with these values from starting; nothing where it starts.

    Args:
        scenario: The lift file as it is given.
        values: New values by path [m].

    Returns:
        The elements with what is found of each, as "slings.S1: the sling is 12.1 m, but ...".
    """
    try:
        assemble(scenario.changed({path: si_text(value, "length") for path, value in values.items()}))
    except StartError as error:
        # What would be right of a file, such as a longer sling, would undo the answer.
        return tuple(problem.message.partition(";")[0] for problem in error.problems)
    return ()
