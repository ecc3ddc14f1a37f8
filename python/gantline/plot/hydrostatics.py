"""Hydrostatic curves of a hull over its draft, with the hull itself and its righting arms."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from gantline.plot.style import FAINT, INK, QUIET, RC, colour
from gantline.results.variable import FloatArray

__all__ = ["FORMATS", "HullCurves", "hydrostatic_curves"]

#: Endings of names of pictures.
FORMATS = (".png", ".svg", ".pdf")
_WATER = "#56B4E9"
#: Triangles that are drawn; of larger meshes an even choice.
_MOST_DRAWN = 40_000


@dataclass(frozen=True)
class HullCurves:
    """What is drawn.

    Attributes:
        name: of the hull.
        mesh: vertices (n, 3) [m] and triangles (m, 3).
        drafts: of the curves, ascending [m].
        marked: drafts that were asked for [m].
        trim: by the stern [rad].
        middle: x where drafts are measured [m].
        kg: centre of gravity above z = 0 [m], or None.
        figures: displacement [kg], waterplane_area, wetted_surface [m^2], kb, km_transverse,
            km_longitudinal, lcb, lcf [m], each over the drafts.
        arms: draft [m], displacement [kg], angles [rad] and righting arms [m] of each curve.
    """

    name: str
    mesh: tuple[FloatArray, np.ndarray[tuple[int, ...], np.dtype[np.int64]]]
    drafts: FloatArray
    marked: FloatArray
    trim: float
    middle: float
    kg: float | None
    figures: Mapping[str, FloatArray]
    arms: list[tuple[float, float, FloatArray, FloatArray]]


def hydrostatic_curves(curves: HullCurves) -> Figure:
    """The picture: hull from the side and ahead, curves over draft, righting arms where there are any."""
    with mpl.rc_context(RC):
        length, _, depth = np.ptp(curves.mesh[0], axis=0)
        rows = [float(np.clip(6.0 * depth / length, 0.5, 1.6)) + 0.2, 2.1] + ([1.8] if curves.arms else [])
        figure = Figure(figsize=(8.6, 1.0 + 1.6 * sum(rows)))
        figure.set_layout_engine(ConstrainedLayoutEngine(h_pad=0.06, w_pad=0.06, hspace=0.04))
        grid = figure.add_gridspec(len(rows), 4, height_ratios=rows)
        _hull(figure.add_subplot(grid[0, :3]), curves, 0)
        _hull(figure.add_subplot(grid[0, 3]), curves, 1)
        first: Axes | None = None
        for column, draw in enumerate((_displacement, _areas, _heights, _places)):
            panel = figure.add_subplot(grid[1, column], sharey=first)
            draw(panel, curves)
            _over_draft(panel, curves, is_first=first is None)
            first = first or panel
        if curves.arms:
            _righting(figure.add_subplot(grid[2, :]), curves)
        figure.suptitle(f"Hydrostatics of {curves.name}", x=0.01, ha="left", fontsize=12, fontweight="bold")
    return figure


def _hull(panel: Axes, curves: HullCurves, side: int) -> None:
    """The hull from starboard (0) or from ahead (1), shaded, with the water at the drafts asked for."""
    vertices, triangles = curves.mesh
    chosen = triangles[:: max(1, math.ceil(len(triangles) / _MOST_DRAWN))]
    corners = vertices[chosen]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(normals, axis=1)
    normals = normals / np.where(size > 0, size, 1.0)[:, None]
    towards = np.array([0.0, -1.0, 0.0]) if side == 0 else np.array([1.0, 0.0, 0.0])
    across = 0 if side == 0 else 1
    depth = corners.mean(axis=1) @ towards
    seen = np.flatnonzero(normals @ towards > -0.02)
    seen = seen[np.argsort(depth[seen])]
    light = np.clip(0.55 + 0.45 * (normals[seen] @ (towards * 0.8 + np.array([0.25, 0.0, 0.55]))), 0.3, 1.0)
    shade = np.stack(
        [0.50 + 0.42 * light, 0.53 + 0.40 * light, 0.57 + 0.38 * light, np.ones_like(light)], axis=1
    )
    outline = corners[seen][:, :, [across, 2]]
    panel.add_collection(
        PolyCollection(list(outline), facecolors=shade, edgecolors=shade, linewidths=0.2, zorder=1)
    )
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    span = float(high[across] - low[across])
    margin = 0.04 * (span if side == 0 else span * 2)
    ends = np.array([low[across] - margin, high[across] + margin])
    slope = -math.tan(curves.trim) if side == 0 else 0.0
    for draft in curves.marked:
        panel.plot(
            ends,
            draft + slope * (ends - curves.middle) * (side == 0),
            color=colour(0),
            linewidth=0.6,
            zorder=3,
        )
    lowest = float(curves.marked.max()) + slope * (ends - curves.middle)
    panel.fill_between(ends, low[2] - margin, lowest, color=_WATER, alpha=0.18, linewidth=0, zorder=2)
    panel.set_xlim(*ends)
    panel.set_ylim(low[2] - 0.25 * margin, high[2] + 0.5 * margin)
    panel.set_aspect("equal" if side == 1 or span < 12 * (high[2] - low[2]) else "auto")
    panel.grid(False)
    panel.set_xlabel("x [m]" if side == 0 else "y [m]")
    if side == 0:
        panel.set_ylabel("z [m]")
    if side == 1:
        panel.invert_xaxis()  # from ahead port is to the right


def _over_draft(panel: Axes, curves: HullCurves, *, is_first: bool) -> None:
    panel.grid(True, axis="both")
    for draft in curves.marked:
        panel.axhline(float(draft), color=FAINT, linewidth=0.6, zorder=0.5)
    if is_first:
        panel.set_ylabel("Draft [m]")
        if len(curves.drafts) > 1:
            panel.set_ylim(float(curves.drafts[0]), float(curves.drafts[-1]))
    else:
        panel.tick_params(labelleft=False)
    panel.legend(
        loc="lower left",
        bbox_to_anchor=(-0.03, 1.0),
        fontsize=7.8,
        handlelength=1.4,
        borderaxespad=0.1,
        labelspacing=0.25,
    )


def _curve(panel: Axes, curves: HullCurves, values: FloatArray, index: int, label: str) -> None:
    marker = "o" if len(values) == 1 else ""
    panel.plot(values, curves.drafts, color=colour(index), label=label, marker=marker, markersize=4)


def _displacement(panel: Axes, curves: HullCurves) -> None:
    mass = curves.figures["displacement"]
    is_large = bool(mass.max() >= 1e7)
    _curve(panel, curves, mass / (1e6 if is_large else 1e3), 0, "displacement")
    panel.set_xlabel("[1000 t]" if is_large else "[t]")
    panel.set_xlim(left=0)


def _areas(panel: Axes, curves: HullCurves) -> None:
    _curve(panel, curves, curves.figures["waterplane_area"], 0, "waterplane")
    _curve(panel, curves, curves.figures["wetted_surface"], 1, "wetted surface")
    panel.set_xlabel("[m²]")
    panel.set_xlim(left=0)


def _heights(panel: Axes, curves: HullCurves) -> None:
    _curve(panel, curves, curves.figures["kb"], 0, "KB")
    _curve(panel, curves, curves.figures["km_transverse"], 1, "KM")
    _curve(panel, curves, curves.figures["km_longitudinal"] / 10, 2, "KM long. / 10")
    if curves.kg is not None:
        panel.axvline(curves.kg, color=INK, linewidth=1.0, linestyle=(0, (4, 2)), label="KG")
    panel.set_xlabel("above z = 0 [m]")
    panel.set_xlim(left=min(0.0, panel.get_xlim()[0]))


def _places(panel: Axes, curves: HullCurves) -> None:
    _curve(panel, curves, curves.figures["lcb"], 0, "LCB")
    _curve(panel, curves, curves.figures["lcf"], 1, "LCF")
    panel.set_xlabel("x [m]")
    low, high = panel.get_xlim()
    least = 0.02 * float(np.ptp(curves.mesh[0][:, 0]))
    if high - low < least:
        middle = (low + high) / 2
        panel.set_xlim(middle - least / 2, middle + least / 2)


def _righting(panel: Axes, curves: HullCurves) -> None:
    for index, (draft, mass, heel, arm) in enumerate(curves.arms):
        label = f"{draft:.4g} m, {mass / 1e3:,.0f} t".replace(",", " ")
        panel.plot(np.degrees(heel), arm, color=colour(index), label=label)
    panel.axhline(0.0, color=QUIET, linewidth=0.8)
    panel.grid(True, axis="both")
    panel.margins(x=0)
    panel.set_xlabel("Heel [deg]")
    panel.set_ylabel("Righting arm [m]")
    panel.legend(title="draft and displacement", title_fontsize=8, fontsize=8, loc="best")
