"""Figures of loads that are turned as they hang: upended, laid down or turned over.

How far the centre of gravity of such a load goes aside says little, since the hooks take it along as it
turns. What counts is how much each hook carries meanwhile, and at which tilt, and how far falls are from
plumb.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from gantline.results import series
from gantline.results.alike import first_peak
from gantline.results.progress import spans
from gantline.results.recording import Recording
from gantline.results.rig import Load
from gantline.results.variable import FloatArray
from gantline.units import format_quantity

__all__ = ["TURNED_FROM", "is_turned", "kept_plumb_in_words", "turning_in_words"]

#: Tilt of a hanging load from which it is turned on purpose [rad]; no load hangs so by mischance.
TURNED_FROM = math.radians(30.0)
#: What trolleys and cranes have done in steps of these kinds.
_WENT = {"traverse": "traversed", "travel": "travelled"}
#: Most hooks that are told one by one.
_MOST_HOOKS = 4


def is_turned(recording: Recording, load: Load) -> bool:
    """Whether a load tilts by so much as it hangs clear that it is turned."""
    clear = series.load_is_clear(recording, load) & series.everywhere(recording)
    return bool((recording.column("load_tilt", load.name)[clear] > TURNED_FROM).any())


def turning_in_words(recording: Recording, load: Load, *, in_t: bool) -> list[tuple[str, str]]:
    """Largest hook loads and falls out of plumb of a load that is turned, while it is clear.

    Args:
        recording: The recording.
        load: A load that comes clear.
        in_t: Whether hook loads are in t, as load cells show them, else in kN.

    Returns:
        What, and how much, in words.
    """
    during = series.load_is_clear(recording, load) & series.everywhere(recording)
    tilt = recording.column("load_tilt", load.name)

    def row(what: str, hook: str, values: FloatArray, unit: str, digits: int) -> tuple[str, str]:
        at = first_peak(np.where(during, values, -np.inf))
        most = f"{hook} {format_quantity(float(values[at]), unit, digits)} at most"
        when = f"at {format_quantity(float(recording.time[at]), 's', 1)}"
        return what, f"{most}, {when}, tilted by {format_quantity(float(tilt[at]), 'deg', 1)}"

    unit, per_shown = ("t", recording.rig.gravity) if in_t else ("kN", 1.0)
    hooks = recording.coordinates.get("hook", ())
    rows = [
        row("hook load when clear", hook, recording.column("hook_load", hook) / per_shown, unit, 1)
        for hook in (hooks if len(hooks) <= _MOST_HOOKS else ())
    ]
    crane_hooks = recording.coordinates.get("crane_hook", ())
    aside = {hook: recording.column("falls_out_of_plumb", hook) for hook in crane_hooks}
    if aside:
        peaks = [float(one[during].max()) for one in aside.values()]
        worst = list(aside)[first_peak(peaks)]
        rows.append(row("falls out of plumb", worst, aside[worst], "deg", 2))
    return rows


def kept_plumb_in_words(recording: Recording) -> list[tuple[str, str]]:
    """How far out of plumb the falls of each hook came in the steps that keep them plumb, and what booms did.

    Args:
        recording: The recording.

    Returns:
        What, and how much, in words; nothing of a lift at rest, which knows no way there.
    """
    if recording.is_equilibrium:
        return []
    during = spans(recording)
    farthest: dict[str, tuple[float, float, str]] = {}
    for step in recording.rig.plan:
        if not step.keep_plumb or step.step not in during:
            continue
        begin, end = during[step.step]
        goes_on = (recording.time >= begin) & (recording.time <= end)
        for hook in step.keep_plumb:
            aside = np.where(goes_on, recording.column("falls_out_of_plumb", hook), 0.0)
            at = first_peak(aside)
            found = (float(aside[at]), float(recording.time[at]), step.step)
            farthest[hook] = max(farthest.get(hook, found), found)
    rows = [
        (
            "falls kept plumb",
            f"{hook} within {format_quantity(most, 'deg', 2)}, farthest in '{step}' at "
            f"{format_quantity(time, 's', 1)}",
        )
        for hook, (most, time, step) in farthest.items()
    ]
    return rows + _went_in_words(recording) + _luffed_in_words(recording)


def _went_in_words(recording: Recording) -> list[tuple[str, str]]:
    """From where to where trolleys and cranes went that kept falls plumb, and how fast at most."""
    during = spans(recording)
    times: dict[tuple[str, str], list[tuple[float, float]]] = {}
    for step in recording.rig.plan:
        if not step.keep_plumb or step.kind not in _WENT or step.step not in during:
            continue
        for drive in step.drives:
            what = (_WENT[step.kind], drive.removesuffix(".along"))
            times.setdefault(what, []).append(during[step.step])
    rows = []
    for (went, name), spells in times.items():
        # A crawler crane goes along in a joint of its own, since it settles on its tracks too.
        joint = name if name in recording.coordinates["joint"] else f"{name}/along"
        within = (recording.time >= spells[0][0]) & (recording.time <= spells[-1][1])
        place, time = recording.column("joint_position", joint)[within], recording.time[within]
        if time.size < 2:
            continue
        fastest = float(np.abs(np.diff(place) / np.diff(time)).max())
        first, last = (format_quantity(float(one), "m", 2) for one in place[[0, -1]])
        most = format_quantity(fastest, "m/min", 1)
        rows.append((f"{went} to keep plumb", f"{name} from {first} to {last}, at {most} at most"))
    return rows


def _luffed_in_words(recording: Recording) -> list[tuple[str, str]]:
    """From where to where booms luffed that kept falls plumb, and how high their hooks were then."""
    during = spans(recording)
    followed = [one for one in recording.rig.plan if one.kind == "luff" and one.keep_plumb]
    rows = []
    for boom in recording.rig.booms:
        hooks = [hook.name for hook in boom.hooks]
        times = [
            during[one.step] for one in followed if one.step in during and set(hooks) & set(one.keep_plumb)
        ]
        if not times:
            continue
        ends = np.searchsorted(recording.time, (times[0][0], times[-1][1])).clip(max=recording.time.size - 1)

        def went(values: FloatArray, unit: str, ends: npt.NDArray[np.intp] = ends) -> str:
            first, last = (format_quantity(float(value), unit, 1) for value in values[ends])
            return f"{first} to {last}"

        luffed = f"{boom.name} from {went(recording.column('boom_angle', boom.name), 'deg')}"
        heights = [f"{hook} {went(recording.column('hook_height', hook), 'm')} high" for hook in hooks]
        rows.append(("luffed to keep plumb", ", ".join([luffed, *heights[:_MOST_HOOKS]])))
    return rows
