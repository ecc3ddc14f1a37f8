"""The seas in which a lift keeps its limits: a field for each direction, heights over periods."""

from __future__ import annotations

import math

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.patches import Patch, Rectangle

from gantline.plot.style import COLOURS, FAINT, INK, QUIET, RC, shortened
from gantline.results.file.saved_seas import SavedSea, SavedSeas, degrees

__all__ = ["seas_picture"]

#: Most fields beside each other.
_ACROSS = 3
#: Of a cell, and of what stands around a field [inch].
_CELL = (0.62, 0.36)
_AROUND = (0.95, 0.75)
_NARROWEST = 6.4
#: Shades of what is used of a limit, from nothing to all of it; darker ones would swallow the letters.
_SHADES = LinearSegmentedColormap.from_list("used", ["#F2F7FB", "#7DB4DC"])
_FAILED, _WARNS, _UNKNOWN = COLOURS[1], "#F2C879", "#F3E3B3"


def seas_picture(found: SavedSeas) -> Figure:
    """The picture: what is used of the limit that is nearest, and where the lift is no go."""
    directions = found.directions
    down = math.ceil(len(directions) / _ACROSS)
    across = math.ceil(len(directions) / down)
    width = max(_NARROWEST, across * (_AROUND[0] + _CELL[0] * len(found.periods)))
    height = 1.0 + down * (_AROUND[1] + _CELL[1] * len(found.heights))
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
            _cell(field, column, row, sea)
            if sea.height == allowed:
                field.plot([column, column + 1], [row + 1, row + 1], color=INK, linewidth=2.4, zorder=3)
    field.set_xlim(0, len(periods))
    field.set_ylim(0, len(heights))
    field.set_xticks(np.arange(len(periods)) + 0.5, [f"{period:g}" for period in periods])
    field.set_yticks(np.arange(len(heights)) + 0.5, [f"{height:g}" for height in heights])
    field.tick_params(length=0)
    field.grid(visible=False)
    for spine in field.spines.values():
        spine.set_visible(False)
    field.set_title(f"towards {degrees(direction)}", fontsize=9.5, loc="left", color=INK)


def _cell(field: Axes, column: int, row: int, sea: SavedSea) -> None:
    shade, text, ink, weight = _look(sea)
    hatch = "////" if sea.is_too_steep else None
    place = Rectangle(
        (column, row),
        1,
        1,
        facecolor=shade,
        edgecolor=FAINT if hatch else "white",
        linewidth=1.2,
        hatch=hatch,
    )
    field.add_patch(place)
    field.text(
        column + 0.5, row + 0.5, text, ha="center", va="center", fontsize=8, color=ink, fontweight=weight
    )


def _look(sea: SavedSea) -> tuple[str | tuple[float, ...], str, str, str]:
    """Shade, text, its colour and its weight."""
    if sea.is_too_steep:
        return "white", "", INK, "normal"
    if not sea.is_run:
        return "#F4F4F4", "–", QUIET, "normal"
    if sea.only_warns:
        return _WARNS, sea.share, INK, "normal"
    if sea.is_allowed:
        return tuple(_SHADES(min(sea.used or 0.0, 1.0))), sea.share, INK, "normal"
    if sea.has_verdict and sea.starts:
        return _FAILED, sea.share or sea.told.lower(), "white", "bold"
    return _UNKNOWN, sea.share or sea.told.lower(), INK, "normal"


def _legend(figure: Figure, found: SavedSeas) -> None:
    """What the shades say, of those that there are."""
    keys = [(Patch(facecolor=_SHADES(0.8)), "keeps its limits: share of the nearest that is used")]
    run = [sea for sea in found.seas if sea.is_run and not sea.is_allowed]
    if any(sea.only_warns for sea in found.seas):
        keys.append((Patch(facecolor=_WARNS), "is past one that only warns"))
    if any(sea.has_verdict and sea.starts for sea in run):
        keys.append((Patch(facecolor=_FAILED), "does not"))
    if any(not (sea.has_verdict and sea.starts) for sea in run):
        keys.append((Patch(facecolor=_UNKNOWN), "not known"))
    if any(not sea.is_run and not sea.is_too_steep for sea in found.seas):
        keys.append((Patch(facecolor="#F4F4F4", edgecolor=FAINT), "not run"))
    if any(sea.is_too_steep for sea in found.seas):
        keys.append((Patch(facecolor="white", edgecolor=FAINT, hatch="////"), "no such waves"))
    figure.legend(
        [key for key, _ in keys],
        [text for _, text in keys],
        loc="outside lower left",
        ncols=len(keys),
        fontsize=8,
        handlelength=1.4,
        columnspacing=1.4,
    )
