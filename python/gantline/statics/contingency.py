"""How vessels lie otherwise with the design weight of the loads that hang from them or stand on them.

To first order: derivatives of an equilibrium to the mass of every load, times what contingency adds to what
is simulated; what rights them is that of the equilibrium with all of it. All that moves with the turn counts,
as in `gantline.statics.inclining`; drums stay as wound as they are, tanks as full, and what runs through
holes is not known here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gantline.results.afloat.attitude import Lie
from gantline.results.afloat.vessels import ByContingency, Heights, Vessel
from gantline.results.rotation import axes
from gantline.scenario.afloat.tanks import holed_tanks
from gantline.statics.answers import Equilibrium, NoEquilibriumError
from gantline.statics.inclining import heights_of

if TYPE_CHECKING:
    from gantline.statics.lift import Statics

__all__ = ["by_contingency"]


def by_contingency(question: Statics, rest: Equilibrium, heights: Heights) -> dict[str, ByContingency]:
    """What vessels do with the design weight of all loads beside what they do, by their names.

    Nothing where no load has more than is simulated, nor where the lift rests nowhere or answers to no weight
    smoothly.

    Args:
        question: The lift.
        rest: Its equilibrium that was found last.
        heights: Metacentric heights there of the vessels of which it is asked how these change.
    """
    more = {load.body: load.more_mass for load in question.rig.loads if load.more_mass > 0.0}
    vessels = [one for one in rest.recording.rig.vessels if not one.is_carried]
    if not more or not vessels or not rest.is_stable or holed_tanks(question.scenario):
        return {}
    try:
        answers = question.sensitivities([("mass", body) for body in more], standing=True)
    except NoEquilibriumError:
        return {}
    if not all(one.is_held for one in answers):
        return {}
    righted = _righted(question, more, [one for one in vessels if one.name in heights])
    found = {}
    for vessel in vessels:
        moves = [mass * one.of_body(vessel.body) for mass, one in zip(more.values(), answers, strict=True)]
        change = _change(rest, vessel, np.sum(moves, axis=0))
        if vessel.name in righted:
            height = righted[vessel.name] - heights[vessel.name][0]
            change = replace(change, metacentric_height=height)
        found[vessel.name] = change
    return found


def _righted(question: Statics, more: Mapping[str, float], vessels: Sequence[Vessel]) -> dict[str, float]:
    """Metacentric heights for heel of vessels by their names [m], with bodies so much heavier [kg]."""
    if not vessels:
        return {}
    try:
        heavier, recording = question.heavier(more)
        return {
            one.name: heights_of(
                heavier,
                recording,
                one.body,
                float(recording.column("vessel_displacement", one.name)[-1]),
            ).transverse
            for one in vessels
        }
    except NoEquilibriumError:
        return {}


def _change(rest: Equilibrium, vessel: Vessel, motion: npt.NDArray[np.float64]) -> ByContingency:
    """What a small motion of its centre of gravity and turn, shape (6,), do to how a vessel lies."""
    recording = rest.recording
    turn = axes(recording.column("body_orientation", vessel.body)[-1])
    centre = np.asarray(vessel.centre_of_gravity)
    height = recording.column("body_position", vessel.body)[-1][2] - turn[2] @ centre - vessel.level
    heel, trim = Lie(turn, height).leans(motion[3:])
    marks = np.array([point for points in vessel.marks.values() for point in points])
    heights = marks @ turn[2] + height
    moved = motion[2] + np.cross(motion[3:], (marks - centre) @ turn.T)[:, 2]
    freeboard = float((heights + moved).min() - heights.min()) if len(marks) else 0.0
    return ByContingency(rest.time, float(heel), float(trim), freeboard)
