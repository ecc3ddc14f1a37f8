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
    load = scenario.load.name
    return next((body for body in bodies if _stands_on(parts, scenario, body, load)), load)


def settle_with_load(parts: Parts, scenario: Scenario, lifted: LiftedLoad) -> None:
    """Bodies on a load that has settled come along, so that they touch as the lift file has them.

    Else they would be above it by what the load has sunk in, where friction holds nothing at the start.
    """
    load, mechanics = scenario.load, scenario.mechanics
    if load is None or mechanics is None or not scenario.load_has_settled or scenario.hinges:
        return
    given = rotation_matrix(about_axis((0.0, 0.0, 1.0), load.heading))
    middle = np.array(load.position) + given @ lifted.centre
    position, rotation = parts.pose(load.name)
    touching = [set(contact.between) for contact in (mechanics.body_contacts or {}).values()]
    along = [load.name]
    for carrier in along:  # what stands on what stands on it, too
        found = (body for body in mechanics.bodies if body not in along and {carrier, body} in touching)
        for body in [one for one in found if _stands_on(parts, scenario, one, carrier)]:
            place = parts.place(body, (0.0, 0.0, 0.0))
            way = position + rotation @ given.T @ (place - middle) - place
            joint, placement = (parts.bodies[body][key] for key in ("joint", "placement"))
            own = rotation_matrix(placement["orientation"]).T @ way
            joint["position"] = [float(was + more) for was, more in zip(joint["position"], own, strict=True)]
            along.append(body)


def _stands_on(parts: Parts, scenario: Scenario, body: str, carrier: str) -> bool:
    """Whether a free body of `mechanics` is all above the origin of another body at the start."""
    plain = scenario.mechanics.bodies if scenario.mechanics is not None else {}
    if body not in plain or body not in parts.shapes or parts.bodies[body]["joint"]["type"] != "free":
        return False
    (position, rotation), (box,) = parts.pose(body), parts.shapes[body]["parts"]
    reach = np.abs(rotation[2]) @ np.array(box["size"]) / 2
    lowest = position[2] + rotation[2] @ np.array(box["centre"]) - reach
    return bool(lowest > parts.place(carrier, (0.0, 0.0, 0.0))[2])
