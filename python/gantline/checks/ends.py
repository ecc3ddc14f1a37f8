"""The samples about the end of a step of the plan."""

from __future__ import annotations

import numpy as np

from gantline.results import progress
from gantline.results.recording import Recording
from gantline.results.rig import Step
from gantline.results.ropes.parting import partings
from gantline.results.variable import BoolArray, FloatArray

__all__ = ["about_end_of_step", "end_of_step", "one_sample", "second_half_of_hold"]

#: Rounding of the time of an event [s].
_ROUNDING = 1e-9


def end_of_step(recording: Recording, step: Step) -> BoolArray | None:
    """The last sample of a step of the plan.

    Args:
        recording: Any recording.
        step: The step.

    Returns:
        Mask with that one sample; None if the step did not end within the recording.
    """
    end = progress.end_of_step(recording, step)
    if end is None or not len(recording.time):
        return None
    last = max(0, int(np.searchsorted(recording.time, end + _ROUNDING, side="right")) - 1)
    return one_sample(last, recording.time)


def about_end_of_step(recording: Recording, step: Step) -> BoolArray | None:
    """Samples that a requirement of a step is for, of which the unfavourable one counts.

    The last one, and where the step ends between two samples the next: the end lies between them. Not the
    next where something parts, comes or goes meanwhile, which is not of this step. In waves and gusts there
    are those before it too over which these average: the last is but a moment between a crest and a trough.
    """
    found = end_of_step(recording, step)
    if found is None:
        return None
    last = int(np.argmax(found))
    while_ = recording.rig.time_to_average
    if while_:
        begin, end = progress.spans(recording)[step.step][0], recording.time[last]
        found = (recording.time >= max(begin, end - while_)) & (recording.time <= end)
    if _goes_on(recording, step, last):
        found[last + 1] = True
    return found


def second_half_of_hold(recording: Recording, step: Step) -> BoolArray | None:
    """The samples of the second half of a hold, in which what swings goes through plumb and back.

    None of other steps, of holds that did not end, and in waves and gusts, where requirements look back.
    """
    found = (
        end_of_step(recording, step) if step.kind == "hold" and not recording.rig.time_to_average else None
    )
    if found is None or recording.is_equilibrium:
        return None
    begin, end = progress.spans(recording)[step.step][0], float(recording.time[int(np.argmax(found))])
    return (recording.time >= (begin + end) / 2) & (recording.time <= end)


def one_sample(at: int, like: BoolArray | FloatArray) -> BoolArray:
    """A mask of one sample, as long as something else."""
    mask = np.zeros(len(like), dtype=np.bool_)
    mask[at] = True
    return mask


def _goes_on(recording: Recording, step: Step, last: int) -> bool:
    """Whether a step ends between two samples, and nothing changes at once from there to the second."""
    end = progress.end_of_step(recording, step)
    time = recording.time
    if end is None or last + 1 >= len(time) or end <= time[last] + _ROUNDING:
        return False
    spans = progress.spans(recording)
    begin = {one.step: spans[one.step][0] for one in recording.rig.plan if one.step in spans}
    moments = [begin[one.step] for one in recording.rig.plan if one.step in begin and _changes_at_once(one)]
    moments += [one.time for one in partings(recording)]
    moments += [one.removed_at for one in recording.rig.supports if one.removed_at is not None]
    return not any(end - _ROUNDING <= moment <= time[last + 1] for moment in moments)


def _changes_at_once(step: Step) -> bool:
    """Whether something parts, comes or goes as a step begins."""
    return any(
        (
            step.cut,
            step.detach,
            step.attach,
            step.remove_supports,
            step.pull_pins,
            step.put_in_pins,
            step.open_hinges,
        )
    )
