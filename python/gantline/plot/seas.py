"""The seas in which a lift keeps its limits: a field for each direction, heights over periods."""

from __future__ import annotations

import math

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from gantline.plot.cells import CELL, Look, columns_and_rows, draw_cell, legend
from gantline.plot.style import INK, RC, shortened
from gantline.results.file.saved_seas import SavedSea, SavedSeas, degrees

__all__ = ["seas_picture"]

#: Most fields beside each other.
_ACROSS = 3
#: Of what stands around a field [inch].
_AROUND = (0.95, 0.75)
_NARROWEST = 6.4


def seas_picture(found: SavedSeas) -> Figure:
    """The picture: what is used of the limit that is nearest, and where the lift is no go."""
    directions = found.directions
    down = math.ceil(len(directions) / _ACROSS)
    across = math.ceil(len(directions) / down)
    width = max(_NARROWEST, across * (_AROUND[0] + CELL[0] * len(found.periods)))
    height = 1.0 + down * (_AROUND[1] + CELL[1] * len(found.heights))
    with mpl.rc_context(RC):
        figure = Figure(figsize=(width, height))
        figure.set_layout_engine(ConstrainedLayoutEngine(h_pad=0.06, w_pad=0.08))
        fields = figure.subplots(down, across, squeeze=False).ravel()
        for field, direction in zip(fields, directions, strict=False):
            _field(field, found, direction)
        for field in fields[len(directions) :]:
            field.set_axis_off()
        for place, field in enumerate(fields[: len(directions)]):
            if place % across == 0:
                field.set_ylabel("Height [m]" if found.is_regular else "Significant height [m]")
            if place + across >= len(directions):
                field.set_xlabel("Period [s]" if found.is_regular else "Peak period [s]")
        title = f"Where the lift keeps its limits: waves '{shortened(found.waves, 30)}'"
        figure.suptitle(title, x=0.01, ha="left", fontsize=11, fontweight="bold")
        _legend(figure, found)
    return figure


def _field(field: Axes, found: SavedSeas, direction: float) -> None:
    """Seas of one direction, and a line above the heights that are allowed."""
    periods, heights = found.periods, found.heights
    for column, period in enumerate(periods):
        allowed = found.allowed[direction, period]
        for row, sea in enumerate(found.of(direction, period)):
            draw_cell(field, column, row, _look(sea))
            if sea.height == allowed:
                field.plot([column, column + 1], [row + 1, row + 1], color=INK, linewidth=2.4, zorder=3)
    columns_and_rows(field, [f"{period:g}" for period in periods], [f"{height:g}" for height in heights])
    field.set_title(f"towards {degrees(direction)}", fontsize=9.5, loc="left", color=INK)


def _look(sea: SavedSea) -> Look:
    """What its cell says."""
    if sea.is_too_steep:
        return Look("none", "")
    if not sea.is_run:
        return Look("missing", "–")
    if sea.only_warns:
        return Look("warns", sea.share)
    if sea.is_allowed:
        return Look("kept", sea.share, sea.used or 0.0)
    kind = "failed" if sea.has_verdict and sea.starts else "unknown"
    return Look(kind, sea.share or sea.told.lower())


def _legend(figure: Figure, found: SavedSeas) -> None:
    """What the shades say, of those that there are."""
    said = {
        "warns": "is past one that only warns",
        "failed": "does not",
        "unknown": "not known",
        "missing": "not run",
        "none": "no such waves",
    }
    there = {_look(sea).kind for sea in found.seas}
    kept = {"kept": "keeps its limits: share of the nearest that is used"}
    legend(figure, kept | {kind: text for kind, text in said.items() if kind in there})
