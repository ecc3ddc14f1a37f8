"""Cells that say how much of a limit is used: their shades, and what these say."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap, to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Rectangle

from gantline.plot.style import COLOURS, FAINT, INK, QUIET

__all__ = ["CELL", "Look", "columns_and_rows", "draw_cell", "legend"]

#: Of a cell [inch].
CELL = (0.62, 0.36)
#: Shades of what is used of a limit, from nothing to all of it; darker ones would swallow the letters.
_SHADES = LinearSegmentedColormap.from_list("used", ["#F2F7FB", "#7DB4DC"])
#: Shades of whatever keeps no limit for sure.
_OTHERS = {
    "failed": COLOURS[1],
    "warns": "#F2C879",
    "unknown": "#F3E3B3",
    "missing": "#F4F4F4",
    "none": "white",
}


@dataclass(frozen=True)
class Look:
    """What a cell says.

    Attributes:
        kind: `kept`, `failed`, `warns`, `unknown`, `missing`, or `none` for what cannot be.
        text: What stands in it.
        used: Share of the limit that is used [1]; of one that is kept.
    """

    kind: str
    text: str
    used: float = 0.0

    @property
    def shade(self) -> str:
        """Colour of the cell."""
        if self.kind == "kept":
            return to_hex(_SHADES(min(self.used, 1.0)), keep_alpha=True)
        return _OTHERS[self.kind]


def draw_cell(field: Axes, column: int, row: int, look: Look) -> None:
    """Draw a cell of a field whose cells are squares of 1."""
    hatch = "////" if look.kind == "none" else None
    edge = FAINT if hatch else "white"
    place = Rectangle((column, row), 1, 1, facecolor=look.shade, edgecolor=edge, linewidth=1.2, hatch=hatch)
    field.add_patch(place)
    ink = {"failed": "white", "missing": QUIET}.get(look.kind, INK)
    weight = "bold" if look.kind == "failed" else "normal"
    middle = (column + 0.5, row + 0.5)
    field.text(*middle, look.text, ha="center", va="center", fontsize=8, color=ink, fontweight=weight)


def columns_and_rows(field: Axes, columns: Sequence[str], rows: Sequence[str]) -> None:
    """Name columns and rows of a field, the lowest row first."""
    field.set_xlim(0, len(columns))
    field.set_ylim(0, max(1, len(rows)))
    field.set_xticks(np.arange(len(columns)) + 0.5, columns)
    field.set_yticks(np.arange(len(rows)) + 0.5, rows)
    field.tick_params(length=0)
    field.grid(visible=False)
    for spine in field.spines.values():
        spine.set_visible(False)


def legend(figure: Figure, kinds: Mapping[str, str]) -> None:
    """Say below a picture what the shades of these kinds mean."""
    keys = [
        Patch(
            facecolor=Look(kind, "", 0.8).shade,
            edgecolor=FAINT if kind in ("none", "missing") else None,
            hatch="////" if kind == "none" else None,
        )
        for kind in kinds
    ]
    texts = list(kinds.values())
    figure.legend(
        keys,
        texts,
        loc="outside lower left",
        ncols=len(keys),
        fontsize=8,
        handlelength=1.4,
        columnspacing=1.4,
    )
