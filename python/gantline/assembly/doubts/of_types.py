"""What is doubtful about several things that have it from one type: said once, with their names."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterable
from dataclasses import replace
from typing import Final

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt, Problem
from gantline.scenario.file.types import TYPED

__all__ = ["said_once"]

_TYPED: Final = {of.section: of.types for of in TYPED}
#: Most names that are said.
_MOST: Final = 3


def said_once(scenario: Scenario, doubts: Iterable[Doubt]) -> tuple[Problem, ...]:
    """Each doubt with its line; those at one place of a type that differ in the name of a thing alone as one.

    Args:
        scenario: The lift.
        doubts: All of them.
    """
    found: dict[Hashable, Problem] = {}
    others: dict[Hashable, list[str]] = {}
    for path, sentence in doubts:
        problem = scenario.problem(path, sentence)
        key: Hashable = problem
        is_typed = len(path) > 1 and str(path[0]) in _TYPED
        name = str(path[1]) if is_typed else ""
        if is_typed and problem.path.startswith(f"{_TYPED[str(path[0])]}."):
            nameless = re.sub(rf"(?<![\w.-]){re.escape(name)}(?![\w-])", "\0", sentence)
            key = replace(problem, sentence=nameless)
        if key not in found:
            found[key] = problem
        elif problem != found[key] and name not in others.setdefault(key, []):
            others[key].append(name)
    return tuple(
        replace(one, sentence=f"{one.sentence} ({_names(others[key])} alike)") if key in others else one
        for key, one in found.items()
    )


def _names(names: list[str]) -> str:
    more = len(names) - _MOST
    shown = names if more <= 0 else [*names[:_MOST], f"{more} more"]
    return " and ".join(part for part in (", ".join(shown[:-1]), shown[-1]) if part)
