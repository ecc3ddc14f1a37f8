"""What keeps a load upright, as `gantline statics` shows it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gantline.study.tilting import Margin, TiltAxis, Tilting

#: Offset of the centre of gravity that the table speaks of [m].
_OFFSET = 0.1


def tilting_lines(
    found: Sequence[Tilting], margins: Sequence[Margin], untold: Sequence[str] = ()
) -> list[str]:
    """Tables of tilting and of margins, with what there is to say of them.

    Args:
        found: Of each load that hangs clear.
        margins: Of the centre of gravity; none if they were not asked for.
        untold: Loads that hang clear and of which nothing is known.
    """
    from gantline.cli.table import table

    head = ("Tilt", "about", "stiffness", "tilts as if hung at", "its weight", "the rig", "by 100 mm")
    rows = [_row(one, axis) for one in found for axis in (one.soft, one.stiff)]
    lines = table(head, rows, "llrrrrr") if rows else []
    for one in found:
        lines += _notes(one)
    lines += [
        f"How {name} tilts is not told: a centre of gravity that is off turns it about plumb, with no end"
        for name in untold
    ]
    if margins:
        from gantline.cli.table import show

        cells = [
            (
                margin.direction,
                show(margin.distance, "m", 3) if margin.cause else f"over {show(margin.distance, 'm', 0)}",
                margin.cause,
            )
            for margin in margins
        ]
        lines += ["", *table(("Centre of gravity moved", "margin", "then"), cells, "lrl")]
    return lines


def _row(one: Tilting, axis: TiltAxis) -> tuple[str, ...]:
    from gantline.cli.table import ABSENT, show
    from gantline.units import format_by_size

    x, y = (round(part, 2) + 0.0 for part in axis.direction)  # no negative zero
    by = show(math.atan2(_OFFSET, axis.height), "deg", 2) if axis.height > 0.0 else ABSENT
    return (
        one.load,
        f"({x:.2f}, {y:.2f}, 0)",
        _or_rigid(axis.stiffness, format_by_size(axis.stiffness, "rotational_stiffness")),
        *(_or_rigid(height, show(height, "m", 2)) for height in (axis.height, one.depth, axis.rig)),
        by,
    )


def _or_rigid(value: float, shown: str) -> str:
    return shown if math.isfinite(value) else "rigid"


def _notes(one: Tilting) -> list[str]:
    from gantline.cli.table import show

    period = show(one.period, "s", 2) if one.period is not None else "it does not swing"
    held = ""
    if one.loose is not None and one.period_on_lugs is not None:
        held = f"; by hand, with its lugs held, {show(one.period_on_lugs, 's', 2)}"
    lines = [f"  {one.load} tilts in {period}{held}"]
    if one.loose is not None:
        lines.append(f"  WARNING: {one.loose}")
    return lines
