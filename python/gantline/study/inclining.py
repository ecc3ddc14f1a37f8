"""Metacentric heights by inclining: how far a vessel turns where a little of its weight is shifted.

Shifting the mass m of a vessel's body by dy across it heels it with the moment m g dy, and it comes to rest
where Δ g GM dφ rights it as much: GM = m dy/(Δ dφ), with Δ all that it displaces. That is what a yard does
to find GM, done with derivatives of the equilibrium. So everything counts that follows the turn: liquids in
slack tanks, loads that hang from its hooks, ropes that hold it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from gantline.results.rotation import heading
from gantline.statics import Equilibrium, Statics

__all__ = ["MetacentricHeights", "metacentric_heights"]


@dataclass(frozen=True)
class MetacentricHeights:
    """What rights a vessel, free surfaces and hanging loads included; negative where nothing does.

    Attributes:
        transverse: for heel [m].
        longitudinal: for trim [m].
    """

    transverse: float
    longitudinal: float


def metacentric_heights(question: Statics, rest: Equilibrium) -> dict[str, MetacentricHeights]:
    """Metacentric heights of every vessel of a lift.

    Args:
        question: The lift.
        rest: Its equilibrium that was found last.
    """
    masses = {body["name"]: float(body["mass"]) for body in question.assembly.document["bodies"]}
    found = {}
    for vessel in rest.recording.rig.vessels:
        across, along = question.sensitivities([("centre_y", vessel.body), ("centre_x", vessel.body)])
        ahead = float(heading(rest.recording.column("body_orientation", vessel.body)[-1]))
        forward = np.array([math.cos(ahead), math.sin(ahead)])
        port = np.array([-math.sin(ahead), math.cos(ahead)])
        displaced = float(rest.recording.column("vessel_displacement", vessel.name)[-1])
        share = masses[vessel.body] / displaced if displaced > 0.0 else math.inf
        heel = -float(across.of_body(vessel.body)[3:5] @ forward)
        dip = float(along.of_body(vessel.body)[3:5] @ port)
        found[vessel.name] = MetacentricHeights(share / heel, share / dip)
    return found
