"""Whether trolleys, cranes, upper structures and chain hoists stay within their ranges."""

from __future__ import annotations

import numpy as np

from gantline.checks.check import Check, Verdict
from gantline.results import series
from gantline.results.recording import Recording
from gantline.units import format_quantity

#: Rounding of a position at the end of its range, of the length of that [1].
_ROUNDING = 1e-9


def left_range(recording: Recording) -> list[Check]:
    """A failure for each of them that goes past an end of its range.

    The plan is refused where that is certain before a run; a step that ends at a time, or on a condition,
    goes as far as that takes, and no end stop holds what is driven.
    """
    checks = []
    during = series.everywhere(recording)
    for one in recording.rig.ranges:
        least, most = one.range
        place = recording.column("joint_position", one.joint)
        past = np.maximum(least - place, place - most)
        beyond = np.flatnonzero(during & (past > _ROUNDING * (most - least)))
        if not beyond.size:
            continue
        farthest = float(place[beyond][np.argmax(past[beyond])])
        unit, digits = ("deg", 1) if one.turns else ("m", 2)
        came, low, high = (format_quantity(value, unit, digits) for value in (farthest, least, most))
        time = float(recording.time[beyond[0]])
        remark = f"it comes to {came}, and its range is {low} to {high}"
        ways = "'by'" if one.pays_out else "'to' or 'by'"
        remark += f"; end the step by {ways}, or earlier"
        meaning = "trolleys, cranes, upper structures and chain hoists stay within their ranges"
        checks.append(
            Check("stays_in_range", Verdict.FAILED, meaning, element=one.name, time=time, remark=remark)
        )
    return checks
