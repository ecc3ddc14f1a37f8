"""Heights of supports under a load at the start, as a yard cuts them."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gantline.assembly.doubts.supports import shown_gap
from gantline.assembly.loads.under_load import UnderLoad
from gantline.cli.table import show, table

__all__ = ["supports_table"]

#: Gaps and slopes that are not shown where all are less [m], [1].
_NO_GAP, _LEVEL = 5e-4, 0.01


def supports_table(under: Sequence[UnderLoad], base: str | None, width: int) -> list[str]:
    """Every support of the group that a load stands on; nothing where all touch it and it is level.

    Args:
        under: all supports, and where the load is over them.
        base: name of the group that it stands on; None where it stands on none.
        width: columns of text that a line may have.
    """
    own = [one for one in under if one.support.group == base]
    if all(one.gap is not None and abs(one.gap) < _NO_GAP and one.rise < _LEVEL for one in own):
        return []
    rows = [
        (
            one.support.name,
            *(show(float(part), "m", 2) for part in one.pad["at"][:2]),
            show(one.support.height, "m", 3),
            shown_gap(one.gap),
            "-" if one.gap is None else show(math.atan(one.rise), "deg", 1),
        )
        for one in own
    ]
    head = ("Support", "world x", "y", "height", "below the load", "which rises by")
    return table(head, rows, "lrrrrr", width)
