"""How a run ended that did not get through its lift: where, why, and what to do next, in plain words.

A run that could not go on, was stopped, or ended before its plan shows less than it was asked for. Whoever
opens its recording has to read that first. The words are made from the recording alone, so that old ones have
them too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any, Final

import numpy as np

from gantline.results import progress, series
from gantline.results.recording import Recording
from gantline.results.stability import failure_of
from gantline.results.status import INCOMPLETE
from gantline.units import format_quantity

__all__ = ["ADVICE", "Ending", "ending_of", "waiting"]

#: What a step waits for that is no variable of recordings, and follows from slings.
_SPREAD: Final = "tension_spread"
_STIFF: Final = (
    "give what meets or goes taut there the stiffness and 'damping_time' that it really has, and look for "
    "masses and stiffnesses in a wrong unit; 'gantline run LIFT --integrator del --step 1ms' gets past what "
    "error control cannot follow, as a second look"
)
_FAST: Final = (
    "run it with '--integrator adaptive', or with a step a tenth as long; if it flies apart again, look for "
    "masses and stiffnesses in a wrong unit"
)
_TANGENT: Final = (
    "turn the drawing until rope and sheave are seen at the end: move the sheave or the end of the rope, or "
    "take it less far"
)
#: What to do next, by words of a cause: the core's, and those of `gantline.scenario.failed`.
ADVICE: Final = (
    (
        "it has capsized",
        "see heel and freeboard over the last minutes, and ask 'gantline statics LIFT --time' shortly before "
        "for the metacentric height; take weight down, fill or empty tanks wholly, or reach out less far",
    ),
    (
        "two-blocking",
        "end that step lower, hang the load in shorter slings, or take a crane with its sheaves higher up",
    ),
    (
        "the sling over it has run out",
        "look which rope below it parted or went slack before: a load hangs on an extension sheave only "
        "while both legs of the sling over it carry; give the load slings of its own if one may part",
    ),
    (
        "it has come to the next place that",
        "end the step of the plan before that, or give what moves a stop there",
    ),
    ("it is to be put on ", "lower the hook in a step before, or make the sling longer"),
    ("its pin cannot be put in", "let a hold before that step last until the sheave is at rest"),
    (
        "the equations are singular here",
        "look there for two inextensible ropes that do the same, or a part without mass: give one of the "
        "ropes an 'axial_stiffness', the part a mass",
    ),
    ("an open hinge", "open the hinge later, or turn its 'axis' as the cause says"),
    ("the step fell below", _STIFF),
    ("have led nowhere", _STIFF),
    ("a velocity is beyond that of light", _FAST),
    ("a velocity has passed all bounds", _FAST),
    (
        "there is no rope left between",
        "give the rope more length, or end the step of the plan that uses it up before that",
    ),
    ("its part ", _TANGENT),
    ("it has no length here", _TANGENT),
)
_ELSE: Final = "look at the last seconds in the player, and at what the lift file says of what is named here"
_ABOUT_WAITING: Final = (
    "look in the curves whether what it waits for comes nearer: then a longer 'duration' gets there; else "
    "what the step does cannot bring it about, or its 'until' is another than was meant"
)
_EMERGENCY: Final = "an emergency stop"
_WITHOUT_STOP: Final = (
    "look at what the stop does to the load and to the ropes; the lift without it has a verdict of its own"
)
_LONGER: Final = "give the lift a longer 'duration', or its steps less to do"
_AGAIN: Final = "run it again and let it come to its end"
_NOT_THERE: Final = "The run did not reach its end"
_HAPPENED: Final = {
    "failed": "the simulation could not go on",
    "ends": "the run was over",
    "stopped": "it was stopped from outside, as by Ctrl-C,",
    "paused": "the program that made it paused it",
    "running": "the recording was made while it was under way",
}


@dataclass(frozen=True)
class Ending:
    """How a run ended that did not get through its lift.

    Attributes:
        how: `failed`, `stopped`, `paused`, `running`, or `ends` of one that ended before its plan.
        time: When [s]; None of one without samples.
        recorded: Its last sample [s], after which nothing is known; None of one without samples.
        duration: How long it was to last [s]; None where the recording does not tell.
        steps: Steps that were under way.
        not_begun: Steps that it did not come to.
        element: The rope, body, contact or vessel at which it failed; empty if it belongs to none.
        cause: Likely cause of a failure, or why the plan was left; may be empty.
        advice: What to do next, in one sentence.
    """

    how: str
    time: float | None
    recorded: float | None
    duration: float | None
    steps: tuple[str, ...]
    not_begun: tuple[str, ...]
    element: str
    cause: str
    advice: str

    @property
    def head(self) -> str:
        """What is the matter, in a few words."""
        return "The plan was not finished" if self.how == "ends" else _NOT_THERE

    @property
    def up_to(self) -> str:
        """Up to when something is known, in words."""
        return _shown(self.recorded)

    @property
    def happened(self) -> str:
        """When it ended, of how long, in which step, at which element: one sentence without a full stop."""
        of = f" of {self.duration:g} s" if self.time and self.duration is not None else ""
        during = f", in '{progress.BESIDE.join(self.steps)}'" if self.steps else ""
        place = f", at {self.element}" if self.element else ""
        count = len(self.not_begun)
        left = f"; {count} more step{'' if count == 1 else 's'} of the plan not begun" if count else ""
        return f"{_HAPPENED[self.how]} at {_shown(self.time)}{of}{during}{place}{left}"

    @property
    def in_short(self) -> str:
        """The same in the few words that a curve has room for."""
        what = f"the run {INCOMPLETE.get(self.how, 'ends')}"
        if self.steps:
            return f"{what} in '{self.steps[0]}'"
        return f"{what} before '{self.not_begun[0]}'" if self.not_begun else f"{what} here"

    @property
    def no_go(self) -> str:
        """Why it cannot show a go, without a full stop."""
        return f"nothing after {self.up_to} has been looked at"

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        return asdict(self)


def ending_of(recording: Recording) -> Ending | None:
    """How a run ended that did not get through its lift; None of one that did, has not begun, or is at rest.

    Args:
        recording: Any recording.
    """
    status = str(recording.attributes.get("status", "done"))
    left = progress.unfinished(recording)
    if recording.is_equilibrium or not (status in INCOMPLETE or (status == "done" and left is not None)):
        return None
    how = status if status in INCOMPLETE else "ends"
    failure = failure_of(recording) if how == "failed" else None
    last = float(recording.time[-1]) if len(recording.time) else None
    cause = "" if failure is None else failure.cause
    if how == "ends":
        cause = _left_for(recording, left)
    return Ending(
        how=how,
        time=last if failure is None else failure.time,
        recorded=last,
        duration=_duration(recording),
        steps=(left.under_way if left else ()) or _under_way(recording, last),
        not_begun=left.not_begun if left else (),
        element="" if failure is None else failure.element,
        cause=cause,
        advice=_advice(how, cause),
    )


def waiting(recording: Recording, under_way: Sequence[str]) -> tuple[str, str]:
    """The first step that waits for something, and what for and how near that is; both empty if none does."""
    waits = [step for step in recording.rig.plan if step.step in under_way and step.until]
    if not waits:
        return "", ""
    step = waits[0]
    if not step.seen_by:
        return step.step, step.until
    variable, element, unit = step.seen_by
    known = recording.time >= progress.spans(recording)[step.step][0]
    if variable == _SPREAD:
        named = [one for one in recording.rig.equalizers if one.name in element.split()]
        equalizers = [one for one in named if one.slings]  # the lift file was checked: one of them has some
        known &= np.all([series.are_taut(recording, one) for one in equalizers], axis=0)
        values = np.max([series.tension_spread(recording, one) for one in equalizers], axis=0)[known]
    else:
        values = recording.column(variable, element)[known]
    if not values.size or not known[-1]:
        return step.step, step.until
    last, least, most = (format_quantity(one, unit, 2) for one in (values[-1], values.min(), values.max()))
    return step.step, f"{step.until}: {last} then, {least} to {most} since it began"


def _left_for(recording: Recording, left: progress.Unfinished | None) -> str:
    """Why a plan was left: an emergency stop ended it, or a step waits for something that did not come."""
    stopped = [time for time, _, _ in recording.events("emergency_stop")]
    if stopped:
        return f"{_EMERGENCY} at {stopped[0]:.4g} s ended the plan"
    step, what = ("", "") if left is None else waiting(recording, left.under_way)
    return f"'{step}' waits for {what}" if step else ""


def _advice(how: str, cause: str) -> str:
    if how == "ends" and cause.startswith(_EMERGENCY):
        return _WITHOUT_STOP
    if how == "ends":
        return _ABOUT_WAITING if cause else _LONGER
    if how != "failed":
        return _AGAIN
    return next((advice for words, advice in ADVICE if words in cause), _ELSE)


def _under_way(recording: Recording, time: float | None) -> tuple[str, ...]:
    """Steps that go at the end; where none does, those that ended with the run."""
    if time is None:
        return ()
    ends = {name: end for end, _, name in recording.events("step_end")}
    begun = [name for begin, _, name in recording.events("step_begin") if begin <= time]
    open_still = tuple(name for name in begun if name not in ends)
    return open_still or tuple(name for name in begun if ends[name] >= time)


def _duration(recording: Recording) -> float | None:
    found = (recording.attributes.get("settings") or {}).get("duration")
    return None if found is None else float(found)


def _shown(time: float | None) -> str:
    """A time [s] in words, with thousandths of what lasts no longer than seconds."""
    return (
        format_quantity(time, "s", 3 if time < 10.0 else 2)
        if time is not None and time >= 5e-4
        else "its start"
    )
