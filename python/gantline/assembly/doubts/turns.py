"""Headings and phases of more than one turn in radians, where degrees are meant; slews of a turn or more."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt, PathPart
from gantline.scenario.file.tree import ListNode, MapNode, Node
from gantline.scenario.plan.movers import mover
from gantline.scenario.plan.positions import places_of_cranes
from gantline.scenario.plan.steps import SlewStep
from gantline.units import UnitError, format_quantity, quantity

__all__ = ["doubtful_turns"]

#: Keys of directions in the plan view, and of how late waves are.
_HEADINGS = ("heading", "direction", "phase")
#: Rounding of angles that steps add up [rad].
_ROUNDING = 1e-9


def doubtful_turns(scenario: Scenario) -> Iterator[Doubt]:
    """Each heading of more than a turn that is written in radians, and each slew by a whole turn or more."""
    yield from _slews(scenario)
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


def _slews(scenario: Scenario) -> Iterator[Doubt]:
    """The first step that slews a crane all the way round: another angle is the same heading, and nearer.

    Later ones of that crane may only come back from there.
    """
    told = set()
    for place, (step, before) in enumerate(zip(scenario.plan, places_of_cranes(scenario), strict=False)):
        if not isinstance(step, SlewStep):
            continue
        for name in step.moved:
            one = mover(scenario, step.kind, name)
            at, is_known = before[one.name] if one is not None else (0.0, False)
            key = "to" if step.by is None else "by"
            way = step.by if step.to is None else step.to - at if is_known else None
            if way is None or name in told or abs(way) < math.tau - _ROUNDING:
                continue
            told.add(name)
            slews = f"step '{step.step}' slews {name} by {format_quantity(way, 'deg', 1)}, all the way round"
            left = math.remainder(way, math.tau)
            end = math.degrees(at + left if key == "to" else left)
            is_nowhere = abs(left) <= _ROUNDING
            same = (
                "its heading is then as before"
                if is_nowhere
                else f"'{key}: {end:.6g} deg' is the same heading"
            )
            yield Doubt(("plan", place, key), f"{slews}; {same}")


def _headings(node: Node, path: tuple[PathPart, ...]) -> Iterator[tuple[tuple[PathPart, ...], str]]:
    """Each text under such a key, with its path."""
    if isinstance(node, MapNode | ListNode):
        parts = node.items() if isinstance(node, MapNode) else enumerate(node)
        for key, part in parts:
            yield from _headings(part, (*path, key))
    elif path and path[-1] in _HEADINGS:
        yield path, str(node)
