"""Tag lines that hold nothing: tuggers that a load leaves behind, lines that are made fast too long."""

from __future__ import annotations

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.checks.measure import named
from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.ropes.tag_lines import TagLine
from gantline.results.variable import BoolArray
from gantline.units import format_quantity

#: Share of its pull below which a line holds little [1].
_KEPT = 0.5
#: A line that holds little for longer is told [s]: a swing or the start of a step is over sooner.
_LONG = 1.0
#: A load that turns by less has not shown that lines which are slack do not hold it [rad].
_TURNS = np.radians(10.0)


def left_behind(recording: Recording) -> list[Check]:
    """A warning for each line of constant pull that pulls less than half of that while its load hangs clear.

    It hauls in no faster than its `speed`: a load that comes faster leaves it slack, and turns as it likes.
    """
    if recording.is_equilibrium:
        return []
    clear = series.is_clear(recording)
    found = (_left_behind(recording, line, clear) for line in recording.rig.tag_lines)
    return [check for check in found if check is not None]


def never_taut(recording: Recording) -> list[Check]:
    """A warning for lines that are made fast and never pull while the load hangs clear and turns."""
    if recording.is_equilibrium:
        return []
    clear = series.is_clear(recording)
    turned = _turned(recording, clear)
    if turned < _TURNS:
        return []
    slack = [
        line.name
        for line in recording.rig.tag_lines
        if line.pull is None and _is_slack(recording, line, clear)
    ]
    if not slack:
        return []
    by = format_quantity(turned, "deg", 0)
    remark = f"slack all the time that the load hangs clear, and turns by {by}: made fast too long to hold it"
    meaning = "tag lines that are made fast pull at some time while the load hangs clear"
    return [Check("tag_lines_pull", Verdict.WARNING, meaning, element=named(slack), remark=remark)]


def _turned(recording: Recording, clear: BoolArray) -> float:
    """By how much a load changes its heading while it hangs clear [rad]; 0 of one turned over."""
    yaws = [series.load_yaw(recording, load) for load in recording.rig.loads]
    return max((float(np.ptp(yaw[clear])) for yaw in yaws if yaw is not None and clear.any()), default=0.0)


def _is_slack(recording: Recording, line: TagLine, clear: BoolArray) -> bool:
    """Whether a line is there while the load hangs clear, and never taut then."""
    counts = clear & series.are_whole(recording, [line.rope])[0]
    tension = recording.column("rope_tension", line.rope)[counts]
    return bool(tension.size) and not tension.any()


def _left_behind(recording: Recording, line: TagLine, clear: BoolArray) -> Check | None:
    if line.pull is None or line.speed is None:
        return None
    time, tension = recording.time, recording.column("rope_tension", line.rope)
    whole = series.are_whole(recording, [line.rope])[0]
    is_weak = clear & whole & (tension < _KEPT * line.pull)
    spans = [time[stretch][[0, -1]] for stretch in series.stretches(is_weak)]
    begin, end = max(spans, key=lambda span: span[1] - span[0], default=(0.0, 0.0))
    if end - begin <= _LONG:
        return None
    least = float(tension[(time >= begin) & (time <= end)].min())
    pulls = "is slack at times" if least == 0.0 else f"pulls {format_quantity(least, 'kN', 2)} at least"
    speed = format_quantity(line.speed, "m/min", 1)
    remark = (
        f"for {end - begin:.3g} s it pulls less than half of {format_quantity(line.pull, 'kN', 2)}, and "
        f"{pulls}: its tugger hauls in at {speed} at most, and the load comes faster"
    )
    meaning = "tuggers keep the pull of their lines while the load hangs clear"
    return Check(
        "tag_lines_pull", Verdict.WARNING, meaning, element=line.name, time=float(begin), remark=remark
    )
