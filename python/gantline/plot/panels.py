"""What pictures of a lift stand on: panels to one scale, ground, water, and bars of lengths and tensions."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon, Rectangle
from matplotlib.transforms import ScaledTranslation

from gantline.plot.style import FAINT, INK, force_unit, shortened
from gantline.results.recording import Recording
from gantline.results.surroundings import Ground, ground_of, water_cut, water_level
from gantline.results.variable import FloatArray

#: Colours of tensions, from none to the largest: those of the player on light paper (`viewer/src/theme.ts`).
TENSION = LinearSegmentedColormap.from_list(
    "tension",
    [(0.18, 0.52, 0.91), (0.42, 0.34, 0.92), (0.61, 0.12, 0.52), (0.62, 0.02, 0.3), (0.59, 0.0, 0.04)],
)
_TITLES = 0.6  # height of the titles of a further row [inch]
_BAR_BELOW = 8.0  # points from a panel to the bar of lengths below it
_BOLD = 0.72 / 72.0  # mean width of a bold letter, inch per point of size
_EARTH, EARTH_EDGE = "#ECE7DF", "#8C7B62"
_WATER = "#3C86B0"
_PLACES = 400  # of the surface of water with waves, from one end to the other


def window_of(points: FloatArray, below: float = 0.0) -> FloatArray:
    """Limits ((left, right), (low, high)) that hold points on paper with a margin, and `below` [m] more."""
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.05 * float(np.max(high - low)) + 1e-3
    span = np.maximum(high - low, 0.2 * float(np.max(high - low)))
    middle = (low + high) / 2.0
    limits = np.stack([middle - span / 2.0 - margin, middle + span / 2.0 + margin], axis=1)
    limits[1, 0] -= below
    return limits


def strip(
    recording: Recording,
    title: str,
    columns: int,
    windows: Sequence[FloatArray],
    *,
    scale: float = 2.2,
    high: float = 8.2,
    titles: int = 1,
) -> tuple[Figure, list[list[Axes]]]:
    """A figure with a column for each moment and a row for each window, all to one scale.

    A panel is `scale` inches wide, unless that makes all rows together higher than `high` inches.
    `titles` rows have titles.
    """
    width = float(np.ptp(windows[0][0]))
    heights = [float(np.ptp(window[1])) for window in windows]
    scale = min(scale / width, high / sum(heights))
    whole = scale * sum(heights) + 1.25 + 0.22 * len(heights) + _TITLES * (titles - 1)
    size = (max(6.0, scale * width * columns + 0.5), whole)
    figure = Figure(figsize=size)
    figure.set_layout_engine(ConstrainedLayoutEngine(h_pad=0.04, w_pad=0.03, hspace=0.01, wspace=0.01))
    most = int(size[0] / (12.0 * _BOLD)) - len(title)
    heading = f"{title}: {shortened(recording.title, most)}"
    figure.suptitle(heading, fontsize=12, fontweight="bold", x=0.01, ha="left")
    grid = figure.add_gridspec(len(windows), columns, height_ratios=heights)
    rows = [
        [figure.add_subplot(grid[row, column]) for column in range(columns)] for row in range(len(windows))
    ]
    for row, window in zip(rows, windows, strict=True):
        for panel in row:
            bare(panel, window)
    return figure, rows


def bare(panel: Axes, window: FloatArray) -> None:
    """A panel to scale, of these limits on paper, with nothing but its frame."""
    panel.set_aspect("equal")
    panel.set_xlim(*window[0])
    panel.set_ylim(*window[1])
    panel.grid(visible=False)
    panel.set_xticks([])
    panel.set_yticks([])
    for spine in panel.spines.values():
        spine.set_visible(True)
        spine.set_color(FAINT)
        spine.set_zorder(6)  # above the ground that labels stand on


def draw_water(panel: Axes, recording: Recording, lift: FloatArray, time: float, axis: int = 0) -> None:
    """The water in a side view along x (0) or y (1) at a time [s], cut where the lift is: it is tinted.

    Waves are those that run there, in the vertical plane through the middle of the lift.
    """
    level = water_level(recording)
    if level is None:
        return
    left, right = panel.get_xlim()
    low, _ = panel.get_ylim()
    middle = float(lift[:, 1 - axis].min() + lift[:, 1 - axis].max()) / 2
    for corners in water_cut(ground_of(recording), level, axis, ((left, right), low), lift):
        floor, surface = corners[:2], corners[2:]
        sea = recording.rig.sea
        if sea is not None:
            along = np.linspace(surface[0, 0], surface[1, 0], _PLACES)
            place = np.full((_PLACES, 2), middle)
            place[:, axis] = along
            heights = level + sea.at(np.array([time]), place[None])[0]
            surface = np.stack([along, np.maximum(heights, floor[0, 1])], axis=-1)
        filled = np.concatenate([floor, surface])
        panel.add_artist(Polygon(filled, facecolor=_WATER, edgecolor="none", alpha=0.25, zorder=3.8))
        panel.plot(*surface.T, color=_WATER, linewidth=1.0, zorder=3.9)


def draw_ground(panel: Axes, ground: Ground, lift: FloatArray, axis: int = 0) -> None:
    """The ground in a side view along x (0) or y (1), cut where the lift is.

    A lift over water beside a quay is cut where the water is; the level of the quay is a line of dashes then.
    """
    left, right = panel.get_xlim()
    low, _ = panel.get_ylim()
    line = ground.profile(axis, (left, right), lift)
    below = np.concatenate([line, [(right, low), (left, low)]])
    panel.add_artist(Polygon(below, facecolor=_EARTH, edgecolor="none", zorder=0))
    panel.plot(*line.T, color=EARTH_EDGE, linewidth=1.0, zorder=0.5)
    if np.all(line[:, 1] < ground.level) and np.any(ground.under(lift) == ground.level):
        level = (ground.level, ground.level)
        panel.plot((left, right), level, color=EARTH_EDGE, linewidth=0.9, linestyle=(0, (6, 3)), zorder=3.95)
        place = (left + 0.01 * (right - left), ground.level)
        panel.text(*place, "ground beside", fontsize=6, color=EARTH_EDGE, va="bottom", zorder=3.95)


def draw_holes(panel: Axes, ground: Ground, water: float | None) -> None:
    """Holes of the ground in a top view, with water in those whose floor is below its level [m]."""
    for hole in ground.holes:
        (x0, x1), (y0, y1) = hole.x, hole.y
        place = ((x0, y0), x1 - x0, y1 - y0)
        panel.add_artist(Rectangle(*place, facecolor=_EARTH, edgecolor=EARTH_EDGE, linewidth=1.0, zorder=0))
        if water is not None and hole.floor < water:
            panel.add_artist(Rectangle(*place, facecolor=_WATER, edgecolor="none", alpha=0.25, zorder=0))


def scale_bar(panel: Axes) -> None:
    """A bar of a round length below a panel, at its right end: within it there may be something anywhere."""
    left, right = panel.get_xlim()
    target = 0.3 * (right - left)
    power = 10.0 ** np.floor(np.log10(target))
    length = float(max(step * power for step in (1.0, 2.0, 5.0) if step * power <= target))
    figure = panel.get_figure(root=True)
    assert figure is not None
    below = panel.get_xaxis_transform() + ScaledTranslation(0.0, -_BAR_BELOW / 72.0, figure.dpi_scale_trans)
    bar = Line2D([right - length, right], [0.0, 0.0], color=INK, linewidth=2.2, solid_capstyle="butt")
    bar.set(transform=below, clip_on=False)
    panel.add_artist(bar)
    panel.annotate(
        f"{length:g} m",
        (right - length, 0.0),
        xycoords=panel.get_xaxis_transform(),
        xytext=(-4, -_BAR_BELOW),
        textcoords="offset points",
        ha="right",
        va="center",
        fontsize=7.5,
        annotation_clip=False,
    )


def tension_bar(figure: Figure, panels: list[Axes], norm: Normalize, pad: float = 0.02) -> None:
    """The colour scale of tensions, below panels by this share of their height."""
    scale, unit = force_unit(float(norm.vmax or 1.0))
    bar = figure.colorbar(
        ScalarMappable(Normalize(0.0, float(norm.vmax or 1.0) / scale), TENSION),
        ax=panels,
        orientation="horizontal",
        fraction=0.04,
        aspect=70,
        shrink=0.6,
        pad=pad,
    )
    bar.set_label(f"Rope tension [{unit}]; slack ropes are dashed grey", fontsize=8)
    bar.ax.tick_params(labelsize=7.5, length=2)
    bar.outline.set_visible(False)
