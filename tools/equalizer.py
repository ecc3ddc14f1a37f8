"""Draws the pictures of `docs/concepts/equalizer.md`, and prints their figures.

`equalizer_adjustment.png`: the sequence of Fig. 6 of Ham, Roh and Lee (2016), simulated and in closed form.
`equalizer_extension.png`: a load with four lugs on one sling of a hook, by extension sheaves.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.figure import Figure

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
        travels.plot(exact.time, exact.travel[:, i], label=f"$p_{i}$", **style)
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


def main() -> None:
    """Draw all."""
    for name, draw, dots in (
        ("adjustment", draw_adjustment, DOTS_PER_INCH),
        ("extension", draw_extension, DOTS_PER_INCH // 2),
    ):
        with matplotlib.rc_context(RC):
            path = FOLDER / f"equalizer_{name}.png"
            draw().savefig(path, dpi=dots, metadata={"Software": None})


if __name__ == "__main__":
    main()
