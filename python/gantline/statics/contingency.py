"""How vessels lie otherwise with the design weight of the loads that hang from them or stand on them.

To first order: derivatives of an equilibrium to the mass of every load, times what contingency adds to what
is simulated; what rights them is that of the equilibrium with all of it, and so is how they lie where that
is more than a degree elsewhere. All that moves with the turn counts,
as in `gantline.statics.inclining`; drums stay as wound as they are, tanks as full, and what runs through
holes is not known here.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gantline.results.afloat.attitude import Lie
from gantline.results.afloat.vessels import ByContingency, Heights, Vessel
from gantline.results.recording import Recording
from gantline.results.rotation import axes
from gantline.scenario.afloat.tanks import holed_tanks
from gantline.statics.answers import Equilibrium, NoEquilibriumError
from gantline.statics.inclining import heights_of

if TYPE_CHECKING:
    from gantline.statics.lift import Statics

__all__ = ["by_contingency"]

#: How far from where derivatives lead a vessel has to rest for that to count [rad].
_ELSEWHERE = math.radians(1.0)


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
    heavier = _heavier(question, more, vessels)
    found = {}
    for vessel in vessels:
        moves = [mass * one.of_body(vessel.body) for mass, one in zip(more.values(), answers, strict=True)]
        change = _change(rest, vessel, np.sum(moves, axis=0))
        if heavier is None:
            found[vessel.name] = replace(change, rests=False)
            continue
        recording, righted = heavier
        if vessel.name in righted:
            change = _with_heights(change, righted[vessel.name], heights.get(vessel.name))
        found[vessel.name] = _where_it_rests(change, vessel.name, rest.recording, recording)
    return found


def _where_it_rests(
    change: ByContingency, vessel: str, simulated: Recording, heavier: Recording
) -> ByContingency:
    """As the vessel lies with all of the weight, where derivatives do not lead there.

    One that is askew by a hair heels by degrees where that weight takes what has righted it.
    """
    heel, trim, freeboard = (
        float(heavier.column(name, vessel)[-1] - simulated.column(name, vessel)[-1])
        for name in ("vessel_heel", "vessel_trim", "vessel_freeboard")
    )
    if max(abs(heel - change.heel), abs(trim - change.trim)) <= _ELSEWHERE:
        return change
    return replace(change, heel=heel, trim=trim, freeboard=freeboard)


def _with_heights(
    change: ByContingency, heavier: tuple[float, float], asked: tuple[float, float] | None
) -> ByContingency:
    """What metacentric heights with the design weight, for heel and trim [m], say beside those asked for."""
    least = min(heavier)
    return replace(
        change,
        metacentric_height=None if asked is None else heavier[0] - asked[0],
        least_height=least if least < 0.0 else None,
    )


def _heavier(
    question: Statics, more: Mapping[str, float], vessels: Sequence[Vessel]
) -> tuple[Recording, Heights] | None:
    """How the lift rests with bodies so much heavier [kg], and metacentric heights of vessels there.

    None where it rests nowhere with that; no heights where it answers to no push smoothly there.
    """
    try:
        heavier, recording = question.heavier(more)
    except NoEquilibriumError:
        return None
    found: Heights = {}
    try:
        for one in vessels:
            displaced = float(recording.column("vessel_displacement", one.name)[-1])
            heights = heights_of(heavier, recording, one.body, displaced)
            found[one.name] = heights.transverse, heights.longitudinal
    except NoEquilibriumError:
        return recording, {}
    return recording, found


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
