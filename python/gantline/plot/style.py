"""One look for all pictures: fonts, colours, axes, event marks and labels.

Colours are those of Okabe and Ito (2008), which remain distinct in the common kinds of colour blindness.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from gantline.plot.timeline import LETTER, draw_strip, is_tall, strips_of
from gantline.results.ending import ending_of
from gantline.results.loads.lift_off import lift_off_time
from gantline.results.recording import Recording
from gantline.results.ropes.families import shortened_inside
from gantline.results.variable import FloatArray

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7A5195", "#4D4D4D")
INK = "#222222"
QUIET = "#6B6B6B"
FAINT = "#D9D9D9"
ALARM = "#B3261E"
WARN = "#8A5A00"
BAD = "#B3261E"
#: Behind a text that curves run past.
PALE: Any = {"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.6}

KILO = 1e3
_LEGEND_WIDTH, _KEY_WIDTH = 6.0, 0.4  # inch
#: Most curves or sheaves that are all named beside each other; of more some are.
MOST_NAMED = 24
#: Curves that are nearer than this share of all their reach, for most of the samples, are one on paper.
_NEAR, _MOSTLY = 0.005, 0.95
#: Share of all their reach past which a curve is seen by itself: dashes would break up its peak.
_AWAY = 0.02
_DASH = 5.0  # widths of the line
_PEAK_BELOW = 0.84  # of a panel's height: the text above a peak stays clear of 'lift-off'
TONNE_FORCE = 9.81e3  # N; only what people read speaks of tonne-force

RC: Any = {
    "font.family": "DejaVu Sans",
    "font.size": 9.0,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.labelsize": 9.0,
    "axes.edgecolor": QUIET,
    "axes.linewidth": 0.7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.axisbelow": True,
    "axes.grid": True,
    "axes.grid.axis": "y",
    "grid.color": "#E6E6E6",
    "grid.linewidth": 0.6,
    "xtick.color": QUIET,
    "ytick.color": QUIET,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "lines.linewidth": 1.5,
    "lines.solid_capstyle": "round",
    "lines.solid_joinstyle": "round",
    "legend.frameon": False,
    "savefig.dpi": 200,
    "savefig.facecolor": "white",
}


def time_figure(
    recording: Recording, title: str, heights: Sequence[float], height: float = 4.2
) -> tuple[Figure, list[Axes]]:
    """A figure with panels over time, one above the other, under a title and a strip of the plan's steps.

    Args:
        recording: What is shown.
        title: What the picture shows.
        heights: Relative heights of the panels, from the top.
        height: Of the whole figure [inch].

    Returns:
        The figure and its panels.
    """
    return figure_over_time({"": recording}, title, shortened(recording.title, 70), heights, height)


def figure_over_time(
    recordings: Mapping[str, Recording], title: str, subtitle: str, heights: Sequence[float], height: float
) -> tuple[Figure, list[Axes]]:
    """As `time_figure`, of one recording or of several whose steps and lift-offs are told apart by a letter.

    Args:
        recordings: What is shown, by a letter; plans with the same steps at the same times share a strip.
        title: What the picture shows.
        subtitle: What was lifted.
        heights: Relative heights of the panels, from the top.
        height: Of the whole figure [inch].

    Returns:
        The figure and its panels.
    """
    figure = Figure(figsize=(7.4, height))
    figure.set_layout_engine(ConstrainedLayoutEngine(h_pad=0.05, w_pad=0.06, hspace=0.03))
    ends = [float(end) for recording in recordings.values() for end in recording.time[[0, -1]]]
    first, last = min(ends), max(ends)
    strips = strips_of(recordings, last - first)
    strip_heights = [
        (0.3 if is_tall(steps, last - first) else 0.2) * sum(heights) / height for _, steps in strips
    ]
    grid = figure.add_gridspec(len(strips) + len(heights), 1, height_ratios=[*strip_heights, *heights])
    panels: list[Axes] = []
    for row in range(len(heights)):
        panels.append(figure.add_subplot(grid[len(strips) + row], sharex=panels[0] if panels else None))
    panels[0].set_xlim(first, last if last > first else first + 1.0)
    for panel in panels[:-1]:
        panel.tick_params(labelbottom=False)
    panels[-1].set_xlabel("Time [s]")
    tops = [figure.add_subplot(grid[row], sharex=panels[0]) for row in range(len(strips))]
    for top, (letter, steps) in zip(tops, strips, strict=True):
        draw_strip(top, letter, steps, last - first)
    top = [*tops, panels[0]][0]
    pad = 7 if tops or len(recordings) == 1 else 24  # room for the names of A and B
    top.set_title(title, loc="left", fontsize=12, fontweight="bold", pad=pad)
    top.set_title(subtitle, loc="right", fontsize=8.5, color=QUIET, pad=pad)
    _mark_lift_off(recordings, panels)
    _mark_ends(recordings, panels)
    return figure, panels


def force_unit(largest: float) -> tuple[float, str]:
    """Unit for forces up to this one [N]: its size [N] and its name."""
    return (KILO, "kN") if largest >= KILO else (1.0, "N")


def force_axis(panel: Axes, label: str, unit: str) -> None:
    """Label a panel with its unit of force, and kilonewtons with tonne-force on the right."""
    panel.set_ylabel(f"{label} [{unit}]")
    if unit != "kN":
        return
    right = panel.secondary_yaxis("right", functions=(_to_tonne_force, _from_tonne_force))
    right.set_ylabel("tonne-force [t]", color=QUIET)
    right.tick_params(colors=QUIET, labelcolor=QUIET)
    right.spines["right"].set_visible(True)
    right.spines["right"].set_color(FAINT)


def curves(panel: Axes, time: FloatArray, values: dict[str, FloatArray]) -> None:
    """Draw curves that may lie upon each other: the first is the widest, so that each can be seen.

    Of those that are one on paper the first is drawn whole and the others as dashes upon it: a thin line upon
    one that is hardly wider would look like a line of a third colour. They lie below all that is narrower.
    """
    groups = _alike(list(values.values()))
    firsts = list(dict.fromkeys(groups))
    widths = (
        dict(zip(firsts, np.linspace(3.0, 1.0, len(firsts)), strict=True)) if len(values) > 1 else {0: 1.6}
    )
    for index, ((name, curve), group) in enumerate(zip(values.items(), groups, strict=True)):
        members = [other for other, its in enumerate(groups) if its == group]
        place, behind = members.index(index), len(members) - 1
        width, order = float(widths[group]), 2.0 + 0.5 * group / len(values)
        (line,) = panel.plot(time, curve, color=colour(index), linewidth=width, label=name, zorder=order)
        if place:
            line.set_linestyle((-_DASH * place, (_DASH, _DASH * behind)))
            line.set_dash_capstyle("butt")


def _alike(values: Sequence[FloatArray]) -> list[int]:
    """Of each curve the first one that it looks like: itself, or one that hides nearly all of it."""
    known = [curve[np.isfinite(curve)] for curve in values]
    reach = np.concatenate(known) if known else np.zeros(0)
    near = _NEAR * float(np.ptp(reach)) if reach.size else 0.0
    groups: list[int] = []
    for index, curve in enumerate(values):
        firsts = (other for other in dict.fromkeys(groups) if _hides(values[other], curve, near))
        groups.append(next(firsts, index))
    return groups


def _hides(one: FloatArray, other: FloatArray, near: float) -> bool:
    off = np.abs(one - other)
    return bool(one.size and np.mean(off <= near) >= _MOSTLY and not np.any(off > near / _NEAR * _AWAY))


def many_curves(
    panel: Axes,
    time: FloatArray,
    values: Mapping[str, FloatArray],
    shades: Mapping[str, str],
    heavy: Sequence[str],
) -> None:
    """Draw curves that share colours: thin lines, and upon them those that count most."""
    for name, curve in values.items():
        if name not in heavy:
            panel.plot(time, curve, color=shades[name], linewidth=0.6, alpha=0.6, label=name)
    for name, width in zip(heavy, np.linspace(2.8, 1.2, len(heavy)), strict=True):
        panel.plot(time, values[name], color=shades[name], linewidth=float(width), zorder=2.5, label=name)


def legend(panel: Axes) -> None:
    """Name the curves of a panel in rows above it, inside its frame."""
    lines = [line for line in panel.get_lines() if not str(line.get_label()).startswith("_")]
    legend_of(panel, {str(line.get_label()): str(line.get_color()) for line in lines})


def legend_of(panel: Axes, entries: Mapping[str, str]) -> None:
    """Names of curves with their colours in rows above a panel, in as many columns as there is room for."""
    keys = [Line2D([], [], color=shade, linewidth=2.4) for shade in entries.values()]
    longest = max((len(name) for name in entries), default=1)
    columns = int(_LEGEND_WIDTH / (8.5 * LETTER * longest + _KEY_WIDTH))
    legend_above(panel, keys, list(entries), min(8, max(1, columns), max(1, len(entries))))


def fitting_columns(labels: Sequence[str]) -> int:
    """Most columns of a legend, filled one after the other, that are no wider together than a panel."""
    for columns in range(len(labels), 1, -1):
        parts = np.array_split([len(label) for label in labels], columns)  # as a legend divides them
        if sum(8.5 * LETTER * int(max(part)) + _KEY_WIDTH for part in parts) <= _LEGEND_WIDTH:
            return columns
    return 1


def legend_above(
    panel: Axes, keys: Sequence[Artist], labels: Sequence[str], columns: int, *, spacing: float = 1.4
) -> None:
    """Keys with their labels above a panel, `spacing` times the size of a letter between columns."""
    panel.legend(
        keys,
        labels,
        ncols=columns,
        loc="lower left",
        bbox_to_anchor=(0.0, 1.0),
        borderaxespad=0.2,
        handlelength=1.3,
        handletextpad=0.5,
        columnspacing=spacing,
        fontsize=8.5,
    )


def label_ends(panel: Axes, time: FloatArray, values: dict[str, FloatArray]) -> None:
    """Write each curve's name beside its right end; names that would touch move apart and keep a leader.

    Of more than a panel holds, those of lowest and highest end are named and some between.
    """
    low, high = sorted(panel.get_ylim())
    gap = (high - low) * 0.085 * _size_factor(panel)
    bottom, top = panel.get_ylim()
    first, last = panel.get_xlim()
    right = (float(time[-1]) - first) / (last - first)
    ends = sorted(((float(curve[-1]), index, name) for index, (name, curve) in enumerate(values.items())))
    if len(ends) > MOST_NAMED:
        fitting = max(2, int((high - low) / gap))
        ends = [ends[at] for at in np.linspace(0, len(values) - 1, fitting).round().astype(int)]
        panel.annotate(
            f"… and {len(values) - len(ends)} more",
            xy=(1.035, 1.06),
            xycoords="axes fraction",
            color=QUIET,
            fontsize=8.5,
            annotation_clip=False,
        )
    places = _apart([end for end, _, _ in ends], gap, low, high)
    for (end, index, name), place in zip(ends, places, strict=True):
        fraction = (place - bottom) / (top - bottom)
        panel.text(
            1.035,
            fraction,
            shortened_inside(name),
            transform=panel.transAxes,
            color=colour(index),
            fontsize=8.5,
            va="center",
            ha="left",
        )
        heights = [(end - bottom) / (top - bottom), fraction]
        leader = Line2D([right, 1.033], heights, color=colour(index), linewidth=0.6)
        leader.set(transform=panel.transAxes, clip_on=False, in_layout=False)
        panel.add_artist(leader)


def limit_line(panel: Axes, value: float, text: str, *, below: bool = False, right: bool = False) -> None:
    """Draw a limit as a dashed red line with its name, above it on the left unless said otherwise."""
    panel.axhline(value, color=ALARM, linewidth=0.9, linestyle=(0, (5, 3)))
    panel.annotate(
        text,
        xy=(0.994 if right else 0.006, value),
        xycoords=("axes fraction", "data"),
        xytext=(0, -2.5 if below else 2.5),
        textcoords="offset points",
        color=ALARM,
        fontsize=8,
        va="top" if below else "bottom",
        ha="right" if right else "left",
        in_layout=False,
    )


def mark_peak(panel: Axes, time: float, value: float, text: str) -> None:
    """Mark the highest point of a panel with a dot and a text, below where lift-off has its name."""
    panel.plot([time], [value], "o", color=INK, markersize=3.5, zorder=5)
    left, right = panel.get_xlim()
    to_left = time > left + 0.7 * (right - left)
    low, high = panel.get_ylim()
    panel.set_ylim(low, max(high, low + (value - low) / _PEAK_BELOW))
    panel.annotate(
        text,
        xy=(time, value),
        xytext=(-6 if to_left else 6, 3),
        textcoords="offset points",
        ha="right" if to_left else "left",
        va="bottom",
        fontsize=8,
        color=INK,
        bbox=PALE,
        in_layout=False,
    )


def few_ticks(panel: Axes, count: int = 4) -> None:
    """Use few ticks on the vertical axis of a low panel."""
    panel.yaxis.set_major_locator(MaxNLocator(count, min_n_ticks=3))


def widen(panel: Axes, least: float) -> None:
    """Give a panel at least this span, so that rounding errors do not look like motion."""
    low, high = panel.get_ylim()
    if high - low < least:
        middle = (low + high) / 2
        panel.set_ylim(middle - least / 2, middle + least / 2)


def shortened(text: str, most: int) -> str:
    """A text of at most this many characters."""
    return text if len(text) <= most else text[: most - 1].rstrip() + "…"


def four_digits(value: float) -> str:
    """A number with four digits, or as many as it has before the point."""
    return f"{value:.4g}" if abs(value) < 9999.5 else f"{value:.0f}"


def colour(index: int) -> str:
    """Colour of the curve with this index."""
    return COLOURS[index % len(COLOURS)]


def _mark_lift_off(recordings: Mapping[str, Recording], panels: Sequence[Axes]) -> None:
    labels: dict[str, float] = {}
    for letter, recording in recordings.items():
        time = lift_off_time(recording)
        if time is None:
            continue
        for panel in panels:
            panel.axvline(time, color=QUIET, linewidth=0.8, linestyle=(0, (1.5, 2)), zorder=1)
        labels[f"lift-off {letter} {time:.2f} s".replace("  ", " ")] = time
    if len(labels) > 1 and len({f"{time:.2f}" for time in labels.values()}) == 1:
        time = next(iter(labels.values()))
        labels = {f"lift-off {time:.2f} s": time}
    first, last = panels[0].get_xlim()
    for row, (label, time) in enumerate(labels.items()):
        is_early = time < first + 0.2 * (last - first)  # no room on the left
        panels[0].annotate(
            label,
            xy=(time, 1.0),
            xycoords=("data", "axes fraction"),
            xytext=(4 if is_early else -4, -3 - 11 * row),
            textcoords="offset points",
            ha="left" if is_early else "right",
            va="top",
            fontsize=8,
            color=QUIET,
            bbox=PALE,
            in_layout=False,
        )


def _mark_ends(recordings: Mapping[str, Recording], panels: Sequence[Axes]) -> None:
    """Where a run fails, or ends before its plan: a line, and in which step that is."""
    for row, (letter, recording) in enumerate(recordings.items()):
        ending = ending_of(recording)
        if ending is None or not len(recording.time):
            continue
        end, ink = float(recording.time[-1]), BAD if ending.how == "failed" else WARN
        for panel in panels:
            panel.axvline(end, color=ink, linewidth=1.6, zorder=1)
        panels[0].annotate(
            f"{letter} {ending.in_short}".strip(),
            xy=(end, 0.0),
            xycoords=("data", "axes fraction"),
            xytext=(-4, 3 + 11 * row),
            textcoords="offset points",
            ha="right",
            va="bottom",
            fontsize=8,
            color=ink,
            bbox=PALE,
            in_layout=False,
        )


def _apart(ends: list[float], gap: float, low: float, high: float) -> list[float]:
    """Places at least `gap` apart and inside the panel, as near to the ends (in rising order) as that allows.

    Names that would touch form a group whose middle stays at the mean of its ends (pool adjacent violators).
    """
    groups: list[tuple[float, int]] = []  # mean of (end - gap * index), number of names
    for index, end in enumerate(ends):
        groups.append((end - gap * index, 1))
        while len(groups) > 1 and groups[-2][0] > groups[-1][0]:
            (upper, many), (lower, few) = groups.pop(), groups.pop()
            groups.append(((upper * many + lower * few) / (many + few), many + few))
    levels = [level for level, count in groups for _ in range(count)]
    places = [level + gap * index for index, level in enumerate(levels)]
    floor, ceiling = low, high
    for index in range(len(places)):
        floor = max(places[index], floor)
        places[index], floor = floor, floor + gap
    for index in reversed(range(len(places))):
        ceiling = min(places[index], ceiling)
        places[index], ceiling = ceiling, ceiling - gap
    return places


def _size_factor(panel: Axes) -> float:
    """How much larger a line of text is in this panel than in one that is 2.2 inches high."""
    figure = panel.get_figure(root=True)
    assert figure is not None
    height = float(figure.get_figheight()) * panel.get_position().height
    return 2.2 / max(height, 0.4)


def _to_tonne_force(kilonewton: Any) -> Any:
    return np.asarray(kilonewton) * KILO / TONNE_FORCE


def _from_tonne_force(tonne: Any) -> Any:
    return np.asarray(tonne) * TONNE_FORCE / KILO
