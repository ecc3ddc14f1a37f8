"""Draws the pictures of `docs/concepts/equalizer.md`, and prints their figures.

`equalizer_parts.png`: what an equalizer is made of; README and the guide of the first lift show it too.
`equalizer_adjustment.png`: the sequence of Fig. 6 of Ham, Roh and Lee (2016), simulated and in closed form.
`equalizer_extension.png`: a load with four lugs on one sling of a hook, by extension sheaves.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon, Rectangle

from gantline._core import Simulation
from gantline.plot import views
from gantline.plot.style import RC, colour
from gantline.results import series
from gantline.scenario import parse_scenario
from gantline.simulation import simulate

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests" / "support")]

from adjustment import DURATION, course, system  # noqa: E402
from extension_lifts import DEEP  # noqa: E402

FOLDER = ROOT / "docs" / "images"
DOTS_PER_INCH = 150
GREY, INK = "#777777", "#222222"


def draw_adjustment() -> Figure:
    """Forces above travels: lines are the closed form, dots the simulation."""
    settings = {"integrator": {"type": "adaptive"}, "duration": DURATION, "sample_interval": 0.5}
    run = Simulation(json.dumps(system()), json.dumps(settings))
    run.run()
    columns, names = run.columns(), run.names()
    exact = course(np.linspace(0.0, DURATION, 961))
    figure = Figure(figsize=(9.0, 5.4), layout="constrained")
    forces, travels = figure.subplots(2, 1, sharex=True)
    for i in range(3):
        tension = columns["rope_tension"][:, names["rope"].index(f"f{i}")]
        travel = columns["joint_position"][:, names["joint"].index(f"p{i}")]
        style = {"color": colour(i), "lw": 3.0 if i == 0 else 1.6}
        forces.plot(exact.time, exact.force[:, i] / 1e3, label=f"$f_{i}$", **style)
        travels.plot(exact.time, exact.travel[:, i], label=f"$x_{i}$", **style)
        dots = {"color": colour(i), "ls": "", "marker": "o", "ms": 3.2}
        forces.plot(columns["time"], tension / 1e3, **dots)
        travels.plot(columns["time"], travel, **dots)
        print(f"f{i}: taut from {exact.taut[i]:.3f} s, ends at {tension[-1]:.1f} N, {travel[-1]:+.4f} m")
    order = sorted(exact.taut)
    stages = ("(a)", "(b)", "(c)")
    for stage, start in zip(stages, order, strict=True):
        for panel in (forces, travels):
            panel.axvline(start, color=GREY, lw=0.9, ls=":")
        forces.annotate(stage, (start + 0.15, 33.5), color=INK, fontsize=9.5, va="top")
    forces.set_ylabel("force of the sling [kN]")
    travels.set_ylabel("travel of the sheave,\ndown positive [m]")
    travels.invert_yaxis()
    travels.set_xlabel("time [s]")
    for panel in (forces, travels):
        panel.set_xlim(0, DURATION)
        panel.grid(True, which="major", color="#dddddd", lw=0.6)
        panel.set_axisbelow(True)
        panel.spines[["top", "right"]].set_visible(False)
    forces.legend(ncols=3, fontsize=9, frameon=False, loc="upper right")
    travels.legend(ncols=3, fontsize=9, frameon=False, loc="center right")
    return figure


def draw_extension() -> Figure:
    """Side and top view, from slack slings to the load in the air."""
    recording = simulate(parse_scenario(DEEP))
    for sling in recording.rig.slings:
        static = series.static_value(recording, series.sling_tension(recording, sling)) or 0.0
        print(f"{sling.name}: {static / 1e3:.1f} kN")
    figure = views.system(recording)
    assert figure is not None
    return figure


def draw_parts() -> Figure:
    """An equalizer with three moving sheaves and the names of its parts."""
    figure = Figure(figsize=(7.6, 5.0), layout="constrained")
    panel = figure.subplots()
    panel.set_aspect("equal")
    panel.axis("off")
    radius, rail, over, top, bottom = 0.5, 4.1, 3.7, -1.9, -2.9
    moving, fixed = {0.5: 1.35, 2.5: 2.05, 4.5: 0.95}, (1.5, 3.5)
    steel: dict[str, Any] = {"facecolor": "#F1E4C8", "edgecolor": "#C98A10"}
    load: dict[str, Any] = {"facecolor": "#DDEBF5", "edgecolor": "#2777AE"}
    panel.add_patch(Rectangle((-0.5, rail), 6.0, 0.9, lw=1.2, **steel))
    panel.plot([0.6, 2.5, 4.4], [rail + 0.9, 6.0, rail + 0.9], color=INK, lw=1.6)
    panel.plot(2.5, 6.0, marker="o", ms=9, mfc="white", mec=INK, mew=1.8)
    panel.add_patch(Rectangle((-0.9, bottom), 6.8, top - bottom, lw=1.2, **load))
    for x in fixed:
        panel.add_patch(Rectangle((x - 0.11, over), 0.22, rail - over, lw=0.8, zorder=3, **steel))
        panel.add_patch(Circle((x, over), radius, facecolor="white", edgecolor=INK, lw=1.2))
        panel.plot(x, over, marker="o", ms=4, color=INK, zorder=4)
    turns = np.linspace(0.0, np.pi, 40)
    rope = [np.array([[0.0, rail]])]
    for x in sorted([*moving, *fixed]):
        sign, height = (1.0, over) if x in fixed else (-1.0, moving[x])
        arc = np.stack([x - radius * np.cos(turns), height + sign * radius * np.sin(turns)], axis=-1)
        rope.append(arc)
    rope.append(np.array([[5.0, rail]]))
    for x, height in moving.items():
        panel.add_patch(Circle((x, height), radius, facecolor="white", edgecolor=INK, lw=1.2))
        panel.plot([x, x], [height, top + 0.16], color=INK, lw=2.4)
        panel.plot(x, height, marker="o", ms=4, color=INK)
        panel.add_patch(Polygon([(x - 0.2, top), (x, top + 0.3), (x + 0.2, top)], facecolor=INK))
    panel.plot(*np.concatenate(rope).T, color=colour(1), lw=2.6, solid_joinstyle="round")
    for x in (0.0, 5.0):
        panel.add_patch(Rectangle((x - 0.13, rail - 0.12), 0.26, 0.24, facecolor=INK))
    for x, y, text, ink in (
        (-0.25, 2.6, "$T$", colour(1)),
        (1.25, 2.6, "$T$", colour(1)),
        (0.78, -0.6, "$2T$", INK),
    ):
        panel.text(x, y, text, color=ink, fontsize=12, ha="center", va="center")
    panel.plot([5.45, 5.45], [0.1, 2.9], color=GREY, lw=1.0)
    for y in (0.1, 2.9):
        panel.plot([5.3, 5.6], [y, y], color=GREY, lw=1.0)
    calls = (
        ("hook", (2.5, 6.0), (6.7, 6.0)),
        ("frame", (5.5, rail + 0.5), (6.7, 4.95)),
        ("dead end", (5.1, rail), (6.7, 4.1)),
        ("fixed sheave", (3.95, over), (6.7, 3.25)),
        ("stroke: how far a moving\nsheave travels up and down", (5.5, 2.2), (6.7, 2.2)),
        ("moving sheave", (4.9, 0.95), (6.7, 0.75)),
        ("sling", (4.5, -0.6), (6.7, -0.4)),
        ("lug", (4.62, top + 0.12), (6.7, -1.5)),
        ("load", (5.7, bottom + 0.5), (6.7, -2.4)),
    )
    for text, tip, place in calls:
        line = {"arrowstyle": "-", "color": GREY, "lw": 0.9, "shrinkA": 2, "shrinkB": 0}
        panel.annotate(text, tip, place, arrowprops=line, color=INK, fontsize=10.5, va="center")
    line = {"arrowstyle": "-", "color": GREY, "lw": 0.9, "shrinkA": 2, "shrinkB": 0}
    panel.annotate(
        "equalizing\nrope",
        (0.0, 3.3),
        (-1.3, 3.3),
        arrowprops=line,
        color=INK,
        fontsize=10.5,
        va="center",
        ha="right",
    )
    panel.set_xlim(-3.0, 11.0)
    panel.set_ylim(-3.1, 6.4)
    return figure


def main() -> None:
    """Draw all."""
    for name, draw, dots in (
        ("parts", draw_parts, DOTS_PER_INCH),
        ("adjustment", draw_adjustment, DOTS_PER_INCH),
        ("extension", draw_extension, DOTS_PER_INCH // 2),
    ):
        with matplotlib.rc_context(RC):
            path = FOLDER / f"equalizer_{name}.png"
            draw().savefig(path, dpi=dots, metadata={"Software": None})


if __name__ == "__main__":
    main()
