"""What rights vessels where a run begins and ends: one that is symmetrical does not show that it is there."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gantline.results.rotation import axes
from gantline.statics.answers import Equilibrium, NoEquilibriumError
from gantline.statics.inclining import metacentric_heights

if TYPE_CHECKING:
    from gantline.statics.lift import Statics

__all__ = ["righting", "righting_at_end", "righting_at_start"]

#: Metacentric heights for heel and trim of vessels by their names [m].
Heights = dict[str, tuple[float, float]]

#: How far from where it lies in a run a vessel may come to rest before it is asked what rights it there
#: [rad]. One of GM = -6 mm with BM = 20 m comes to rest by sqrt(-2 GM/BM) = 1.4 deg.
_ELSEWHERE = math.radians(1.0)


def righting(question: Statics, rest: Equilibrium) -> Heights:
    """Metacentric heights for heel and trim of vessels that nothing rights, of all if they have a limit [m].

    Args:
        question: The lift.
        rest: Its equilibrium that was found last.
    """
    limits = question.scenario.limits
    is_limited = limits is not None and limits.metacentric_height is not None
    if not rest.recording.rig.vessels or (rest.is_stable and not is_limited):
        return {}
    try:
        heights = metacentric_heights(question, rest)
    except NoEquilibriumError:  # it answers to no push smoothly
        return {}
    both = {name: (one.transverse, one.longitudinal) for name, one in heights.items()}
    return {
        name: found
        for name, found in both.items()
        if (is_limited and math.isfinite(found[0])) or min(found) < 0.0
    }


def righting_at_start(question: Statics) -> Heights:
    """The same where a lift starts at rest."""
    try:
        return righting(question, question.equilibrium(0.0, losses="held"))
    except NoEquilibriumError:
        return {}


def righting_at_end(
    question: Statics, time: float, state: bytes, attitudes: Mapping[str, npt.ArrayLike]
) -> Heights:
    """The same where a run has got to; nothing of one that comes to rest nowhere.

    What rounding has moved goes on downhill: where it comes to rest elsewhere, the equilibrium of the plan
    tells what rights it.

    Args:
        question: The lift.
        time: To which the run has got [s].
        state: What it has saved there.
        attitudes: Of its vessels there by their bodies, world from body, shape (4,).
    """
    try:
        rest = question.equilibrium_of(state)
        if rest.is_stable and _is_elsewhere(rest, attitudes):
            rest = question.equilibrium(min(time, question.scenario.duration))
        return righting(question, rest)
    except NoEquilibriumError:
        return {}


def _is_elsewhere(rest: Equilibrium, attitudes: Mapping[str, npt.ArrayLike]) -> bool:
    """Whether a vessel comes to rest with another heel or trim."""
    for body, attitude in attitudes.items():
        end = rest.recording.column("body_orientation", body)[-1]
        lies, rests = (axes(np.asarray(one))[2] for one in (attitude, end))
        if float(lies @ rests) < math.cos(_ELSEWHERE):
            return True
    return False
