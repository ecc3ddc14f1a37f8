"""How far a run got through its plan: when its steps went, and what is left of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gantline.results.recording import Recording
from gantline.results.rig import Step

__all__ = ["BESIDE", "Stretch", "Unfinished", "end_of_step", "spans", "stretches", "under_way", "unfinished"]

#: Rounding of the end of a hold [s].
_ROUNDING = 1e-9
#: Between the names of steps that go side by side.
BESIDE = " + "


@dataclass(frozen=True)
class Stretch:
    """A time in which a step went, or several side by side.

    Attributes:
        names: Of the steps, those under way as it begins, in the order in which they began.
        begin: When the last of them began [s].
        end: When all of them had ended, others began, or the run ended [s].
    """

    names: tuple[str, ...]
    begin: float
    end: float

    @property
    def name(self) -> str:
        """All names in one."""
        return BESIDE.join(self.names)


@dataclass(frozen=True)
class Unfinished:
    """What a run left of its plan.

    Attributes:
        under_way: Steps in which it ended.
        not_begun: Steps that it did not come to.
    """

    under_way: tuple[str, ...]
    not_begun: tuple[str, ...]


def spans(recording: Recording) -> dict[str, tuple[float, float]]:
    """When each step that began did so, and when it ended or the run did [s], in the order of begins."""
    if not len(recording.time):
        return {}
    last = float(recording.time[-1])
    ended = {name: time for time, _, name in recording.events("step_end")}
    return {name: (time, ended.get(name, last)) for time, _, name in recording.events("step_begin")}


def stretches(recording: Recording) -> list[Stretch]:
    """When the steps of the plan went, in order; between them, and after the last, nothing was under way."""
    known = spans(recording)
    begins = list(dict.fromkeys(begin for begin, _ in known.values()))
    found: list[Stretch] = []
    for begin, until in zip(begins, [*begins[1:], np.inf], strict=False):
        names = [name for name, (start, end) in known.items() if start <= begin < end]
        end = min(until, max((known[name][1] for name in names), default=begin))
        if end > begin:
            found.append(Stretch(tuple(names), begin, end))
    return found


def under_way(recording: Recording, time: float) -> str:
    """Names of the steps that go at a time [s], in one; empty where none does."""
    ended = {name for end, _, name in recording.events("step_end") if end <= time}
    begun = [name for begin, _, name in recording.events("step_begin") if begin <= time]
    return BESIDE.join(name for name in begun if name not in ended)


def end_of_step(recording: Recording, step: Step) -> float | None:
    """When a step of the plan ended [s]; None if it did not within the recording.

    One that holds until the end of the run, or for a time that is over then, ends with a run that was done.
    """
    ends = [time for time, _, name in recording.events("step_end") if name == step.step]
    if ends:
        return ends[0]
    begins = [time for time, _, name in recording.events("step_begin") if name == step.step]
    if not begins or recording.attributes.get("status") != "done" or not len(recording.time):
        return None
    last = float(recording.time[-1])
    is_over = step.lasts is not None and begins[0] + step.lasts <= last + _ROUNDING
    return last if is_over or step.hold_until == "end" else None


def unfinished(recording: Recording) -> Unfinished | None:
    """What is left of the plan at the end of a run; None if nothing is.

    A hold that is under way has nothing left to do, unless it waits for a condition or requires something
    at its end; any other step has.
    """
    begun = {name for _, _, name in recording.events("step_begin")}
    plan = recording.rig.plan
    left = tuple(step.step for step in plan if step.step not in begun)
    not_over = [step for step in plan if step.step in begun and end_of_step(recording, step) is None]
    under_way = tuple(
        step.step for step in not_over if step.kind != "hold" or step.hold_until == "met" or step.require
    )
    return Unfinished(under_way, left) if (left or under_way) and len(recording.time) else None
