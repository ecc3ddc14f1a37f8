"""Draws the pictures of `docs/concepts/mechanisms.md`, and prints their figures.

`mechanisms_tension.png`: the reference lift with sheaves, and with lengths adjusted at three time scales.
`mechanisms_travel.png`: what travels with sheaves and is lengthened without, also beyond the stroke.
`mechanisms_stability.png`: limits of factor and step, and what happens beyond them.
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import gantline
from gantline.plot.style import RC, colour
from gantline.results.loads.lift_off import lift_off_time
from gantline.scenario.file.reading import parse_scenario

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests" / "support")]

from adjusting import step_map  # noqa: E402

FOLDER = ROOT / "docs" / "images"
DOTS_PER_INCH = 150
BLUE, ORANGE, GREY, INK = "#0072b2", "#d55e00", "#777777", "#222222"
LIFTS = {name: ROOT / "scenarios" / name / "scenario.yaml" for name in ("equalizer", "mechanisms")}
SLINGS = [f"S{number}" for number in range(1, 6)]


def tidy(axes: Axes) -> None:
    """Light grid behind, no box."""
    axes.grid(True, which="major", color="#dddddd", lw=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def draw_tension() -> Figure:
    """Tensions of all slings at the same scale: sheaves, then ever slower adjusting."""
    runs = [
        ("moving sheaves on one rope", gantline.simulate(LIFTS["equalizer"])),
        ("adjusted, step/factor = 0.1 s", gantline.simulate(LIFTS["mechanisms"])),
        ("adjusted, step/factor = 1 s", gantline.simulate(LIFTS["mechanisms"], step=0.01)),
        ("adjusted, step/factor = 10 s", gantline.simulate(LIFTS["mechanisms"], adjusting_factor=1e-4)),
    ]
    figure = Figure(figsize=(9.0, 6.6), layout="constrained")
    panels = figure.subplots(len(runs), 1, sharex=True, sharey=True)
    for panel, (label, run) in zip(panels, runs, strict=True):
        for index, sling in enumerate(SLINGS):
            width = 2.4 if index < 3 else 1.1
            tension = run.column("rope_tension", f"sling.{sling}") / 1e3
            panel.plot(run.time, tension, color=colour(index), lw=width, label=sling)
        lift_off = lift_off_time(run) or 0.0
        panel.axvline(lift_off, color=GREY, lw=0.9, ls=":")
        peak = run.metrics()["peak_sling_tension"] / 1e3
        panel.annotate(
            f"{label}: peak {peak:.0f} kN, clear of the ground from {lift_off:.1f} s",
            xy=(0.008, 0.97),
            xycoords="axes fraction",
            va="top",
            fontsize=9,
            color=INK,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.5, "alpha": 0.85},
        )
        panel.set_ylabel("tension [kN]")
        tidy(panel)
        print(f"{label}: peak {peak:.1f} kN, lift-off {lift_off:.2f} s")
    panels[0].set_ylim(0, 2350)
    panels[0].set_yticks([0, 500, 1000, 1500, 2000])
    panels[0].set_xlim(0, 40)
    panels[0].legend(ncols=5, fontsize=8, loc="upper right", frameon=False)
    panels[-1].set_xlabel("time [s]")
    return figure


def longer(name: str) -> gantline.Recording:
    """The lift with slings 2, 3 and 4 of 28 m, hoisted 2 m further."""
    text = LIFTS[name].read_text(encoding="utf-8")
    for old, new in (
        ("26 m", "28 m"),
        ("brake_from: 25 s", "brake_from: 45 s"),
        ("duration: 40 s", "duration: 60 s"),
    ):
        text = text.replace(old, new)
    # Sheaves end among the fixed ones, where parts of rope have no length: a fixed step gets past that.
    return gantline.simulate(parse_scenario(text, name), integrator="del", step=1e-3)


def draw_travel() -> Figure:
    """Travel of sheaves beside lengthening of slings, with the stroke that only sheaves have."""
    figure = Figure(figsize=(9.0, 5.6), layout="constrained")
    panels = figure.subplots(2, 2, sharex="row", sharey=True)
    rows = (
        ("slings of 23 and 26 m", [gantline.simulate(LIFTS[name]) for name in LIFTS]),
        ("slings of 23 and 28 m", [longer(name) for name in LIFTS]),
    )
    for row, (label, (real, approximated)) in zip(panels, rows, strict=True):
        columns = (
            (f"sheaves travel, {label}", real, "sheave_travel", [f"e1.{k}" for k in range(1, 6)]),
            (f"slings lengthen, {label}", approximated, "rope_lengthening", [f"sling.{s}" for s in SLINGS]),
        )
        for panel, (title, run, variable, names) in zip(row, columns, strict=True):
            for index, name in enumerate(names):
                width = 2.4 if index < 3 else 1.1
                values = run.column(variable, name)
                panel.plot(run.time, values, color=colour(index), lw=width, label=SLINGS[index])
                print(
                    f"{title}: {name} ends at {values[-1]:+.3f} m, {values.min():+.3f} to {values.max():+.3f}"
                )
            if run is real:
                for end in (-1.4, 1.9):
                    panel.axhline(end, color="#a02020", lw=1.0, ls="--")
                panel.annotate("end of stroke", (0.4, 1.9), va="bottom", fontsize=8, color="#a02020")
            else:
                panel.plot(run.time, run.column("sheave_travel", "e1.1"), color=INK, lw=1.2, ls=(0, (4, 2)))
                panel.annotate(
                    "sheave travel: none", (run.time[-1], 0.0), ha="right", va="bottom", fontsize=8
                )
            panel.set_title(title, fontsize=9.5)
            tidy(panel)
    panels[0][0].set_ylim(3.3, -2.5)
    panels[0][1].legend(ncols=1, fontsize=8, loc="lower left", frameon=False)
    for row in panels:
        row[0].set_ylabel("down, longer [m]")
    for panel in panels[1]:
        panel.set_xlabel("time [s]")
    return figure


def radius(kind: str, factor: float, reach: float) -> float:
    """Spectral radius of a step."""
    return float(np.abs(np.linalg.eigvals(step_map(kind, reach, 1.0, factor))).max())


def draw_stability() -> Figure:
    """Left: where differences grow, by the map of a step. Right: that they do, step by step, in the lift."""
    figure = Figure(figsize=(9.0, 3.9), layout="constrained")
    limits, lift = figure.subplots(1, 2)
    factors, reaches = np.linspace(0.0, 3.0, 151), np.linspace(0.02, 4.0, 140)
    for kind, tone, place in (("explicit", ORANGE, (1.04, 3.7)), ("del", BLUE, (2.02, 0.9))):
        radii = np.array([[radius(kind, f, r) for f in factors] for r in reaches])
        limits.contourf(factors, reaches, radii, levels=[1.0 + 1e-9, 1e9], colors=[tone], alpha=0.22)
        limits.contour(factors, reaches, radii, levels=[1.0 + 1e-9], colors=[tone], linewidths=1.6)
        limits.annotate(kind, place, color=tone, fontsize=10, weight="bold")
    limits.annotate("unstable by explicit,\nstable by del", (1.08, 2.6), fontsize=8.5, color=INK)
    limits.annotate("stable\nby both", (0.3, 0.9), fontsize=8.5, color=INK)
    limits.annotate("unstable\nby both", (2.38, 0.2), fontsize=8.5, color=INK)
    limits.set_xlabel("factor f")
    limits.set_ylabel("step × ω, mass between two ropes")
    limits.set_title("where differences of tension grow", fontsize=9.5)
    tidy(limits)
    run = gantline.simulate(LIFTS["mechanisms"], adjusting_factor=2.05, duration=20.0, sample_interval=1e-3)
    shown = (run.time > 19.0) & (run.time < 19.021)
    for index in (0, 2, 4):
        sling = SLINGS[index]
        tension = run.column("rope_tension", f"sling.{sling}")[shown] / 1e3
        lift.plot(
            1e3 * (run.time[shown] - 19.0),
            tension,
            color=colour(index),
            lw=1.6,
            marker="o",
            ms=3.5,
            label=sling,
        )
    lift.set_ylim(0, 640)
    lift.set_xlabel("time after 19 s [ms]")
    lift.set_ylabel("tension, every step [kN]")
    lift.set_title("the reference lift by del, 1 ms, f = 2.05", fontsize=9.5)
    lift.legend(fontsize=8.5, frameon=True, framealpha=0.9, edgecolor="none", loc="upper right", ncols=3)
    tidy(lift)
    return figure


def main() -> None:
    """Draw all."""
    for name, draw in (("tension", draw_tension), ("travel", draw_travel), ("stability", draw_stability)):
        with matplotlib.rc_context(RC):
            path = FOLDER / f"mechanisms_{name}.png"
            draw().savefig(path, dpi=DOTS_PER_INCH, metadata={"Software": None})


if __name__ == "__main__":
    main()
