"""Tuggers of constant pull that a load leaves behind, so that their lines hold it no longer."""

from __future__ import annotations

from gantline.checks.check import Check, Verdict
from gantline.results import series
from gantline.results.recording import Recording
from gantline.results.tag_lines import TagLine
from gantline.results.variable import BoolArray
from gantline.units import format_quantity

#: Share of its pull below which a line holds little [1].
_KEPT = 0.5
#: A line that holds little for longer is told [s]: a swing or the start of a step is over sooner.
_LONG = 1.0


def left_behind(recording: Recording) -> list[Check]:
    """A warning for each line of constant pull that pulls less than half of that while its load hangs clear.

    It hauls in no faster than its `speed`: a load that comes faster leaves it slack, and turns as it likes.
    """
    if recording.is_equilibrium:
        return []
    clear = series.is_clear(recording)
    found = (_left_behind(recording, line, clear) for line in recording.rig.tag_lines)
    return [check for check in found if check is not None]


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
