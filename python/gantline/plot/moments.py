"""The times at which a lift is worth drawing."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

import numpy as np

from gantline.results import series
from gantline.results.loads.hinges import HINGE_OPENED
from gantline.results.loads.lift_off import hangs_from_the_start, lift_off_time
from gantline.results.loads.upending import is_turned
from gantline.results.recording import Recording
from gantline.results.status import INCOMPLETE
from gantline.units import format_quantity

#: Most stages of a lift that one picture shows.
_STAGES = 6


class Moment(NamedTuple):
    """What is worth a picture.

    Attributes:
        name: What happens; empty where nothing does.
        sample: The sample that is drawn: the first that is not before it.
        time: When it happens, which may be a sample interval before that [s].
    """

    name: str
    sample: int
    time: float


def moments(recording: Recording, of: Collection[str] = ()) -> list[Moment]:
    """Each moment in order: start, slings taut, lift-off, peak, end.

    A load that hangs from the start on has no lift-off, but may have a set-down.

    A system without slings is shown at start and end and twice between. Moments that fall on one sample are
    shown once.

    Args:
        recording: Any recording.
        of: Ropes of the slings that come taut and have the peak; all of them where it is empty.

    Returns:
        At least one moment.
    """
    end = float(recording.time[-1])
    slings = set(of) or {sling.rope for sling in recording.rig.slings}
    times: list[tuple[str, float | None]]
    if slings:
        peak = max(series.rope_peak(recording, rope) for rope in slings)[1]
        times = [
            ("slings taut", _all_taut(recording, slings, peak)),
            ("lift-off", lift_off_time(recording)),
            ("set-down", _set_down(recording)),
            ("peak tension", peak),
        ]
    else:
        start = float(recording.time[0])
        times = [("", start + (end - start) / 3.0), ("", start + 2.0 * (end - start) / 3.0)]
    named = [("start", float(recording.time[0])), *times, ("end", end)]
    taken: dict[int, Moment] = {}
    for name, time in named:
        if time is not None:
            found = _moment(recording, name, time)
            taken.setdefault(found.sample, found)
    return [taken[sample] for sample in sorted(taken)]


def stages(recording: Recording) -> list[Moment]:
    """Up to six stages: start, slings taut, lift-off or set-down, ends of the last steps that move something.

    Steps side by side are one stage, under the name of the first of them. A load that is turned as it hangs
    is shown at a third and at two thirds of its turn as well; one whose hinge opens as that does, and not as
    its slings come taut, when it lies as at the start. A run that broke off is shown where it did, too: there
    something went wrong.

    Args:
        recording: Any recording.

    Returns:
        Each in order; fewer than four where the plan does little after the load is clear.
    """
    clear_from = 0.0 if _hang(recording) else lift_off_time(recording)
    opened = [_moment(recording, f"{name} opens", time) for time, _, name in recording.events(HINGE_OPENED)]
    broke_off = recording.attributes.get("status") in INCOMPLETE
    ended = [_moment(recording, "end", float(recording.time[-1]))] if broke_off else []
    left_out = {"peak tension", "end", *(("slings taut",) if opened else ())}
    known = [one for one in moments(recording) if one.name not in left_out] + opened + ended
    known += _turning(recording)[: _STAGES - 1 - len(known)]
    after = [
        _moment(recording, f"end of '{name}'", time)
        for time, name in _motions(recording)
        if clear_from is not None and time > clear_from
    ]
    shown = known + after[-(_STAGES - len(known)) :]
    # A set-down may come after the ends of some steps, which all others come before.
    return sorted(shown, key=lambda one: one.sample)


def _hang(recording: Recording) -> bool:
    """Whether all loads hang as the recording begins."""
    loads = recording.rig.loads
    return bool(loads) and all(hangs_from_the_start(recording, load) for load in loads)


def _turning(recording: Recording) -> list[Moment]:
    """Where the first load that is turned has come a third and two thirds of the way."""
    for load in recording.rig.loads:
        if not is_turned(recording, load):
            continue
        clear = series.load_is_clear(recording, load)
        tilt = recording.column("load_tilt", load.name)
        turned = np.where(clear, np.abs(tilt - tilt[np.argmax(clear)]), 0.0)
        samples = [int(np.argmax(turned >= share * turned.max())) for share in (1 / 3, 2 / 3)]
        names = [f"tilted by {format_quantity(float(tilt[at]), 'deg', 0)}" for at in samples]
        return [Moment(name, at, float(recording.time[at])) for name, at in zip(names, samples, strict=True)]
    return []


def _set_down(recording: Recording) -> float | None:
    """When loads that hang from the start on first stand [s]; None if they do not, or never do."""
    if not _hang(recording):
        return None
    # Fenders touch too, and from the start on.
    names = {name for load in recording.rig.loads for name in (load.name, load.body, load.contact_group)}
    return min((time for time, _, name in recording.events("set_down") if name in names), default=None)


def _motions(recording: Recording) -> list[tuple[float, str]]:
    """When each motion of the plan ends [s], with all steps side by side, and the name of its first step."""
    moving = {step.step for step in recording.rig.plan if step.kind != "hold"}
    begun = [(time, 1, name) for time, _, name in recording.events("step_begin") if name in moving]
    done = [(time, 0, name) for time, _, name in recording.events("step_end") if name in moving]
    found: list[tuple[float, str]] = []
    first, going = "", 0
    for time, begins, name in sorted(begun + done, key=lambda one: one[:2]):
        if not going:
            first = name
        going += 1 if begins else -1
        if not going:
            found.append((time, first))
    return found


def _all_taut(recording: Recording, slings: set[str], peak: float) -> float | None:
    """When the last sling began to carry before the peak [s]; None if all always did or one never did."""
    tensions = [recording.column("rope_tension", rope) for rope in slings]
    # However little they carry: of what the peak has a hundredth comes long after a sling is taut.
    taut = np.all([tension > 0.0 for tension in tensions], axis=0)
    before = np.flatnonzero(~taut & (recording.time < peak))
    if not before.size or before[-1] + 1 >= len(taut) or recording.time[before[-1] + 1] >= peak:
        return None
    # The last may have been slack once more between two samples.
    last, found = recording.time[before[-1] : before[-1] + 2]
    began = [time for time, _, name in recording.events("taut") if name in slings and last <= time < peak]
    return max(began, default=float(found))


def _moment(recording: Recording, name: str, time: float) -> Moment:
    return Moment(name, min(int(np.searchsorted(recording.time, time)), len(recording.time) - 1), time)
