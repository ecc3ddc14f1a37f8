"""Headings and phases of more than one turn in radians: degrees are meant."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt, PathPart
from gantline.scenario.file.tree import ListNode, MapNode, Node
from gantline.units import UnitError, quantity

__all__ = ["doubtful_turns"]

#: Keys of directions in the plan view, and of how late waves are.
_HEADINGS = ("heading", "direction", "phase")


def doubtful_turns(scenario: Scenario) -> Iterator[Doubt]:
    """Each heading of more than a turn that is written in radians."""
    for path, text in _headings(scenario.tree, ()):
        number, _, unit = text.strip().rpartition("rad")
        try:
            angle = 0.0 if unit else abs(quantity(text, "angle"))
        except UnitError:
            continue
        if number and angle > math.tau:
            meant = f"{number.strip()} deg"
            turns = f"{text.strip()} are {angle / math.tau:.3g} turns"
            yield Doubt(path, f"{turns}; '{meant}' may be meant")


def _headings(node: Node, path: tuple[PathPart, ...]) -> Iterator[tuple[tuple[PathPart, ...], str]]:
    """Each text under such a key, with its path."""
    if isinstance(node, MapNode | ListNode):
        parts = node.items() if isinstance(node, MapNode) else enumerate(node)
        for key, part in parts:
            yield from _headings(part, (*path, key))
    elif path and path[-1] in _HEADINGS:
        yield path, str(node)
