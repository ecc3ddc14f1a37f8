"""How a lift hangs over the values of one quantity of its file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from gantline.arguments import needed
from gantline.scenario import Scenario, ScenarioError, StartError, load_scenario
from gantline.scenario.errors import Problem
from gantline.scenario.file.tree import TextNode
from gantline.scenario.file.tree_path import PathError, node_at
from gantline.scenario.file.variants import with_value
from gantline.statics import Statics
from gantline.study.asked import count_of
from gantline.study.state import State, settled, unstartable
from gantline.units import common_dimension, in_unit, is_quantity, quantity, si_text, unit_of

__all__ = ["SweepError", "SweepPoint", "run_sweep"]


class SweepError(ScenarioError):
    """A value of a sweep cannot be in the lift file; the message is that of the file with the value.

    Attributes:
        value: The value, in the unit of the sweep.
    """

    def __init__(self, source: str, problems: Sequence[Problem], value: str) -> None:
        super().__init__(source, problems)
        self.value = value

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: an error of a process that works for another one arrives there whole."""
        return type(self), (self.source, self.problems, self.value)


@dataclass(frozen=True)
class SweepPoint:
    """One value of a sweep.

    Attributes:
        value: The value [SI].
        dimension: Its dimension, a key of `gantline.units.DIMENSIONS`.
        unit: The unit of that dimension in which the sweep is written.
        state: How the lift hangs with it.
    """

    value: float
    dimension: str
    unit: str
    state: State


def run_sweep(
    lift: str | Path | Scenario, path: str, first: str, last: str, count: int, time: float | None = None
) -> Iterator[SweepPoint]:
    """Statics of a lift over evenly spaced values of one quantity.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        path: Dotted path of the quantity in the lift file, as in `cases:`.
        first: The first value as written, such as `36 m`.
        last: The last value.
        count: How many values, from 1 on; 1 is the first alone.
        time: Time of the plan [s]; None for the end of the lift.

    Yields:
        Each value with what was found, as soon as it is; errors come with the first.

    Raises:
        TypeError: If `count` is no whole number, or the path no text.
        ValueError: If there are to be none.
        PathError: If the path leads nowhere or to no quantity.
        UnitError: If the values are no quantities of one dimension.
        ScenarioError: If the lift file is not right.
        SweepError: If a value cannot be there; a ScenarioError too.
    """
    count = count_of("count", count)
    scenario = lift if isinstance(lift, Scenario) else load_scenario(lift)
    needed(path, str, "path: a text", "such as 'load.weight.calculated'")
    given = node_at(scenario.tree, path)
    if given is not None and not isinstance(given, TextNode):
        raise PathError(f"'{path}' has several values; name one of its parts")
    like = [] if given is None or not is_quantity(given) else [str(given)]
    first, last = str(first), str(last)  # a number is answered as text without a unit is
    dimension = common_dimension(*like, first, last)
    unit = unit_of(*like, first, last, dimension=dimension)
    for value in np.linspace(quantity(first, dimension), quantity(last, dimension), count):
        text = in_unit(float(value), dimension, unit, 15)
        if quantity(text, dimension) != value:
            text = si_text(float(value), dimension)  # to the last bit
        state = State("", path, "none", 0.0)
        try:
            found = settled(Statics(with_value(scenario, path, text)), time, state)
        except StartError as error:
            found = unstartable(state, scenario.duration if time is None else time, error)
        except ScenarioError as error:
            shown = in_unit(float(value), dimension, unit)
            raise SweepError(error.source, error.problems, shown) from None
        yield SweepPoint(float(value), dimension, unit, found)
