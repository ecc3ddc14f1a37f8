"""How vessels lie, and how stable they are at rest, as tables."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from gantline.cli.table import table
from gantline.results import series
from gantline.results.recording import Recording
from gantline.units import format_quantity

if TYPE_CHECKING:
    from gantline.statics import Equilibrium, Statics
    from gantline.study.inclining import MetacentricHeights

#: Of a vessel at its last sample: variable, title, unit, decimals.
_LIES = (
    ("vessel_displacement", "displacement", "t", 1),
    ("vessel_draft_aft", "draft aft", "m", 3),
    ("vessel_draft_forward", "forward", "m", 3),
    ("vessel_heel", "heel to starboard", "deg", 3),
    ("vessel_trim", "trim by the stern", "deg", 3),
)


def vessels(recording: Recording) -> list[str]:
    """How each vessel lies at the last sample, and its least freeboard, at rest that there."""
    rows = []
    for vessel in recording.rig.vessels:
        at_end = [
            format_quantity(float(recording.column(name, vessel.name)[-1]), unit, digits)
            for name, _, unit, digits in _LIES
        ]
        freeboard = recording.column("vessel_freeboard", vessel.name)
        if series.is_equilibrium(recording):
            freeboard = freeboard[-1:]
        rows.append((vessel.name, *at_end, format_quantity(float(freeboard.min()), "m", 3)))
    head = ("Vessel", *(title for _, title, _, _ in _LIES), "least freeboard")
    return table(head, rows, "l" + "r" * (len(head) - 1)) if rows else []


def vessels_at_rest(question: Statics, rest: Equilibrium) -> list[str]:
    """How each vessel lies at rest, and what rights it."""
    from gantline.study.inclining import metacentric_heights

    lies = vessels(rest.recording)
    if not lies:
        return []
    return [*lies, "", *righting(metacentric_heights(question, rest))]


def righting(heights: Mapping[str, MetacentricHeights]) -> list[str]:
    """What rights each vessel."""
    rows = [
        (name, *(format_quantity(height, "m", 2) for height in (found.transverse, found.longitudinal)))
        for name, found in heights.items()
    ]
    return table(("Righting", "GM transverse, with free surfaces", "longitudinal"), rows, "lrr")
