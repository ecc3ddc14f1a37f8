"""Hydrodynamic databases that lift files name: read once, what is wrong with them said with the line."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import TypeVar

from gantline.assembly.stamp import stamp
from gantline.hydro.database import DatabaseError, HydrodynamicDatabase, read_database
from gantline.scenario import Scenario
from gantline.scenario.errors import PathPart

__all__ = ["from_database"]

T = TypeVar("T")


def from_database(
    scenario: Scenario,
    path: tuple[PathPart, ...],
    named: tuple[str, str | None, float],
    use: Callable[[HydrodynamicDatabase], T],
) -> T:
    """What `use` makes of a database.

    Args:
        scenario: the lift.
        path: of the element of the lift file that names it as its `database`.
        named: the file beside the lift file, the body in it, None where it has one, and the direction of that
            body's x axis in it [rad]; what is used has the axes of the body.
        use: may raise `DatabaseError`.

    Raises:
        ScenarioError: if the file cannot be read, or `use` cannot use it.
    """
    file, body, heading = named
    place = Path(scenario.source).parent / file
    try:
        return use(_read(place, stamp(place), body, heading))
    except DatabaseError as problem:
        raise scenario.error((*path, "database"), str(problem).replace(str(place), file)) from None


@lru_cache(maxsize=8)
def _read(path: Path, _stamp: tuple[int, int], body: str | None, heading: float) -> HydrodynamicDatabase:
    """A database, read once for added mass, damping, waves and all cases of a lift."""
    found = read_database(path, body)
    return found.along(heading) if heading else found
