"""Sheaves that are not ideal: the flow of rope over them, and their spin where rope slips in the groove."""

from __future__ import annotations

from gantline.assembly.parts import Json, Parts
from gantline.scenario.sheave import SheaveLosses

__all__ = ["add_sheave_flow", "spin_of"]


def add_sheave_flow(parts: Parts, name: str, losses: SheaveLosses) -> Json:
    """Add the flow over a sheave; an ideal sheave needs none.

    Args:
        parts: the system so far.
        name: name of the flow; with a stroke, which no name of a lift file has.
        losses: what the sheave does to the rope.

    Returns:
        What its guide says of that; nothing for an ideal sheave.
    """
    if losses.is_ideal:
        return {}
    parts.inertia_from[name] = losses.inertia_from
    if not losses.slips:
        parts.add_flow(name, losses.inertia)
        return {"flow": name, "ratio": losses.bearing}
    parts.add_flow(name, losses.on_sheave)
    if not losses.turns:
        return {"flow": name, "groove": {"friction": losses.groove}}
    spin = spin_of(name)
    parts.add_flow(spin, losses.inertia)
    return {"flow": name, "ratio": losses.bearing, "groove": {"friction": losses.groove, "spin": spin}}


def spin_of(flow: str) -> str:
    """Name of the spin of a sheave, radius times angle, by that of the flow of rope over it."""
    return f"{flow}/spin"
