"""Ropes that break, are cut or are taken off, in the ropes and steps of the document."""

from __future__ import annotations

from gantline.assembly.parts import Json, Parts
from gantline.scenario import Scenario
from gantline.scenario.plan.parting import partings

__all__ = ["add_partings", "pieces_of"]


def add_partings(parts: Parts, scenario: Scenario) -> None:
    """Tell the ropes, and the steps of the plan, which break, are cut, taken off or put on.

    Of a rope with nodes every piece breaks by itself; it is cut, or taken off, at its first end.

    Args:
        parts: the system with all its ropes and its plan.
        scenario: the lift.
    """
    lines = {one["name"]: one for one in parts.forces if one["type"] == "mooring"}
    for name, parting in partings(scenario).items():
        if name in lines:
            continue  # they have been told
        pieces = pieces_of(parts, name)
        for piece in pieces if parting.breaks_at is not None else ():
            piece["breaking_force"] = parting.breaks_at
        if parting.cut_at is not None:
            pieces[0]["cut_at"] = parting.cut_at
    for given, step in zip(scenario.plan, parts.plan, strict=True):
        for key, names in (("cuts", given.cut), ("detaches", given.detach), ("attaches", given.attach)):
            if names:
                step[key] = [name if name in lines else pieces_of(parts, name)[0]["name"] for name in names]


def pieces_of(parts: Parts, name: str) -> list[Json]:
    """A rope of the document, or the pieces between its nodes, from its first end on."""
    return [rope for rope in parts.ropes if rope["name"] == name or rope["name"].startswith(f"{name}/")]
