"""Loads that are no little thing beside a vessel that moves as given and does not feel them."""

from __future__ import annotations

from collections.abc import Iterator

from gantline.assembly.afloat.vessels import upright_hydrostatics
from gantline.assembly.parts import Parts
from gantline.scenario import Scenario
from gantline.scenario.errors import Doubt
from gantline.scenario.tag_line import tag_rope
from gantline.units import format_quantity

__all__ = ["doubtful_carried"]

#: What hangs over what a vessel displaces, from which on it changes how she lies and moves.
_LIGHT = 0.02


def doubtful_carried(parts: Parts, scenario: Scenario) -> Iterator[Doubt]:
    """Each vessel with `wave_motion` that lifts or bears, at any time, a load that is heavy beside her.

    What the plan puts on or sets down later is among the ropes and contacts from the start.
    """
    vessels = {name: one for name, one in (scenario.vessels or {}).items() if one.is_carried}
    if scenario.load is None or not vessels:
        return
    aside = {tag_rope(name) for name in scenario.tag_lines or {}}
    bearing = _bearing(parts, scenario.load.name, set(scenario.vessels or {}), aside)
    for name in (name for name in vessels if name in bearing):
        share = scenario.load.mass_at_start / upright_hydrostatics(scenario, name, vessels[name]).mass
        if share > _LIGHT:
            weighs = f"the load weighs {format_quantity(share, '%', 1)} of what {name} displaces"
            yield Doubt(
                ("vessels", name, "wave_motion"),
                f"{weighs}: it changes how she lies and moves, and by 'wave_motion' she does neither",
            )


def _bearing(parts: Parts, load: str, vessels: set[str], aside: set[str]) -> set[str]:
    """Vessels to which a load leads by joints, ropes and contacts, but for ropes that only guide it."""
    aboard: dict[str, str] = {}
    for name, given in parts.bodies.items():  # parents before their children
        vessel = name if name in vessels else aboard.get(given["parent"])
        if vessel is not None:
            aboard[name] = vessel
    beside: dict[str, set[str]] = {}
    for joined in _joined(parts, aside):
        bodies = {body for body in joined if body is not None}
        for body in bodies:
            beside.setdefault(body, set()).update(bodies)
    found, seen, left = set[str](), {load}, [load]
    while left:
        body = left.pop()
        if body in aboard:
            found.add(aboard[body])
            continue
        new = beside.get(body, {body}) - seen
        seen |= new
        left += new
    return found


def _joined(parts: Parts, aside: set[str]) -> Iterator[list[str | None]]:
    """Bodies, or the world, that a joint, a rope or a contact holds together."""
    for name, body in parts.bodies.items():
        yield [name, body["parent"]]
    for rope in parts.ropes:
        if rope["name"] not in aside:
            yield [guide["body"] for guide in rope["route"]]
    for contact in parts.contacts:
        yield [contact["body"], contact.get("plane_body")]
    for rim in parts.rims:
        yield [rim["body"], None]
    for pair in parts.pairs:
        yield [parts.shapes[shape]["body"] for shape in pair["shapes"]]
