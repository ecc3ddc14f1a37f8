"""How loads rest that a run hangs still in ropes of `mechanics`, in water, or with liquid in their tanks.

No recording knows the stiffness of these ropes, nor how a free surface takes from what keeps a load upright.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from gantline.results.loads.upright import borne_by_water, left_to_statics
from gantline.results.recording import Recording
from gantline.results.rig import Load, Resting
from gantline.results.rotation import axes
from gantline.statics.answers import Equilibrium, Mode, NoEquilibriumError
from gantline.statics.open_tanks import with_what_has_run

if TYPE_CHECKING:
    from gantline.statics.lift import Statics

__all__ = ["resting_loads"]

#: How far from where it hangs in a run a load may come to rest before the plan is asked where it does [rad].
_ELSEWHERE = math.radians(1.0)
#: Share of the largest motion of any body that a load has where a motion is one of its own, too [1].
_MOVES = 1e-3


def resting_loads(question: Statics, recording: Recording, state: bytes | None) -> dict[str, list[Resting]]:
    """How equilibria have loads whose slings do not tell how stably they hung; left out where there is none.

    Where the run ends it is asked from what it has saved, earlier by its plan.

    Args:
        question: The lift.
        recording: Of its run.
        state: What the run has saved at its last sample; None if it has not ended.
    """
    found: dict[str, list[Resting]] = {}
    loads = {load.name: load for load in recording.rig.loads}
    by_plan, in_water = left_to_statics(recording), borne_by_water(recording)
    for name in {**by_plan, **in_water}:
        for sample in sorted({*by_plan.get(name, ()), *in_water.get(name, ())}):
            is_last = sample == len(recording.time) - 1
            try:
                rests = _resting(question, recording, loads[name], sample, state if is_last else None)
            except NoEquilibriumError:
                continue
            if rests is not None and sample not in by_plan.get(name, ()):
                rests = replace(rests, aside=0.0)  # waves that a rest does not know turn it to and fro
            if rests is not None:
                found.setdefault(name, []).append(rests)
    return found


def _resting(
    question: Statics, recording: Recording, load: Load, sample: int, state: bytes | None
) -> Resting | None:
    """The same of one load at one sample; None where it comes to rest on its supports.

    What rounding has moved goes on downhill from what a run has saved: where it comes to rest elsewhere, the
    equilibrium of the plan tells whether it would have stayed.
    """
    rest = None if state is None else question.equilibrium_of(state, losses="none")
    time = float(recording.time[sample])
    if rest is None or (rest.is_stable and _aside(recording, rest, load, sample) > _ELSEWHERE):
        question = with_what_has_run(question, recording, sample)
        rest = question.equilibrium(min(time, question.scenario.duration))
    # Of contacts that slide freely, as here, the equilibrium lists none.
    if any(rest.recording.column("contact_force", one)[-1] > 0.0 for one in load.contacts):
        return None  # it leans on what it hung clear of: whether it would have stayed there nothing tells
    away = [] if rest.is_stable else [one for one in question.modes(rest.unstable) if _moves(one, load)]
    return Resting(
        time=time,
        leads_away=", ".join(dict.fromkeys(one.motion for one in away)),
        aside=_aside(recording, rest, load, sample),
    )


def _aside(recording: Recording, rest: Equilibrium, load: Load, sample: int) -> float:
    """Angle between a load's own z axis at a sample of a run and in an equilibrium [rad]."""
    hangs = axes(recording.column("body_orientation", load.body)[sample])[:, 2]
    rests = axes(rest.recording.column("body_orientation", load.body)[-1])[:, 2]
    return math.atan2(float(np.linalg.norm(np.cross(hangs, rests))), float(hangs @ rests))


def _moves(mode: Mode, load: Load) -> bool:
    """Whether a load takes part in a motion."""
    largest = float(np.abs(mode.body_motion).max())
    return float(np.abs(mode.of_body(load.body)).max()) > _MOVES * largest
