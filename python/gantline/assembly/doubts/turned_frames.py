"""Frames of equalizers whose slings lead to the lugs of the other side, and cross.

All slings of an equalizer pull with nearly the same force V upright. Seen from above, with sheaves at r_i
from the hinge and lugs at l_i, h below them, they have about it the moment (V/h) times the sum of r_i × l_i,
and the stiffness (V/h) times the sum of r_i · l_i. So they come to rest where the frame has turned by

    ψ = atan2(Σ r_i × l_i, Σ r_i · l_i)

with places counted from their means, since a row in its middle feels no offset of all lugs. Beyond 90° the
stiffness is below zero, and slings cross each other; exactly at 180° nothing turns the frame but what no lift
file has, a run that is symmetrical keeps it there, and the least friction of its hinge passes for stable.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from gantline.assembly.parts import Json, Parts
from gantline.assembly.spatial import Array
from gantline.scenario import Rigging, Scenario
from gantline.scenario.errors import Doubt

__all__ = ["doubtful_frames"]

#: A frame that turns less far has its slings askew and none of them crossed, as in the paper's lift [rad].
_CROSSED = math.radians(90.0)
#: Lugs that hardly lead a frame anywhere, as of slings to one lug: less of |r| |l| than this [1].
_LEADS = 0.1


def doubtful_frames(parts: Parts, scenario: Scenario, rigging: Rigging) -> Iterator[Doubt]:
    """Each frame that would turn by more than 90° as its slings go taut, with the heading that it comes to.

    Slings that a step puts on are left out, since load and hooks may be elsewhere by then; so is a frame that
    the friction of its hinge holds against all that the load could do.

    Args:
        parts: The system with all its bodies and ropes.
        scenario: The lift.
        rigging: Who carries whom.
    """
    load = scenario.load
    if load is None:
        return
    routes: dict[str, list[Json]] = {}
    for rope in parts.ropes:  # of one with nodes the route of all its pieces
        routes.setdefault(rope["name"].rpartition("/")[0] or rope["name"], []).extend(rope["route"])
    for name, equalizer in rigging.equalizers.items():
        slings = [one for one in rigging.slings.values() if one.equalizer == name and one.starts_on]
        if len(slings) < 2:
            continue
        ends = [routes[f"sling.{sling.name}"] for sling in slings]
        sheaves = _about_their_middle(parts, [route[0] for route in ends])
        lugs = _about_their_middle(parts, [route[-1] for route in ends])
        most = float(np.sum(np.linalg.norm(sheaves, axis=1) * np.linalg.norm(lugs, axis=1)))
        along = float(np.sum(sheaves * lugs))
        across = float(np.sum(sheaves[:, 0] * lugs[:, 1] - sheaves[:, 1] * lugs[:, 0]))
        lever = float(np.linalg.norm(sheaves, axis=1).max())
        holds = equalizer.hinge.friction >= load.mass_at_start * scenario.simulation.gravity * lever
        turn = math.atan2(across, along)
        if holds or math.hypot(along, across) <= _LEADS * most or abs(turn) <= _CROSSED:
            continue
        heading = round(math.degrees(equalizer.heading + turn)) % 360
        names = f"{', '.join(one.name for one in slings[:-1])} and {slings[-1].name}"
        stands = f"{names} cross: their frame stands {math.degrees(abs(turn)):.0f} deg from where they lead"
        right = f"write 'heading: {heading} deg', or lead them to the lugs in the order of their sheaves"
        held = "a small push turns it so far, whatever a run without one shows"
        yield Doubt(("equalizers", name), f"{stands}, and {held}; {right}")


def _about_their_middle(parts: Parts, ends: Sequence[Json]) -> Array:
    """Places of some ends of ropes, seen from above, from the mean of them [m]."""
    places = np.array([parts.place(end["body"], end["at"])[:2] for end in ends])
    middle: Array = places - places.mean(axis=0)
    return middle
