"""Sheaves that are not ideal: the flow of rope over them."""

from __future__ import annotations

from gantline.assembly.parts import Parts
from gantline.scenario.sheave import SheaveLosses

__all__ = ["add_sheave_flow"]


def add_sheave_flow(parts: Parts, name: str, losses: SheaveLosses) -> tuple[str, float] | None:
    """Add the flow over a sheave; an ideal sheave needs none.

    Args:
        parts: the system so far.
        name: name of the flow; with a stroke, which no name of a lift file has.
        losses: what the sheave does to the rope.

    Returns:
        Name of the flow and largest ratio of tensions, as `half_turn` takes them; None for an ideal sheave.
    """
    if losses.is_ideal:
        return None
    parts.add_flow(name, losses.inertia)
    parts.inertia_from[name] = losses.inertia_from
    return name, losses.ratio
