"""Bodies of `mechanics` that stand on the load from the start: it carries them, and they do not bear it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gantline.assembly.loads.lifted import LiftedLoad
from gantline.assembly.parts import Parts
from gantline.assembly.spatial import about_axis, rotation_matrix
from gantline.scenario import Scenario

__all__ = ["carried", "settle_with_load"]


def carried(parts: Parts, scenario: Scenario, bodies: Sequence[str]) -> str:
    """Which of the bodies of a contact is carried there: the load, but where another stands on it."""
    if scenario.load is None or scenario.load.name not in bodies:
        return bodies[0]
    return next((body for body in bodies if _stands_on_load(parts, scenario, body)), scenario.load.name)


def settle_with_load(parts: Parts, scenario: Scenario, lifted: LiftedLoad) -> None:
    """Bodies on a load that has settled come along, so that they touch it as the lift file has them.

    Else they would be above it by what the load has sunk in, where friction holds nothing at the start.
    """
    load, mechanics = scenario.load, scenario.mechanics
    if load is None or mechanics is None or not scenario.load_has_settled or scenario.hinges:
        return
    given = rotation_matrix(about_axis((0.0, 0.0, 1.0), load.heading))
    middle = np.array(load.position) + given @ lifted.centre
    position, rotation = parts.pose(load.name)
    touching = [set(contact.between) for contact in (mechanics.body_contacts or {}).values()]
    for body in mechanics.bodies:
        if {load.name, body} not in touching or not _stands_on_load(parts, scenario, body):
            continue
        place = parts.place(body, (0.0, 0.0, 0.0))
        way = position + rotation @ given.T @ (place - middle) - place
        joint, placement = (parts.bodies[body][key] for key in ("joint", "placement"))
        own = rotation_matrix(placement["orientation"]).T @ way
        joint["position"] = [float(was + more) for was, more in zip(joint["position"], own, strict=True)]


def _stands_on_load(parts: Parts, scenario: Scenario, body: str) -> bool:
    """Whether a free body of `mechanics` is all above the centre of gravity of the load at the start."""
    plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    if scenario.load is None or body not in plain or body not in parts.shapes:
        return False
    if parts.bodies[body]["joint"]["type"] != "free":
        return False
    (position, rotation), (box,) = parts.pose(body), parts.shapes[body]["parts"]
    reach = np.abs(rotation[2]) @ np.array(box["size"]) / 2
    lowest = position[2] + rotation[2] @ np.array(box["centre"]) - reach
    return bool(lowest > parts.place(scenario.load.name, (0.0, 0.0, 0.0))[2])
