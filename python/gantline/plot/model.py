"""A picture of a CAD model: seen from above and aside, and in three views with its dimensions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from gantline.plot.raster import View, rendered
from gantline.plot.style import COLOURS, INK, QUIET, RC, shortened
from gantline.results.variable import FloatArray

__all__ = ["Piece", "model_figure"]

_FILL = ("#C9D6E2", "#D98032", "#3E9A78", "#8C5CA8", "#C8463C", "#8FA3B5", "#D8C48A")
_ISOMETRIC = np.array([-0.62, -0.66, 0.48])  # towards the viewer
_VIEWS = (
    ("side view", np.array([0.0, -1.0, 0.0]), "xz"),
    ("front view", np.array([1.0, 0.0, 0.0]), "yz"),
    ("top view", np.array([0.0, 0.0, 1.0]), "xy"),
)


@dataclass(frozen=True, eq=False)
class Piece:
    """All parts of one kind.

    Attributes:
        label: what the legend says of them.
        corners: of all triangles (n, 3, 3) [m].
        part: number of the part that each triangle belongs to (n,).
        tone: number of its colour.
        is_skin: whether it is drawn so that what lies behind shows through.
    """

    label: str
    corners: FloatArray
    part: FloatArray
    tone: int = 0
    is_skin: bool = False


def model_figure(title: str, subtitle: str, pieces: Sequence[Piece], centre: FloatArray | None) -> Figure:
    """Draw a model.

    Args:
        title: name of the model.
        subtitle: its weight and the like, in one line.
        pieces: what to draw, a colour each.
        centre: centre of gravity (3,) [m]; None if there is none.

    Returns:
        The figure.
    """
    with matplotlib.rc_context(RC):
        figure = Figure(figsize=(10.4, 6.6))
        grid = figure.add_gridspec(
            3,
            2,
            width_ratios=[2.5, 1.0],
            left=0.015,
            right=0.985,
            top=0.88,
            bottom=0.075,
            wspace=0.04,
            hspace=0.16,
        )
        figure.text(0.02, 0.95, shortened(title, 70), fontsize=14, fontweight="bold", color=INK)
        figure.text(0.02, 0.91, shortened(subtitle, 130), fontsize=9, color=QUIET)
        _draw(figure.add_subplot(grid[:, 0]), pieces, View.along(_ISOMETRIC), (1100, 950), centre)
        for row, (name, toward, axes) in enumerate(_VIEWS):
            panel = figure.add_subplot(grid[row, 1])
            view = View.along(toward)
            _draw(panel, pieces, view, (480, 340), centre)
            _dimensions(panel, pieces, view, axes)
            panel.set_title(name, fontsize=8, color=QUIET, loc="left", pad=2)
        handles = [
            Patch(facecolor=_FILL[piece.tone % len(_FILL)], edgecolor=QUIET, linewidth=0.5, label=piece.label)
            for piece in pieces
        ]
        figure.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.012, 0.005), ncols=4, fontsize=8)
    return figure


def _draw(
    panel: Axes, pieces: Sequence[Piece], view: View, size: tuple[int, int], centre: FloatArray | None
) -> None:
    colours = [matplotlib.colors.to_rgb(_FILL[piece.tone % len(_FILL)]) for piece in pieces]
    image, extent = rendered(
        [piece.corners for piece in pieces],
        [piece.part for piece in pieces],
        np.array(colours),
        [piece.is_skin for piece in pieces],
        view,
        size,
    )
    panel.imshow(image, extent=extent, interpolation="antialiased", aspect="equal")
    panel.set_axis_off()
    if centre is None:
        return
    across, up = view.project(centre)
    panel.plot(
        across,
        up,
        "o",
        markersize=7,
        markerfacecolor="white",
        markeredgecolor=INK,
        markeredgewidth=1.1,
        zorder=5,
    )
    panel.plot(across, up, "+", markersize=7, color=INK, markeredgewidth=1.0, zorder=6)


def _dimensions(panel: Axes, pieces: Sequence[Piece], view: View, axes: str) -> None:
    flat = view.project(np.concatenate([piece.corners.reshape(-1, 3) for piece in pieces]))
    low, high = flat.min(axis=0), flat.max(axis=0)
    width, height = high - low
    places = (
        (f"{axes[0]} {width:.2f} m", (low[0] + width / 2, low[1]), (0, -3), "center", "top", 0),
        (f"{axes[1]} {height:.2f} m", (low[0], low[1] + height / 2), (-3, 0), "right", "center", 90),
    )
    for text, at, beside, across, up, turned in places:
        panel.annotate(
            text,
            at,
            beside,
            textcoords="offset points",
            ha=across,
            va=up,
            rotation=turned,
            fontsize=7.5,
            color=COLOURS[0],
        )
