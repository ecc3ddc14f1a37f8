"""Draws the sketches of signs of `docs/concepts/sheave.md` and `docs/concepts/vessels.md`."""

from __future__ import annotations

from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon, Rectangle

from gantline.plot.style import INK, QUIET, RC, colour
from gantline.results.variable import FloatArray

FOLDER = Path(__file__).resolve().parents[1] / "docs" / "images"
DOTS_PER_INCH = 150
ROPE, SIGN = colour(0), colour(1)
STEEL, WATER = "#D7DDE5", "#CFE2F0"


def direction(angle: float) -> FloatArray:
    """Unit vector at an angle [rad] from the right, counter-clockwise."""
    return np.array([np.cos(angle), np.sin(angle)])


def arrow(panel: Axes, start: FloatArray, end: FloatArray, ink: str, label: str, at: FloatArray) -> None:
    """An arrow, with its name at an offset from its tip."""
    panel.annotate(
        "",
        (end[0], end[1]),
        (start[0], start[1]),
        arrowprops={"arrowstyle": "-|>", "color": ink, "lw": 1.6, "shrinkA": 0, "shrinkB": 0},
    )
    panel.text(end[0] + at[0], end[1] + at[1], label, color=ink, fontsize=12, ha="center", va="center")


def arc(panel: Axes, radius: float, first: float, last: float, ink: str, centre: FloatArray) -> None:
    """Part of a circle from one angle to another, with an arrow's head at its end."""
    angles = np.linspace(first, last, 60)
    path = centre + radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    panel.plot(*path.T, color=ink, lw=1.4)
    panel.annotate(
        "", path[-1], path[-3], arrowprops={"arrowstyle": "-|>", "color": ink, "shrinkA": 0, "shrinkB": 0}
    )


def bare(panel: Axes, title: str) -> None:
    """Equal scales and no frame."""
    panel.set_aspect("equal")
    panel.axis("off")
    panel.set_title(title, fontsize=10, color=QUIET)


def draw_sheave() -> Figure:
    """Seen against its axis: where a rope arrives and leaves, its wrap; edge on: the fleet angle."""
    figure = Figure(figsize=(7.6, 3.9), layout="constrained")
    plane, edge = figure.subplots(1, 2, width_ratios=(1.5, 1.0))
    first, last = np.radians(-20.0), np.radians(155.0)
    plane.add_patch(Circle((0, 0), 1.0, facecolor=STEEL, edgecolor=INK))
    angles = np.linspace(first, last, 80)
    wound = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    along = [direction(angle + np.pi / 2) for angle in (first, last)]
    path = np.concatenate([[wound[0] - 1.9 * along[0]], wound, [wound[-1] + 1.9 * along[1]]])
    plane.plot(*path.T, color=ROPE, lw=3.0)
    for angle in (first, last):
        plane.plot(*np.stack([np.zeros(2), direction(angle)]).T, color=QUIET, lw=1.0, ls="--")
    origin = np.zeros(2)
    arrow(plane, origin, 0.55 * direction(last), INK, "$u$", np.array([0.02, 0.2]))
    arrow(
        plane,
        direction(last),
        direction(last) + 0.75 * along[1],
        SIGN,
        "$t = a \\times u$",
        np.array([-0.55, 0.0]),
    )
    arrow(plane, wound[0] - 1.7 * along[0], wound[0] - 1.1 * along[0], ROPE, "runs in", np.array([0.5, -0.2]))
    plane.text(
        *(wound[-1] + 1.75 * along[1] + np.array([-0.35, 0.05])), "$\\ell\\, d$", color=ROPE, fontsize=12
    )
    arc(plane, 0.4, first, last, SIGN, origin)
    plane.text(0.22, 0.52, "$\\beta > 0$", color=SIGN, fontsize=12, ha="center")
    plane.plot(0, 0, "o", ms=9, mfc="white", mec=INK)
    plane.plot(0, 0, "o", ms=3, color=INK)
    plane.text(-0.15, -0.25, "$c$", fontsize=11, color=INK, ha="center")
    plane.text(-0.05, -0.62, "$a$ towards\nthe reader", fontsize=9, color=INK, ha="center", va="center")
    plane.text(*(wound[-1] + np.array([-0.3, 0.22])), "$c + r u$", fontsize=11, color=INK, ha="center")
    plane.set(xlim=(-2.6, 1.9), ylim=(-2.4, 1.2))
    bare(plane, "rope runs about $+a$, right-handed")

    fleet = np.radians(-68.0)
    edge.add_patch(Rectangle((-0.12, -1.0), 0.24, 2.0, facecolor=STEEL, edgecolor=INK))
    touch = np.array([0.0, -0.2])
    edge.plot(*np.stack([touch, touch + np.array([0.0, -1.9])]).T, color=QUIET, lw=1.0, ls="--")
    edge.plot(*np.stack([touch, touch + 2.0 * direction(fleet)]).T, color=ROPE, lw=3.0)
    arc(edge, 1.5, np.radians(-90.0), fleet, SIGN, touch)
    edge.text(0.3, -2.0, "$\\varphi > 0$", color=SIGN, fontsize=12, ha="center")
    arrow(edge, np.array([0.12, 0.45]), np.array([1.0, 0.45]), INK, "$a$", np.array([0.15, 0.0]))
    arrow(
        edge,
        touch + 1.2 * direction(fleet),
        touch + 1.7 * direction(fleet),
        ROPE,
        "$d$",
        np.array([0.2, 0.05]),
    )
    edge.set(xlim=(-1.0, 1.6), ylim=(-2.4, 1.2))
    bare(edge, "fleet angle, edge on")
    return figure


def draw_vessel() -> Figure:
    """From starboard: trim by the stern; from astern: heel to starboard."""
    figure = Figure(figsize=(8.4, 2.5), layout="constrained")
    side, behind = figure.subplots(1, 2, width_ratios=(1.7, 1.0))
    for panel, turn, hull, views in (
        (side, np.radians(5.0), [(0, 0), (9.3, 0), (10, 1.0), (10, 2), (0, 2)], ("$x$ forward", "$z$")),
        (behind, np.radians(-9.0), [(-2.4, 0), (2.4, 0), (2.4, 2), (-2.4, 2)], ("", "$z$")),
    ):
        right, up = direction(turn), direction(turn + np.pi / 2)
        low = np.array([0.0, -0.5])
        corners = low + np.array(hull) @ np.stack([right, up])
        panel.axhspan(-1.6, 0.75, facecolor=WATER, zorder=0)
        panel.axhline(0.75, color="#5B8DB8", lw=1.2, zorder=0.5)
        panel.add_patch(Polygon(corners, facecolor=STEEL, edgecolor=INK, zorder=1))
        arrow(panel, low, low + 3.2 * up, INK, views[1], np.array([-0.35, -0.1] if views[0] else [0.3, -0.2]))
        if views[0]:
            arrow(panel, low, low + 11.2 * right, INK, views[0], np.array([0.1, 0.45]))
            arc(panel, 7.0, 0.0, turn, SIGN, low)
            panel.plot([0, 8.0], [low[1], low[1]], color=QUIET, lw=1.0, ls="--")
            panel.text(8.1, -0.35, "trim $\\tau > 0$", color=SIGN, fontsize=11, va="center")
        else:
            arrow(panel, low, low - 3.2 * right, INK, "$y$ to port", np.array([0.2, -0.55]))
            panel.plot([0, 0], [low[1], 3.0], color=QUIET, lw=1.0, ls="--")
            arc(panel, 2.9, np.pi / 2, np.pi / 2 + turn, SIGN, low)
            panel.text(1.15, 3.0, "heel $\\varphi > 0$", color=SIGN, fontsize=11, va="center")
    side.plot(0.0, -0.5, "o", ms=5, color=INK, zorder=3)
    side.text(0.2, -1.1, "origin: stern, keel, centre plane", fontsize=10, color=INK)
    side.set(xlim=(-1.0, 12.4), ylim=(-1.6, 3.4))
    behind.set(xlim=(-4.0, 4.2), ylim=(-1.6, 3.4))
    bare(side, "from starboard: down by the stern")
    bare(behind, "from astern: down to starboard")
    return figure


def main() -> None:
    """Draw both."""
    with matplotlib.rc_context(RC):
        for name, draw in (("sheave_signs", draw_sheave), ("vessel_signs", draw_vessel)):
            draw().savefig(FOLDER / f"{name}.png", dpi=DOTS_PER_INCH, metadata={"Software": None})


if __name__ == "__main__":
    main()
