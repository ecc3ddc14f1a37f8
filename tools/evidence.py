"""Draws the pictures of the documentation that show how errors behave, and prints their figures.

`order.png`: rms error of sling tensions over tolerance and over steps, by `adaptive`.
`sideways.png`: a chain of masses 1,000,000 : 1 by `del` at h = 0.1 s, with and without geometric stiffness.
`measured_section.png`: motions of a floating section in waves, measured and simulated.
`lines_in_moordyn.png`: tensions of ropes whose end moves, by MoorDyn and by gantline.
`measured_drift.png`: forces of waves on that section, measured and simulated.
`measured_turning.png`: periods of a rod on two slings over how far it turns, measured and simulated.
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path

import matplotlib
import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import gantline
from gantline._core import Simulation
from gantline.hydro import read_database
from gantline.plot.style import RC

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT)]

from benchmarks.heaved_lines import LINES, SAMPLE_INTERVAL, tensions  # noqa: E402

from chain import STEP, shake  # noqa: E402
from rod_on_two_slings import AMPLITUDES, periods, records  # noqa: E402
from section_drift import DENSITY, FORCES, G, drift  # noqa: E402
from section_drift import MEASURED as PUSHED  # noqa: E402
from section_drift import SET_UPS as PUSHED_AS  # noqa: E402
from ship_section import FILE, LENGTH, MEASURED, simulated  # noqa: E402
from swinging import EA, RINGING, swinging  # noqa: E402

FloatArray = npt.NDArray[np.float64]
FOLDER = ROOT / "docs" / "images"
DOTS_PER_INCH = 150
BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#777777"
FACTORS = (30.0, 10.0, 3.0, 1.0, 0.3, 0.1, 0.03, 0.01, 1e-3)
#: Tolerances that count as no error: further below the last of the factors than it matters.
EXACT = 1e-4
#: Without it the sheaves would hum at 100 Hz for ever, and tight tolerances would have to follow that.
DAMPING_TIME = 5e-3  # s


def whole_lift(factor: float) -> tuple[FloatArray, int]:
    """Sling tensions of the reference lift with `factor` times its default tolerances, and steps."""
    recording = gantline.simulate(
        ROOT / "scenarios" / "equalizer", tension_tolerance=52.0 * factor, position_tolerance=1e-4 * factor
    )
    slings = [recording.column("rope_tension", f"sling.S{k}") for k in range(1, 6)]
    return np.stack(slings, axis=1) / 591e3, recording.attributes["counters"]["steps"]


def smooth_swing(factor: float) -> tuple[FloatArray, int]:
    """Sling tensions of a load that swings on ringing ropes for 20 s, nothing ever slack."""
    method = {"tension_tolerance": 52.0 * factor, "position_tolerance": 1e-4 * factor}
    settings = {"integrator": {"type": "adaptive", **method}, "duration": 20.0, "sample_interval": 0.02}
    run = Simulation(json.dumps(swinging(EA, RINGING, DAMPING_TIME)), json.dumps(settings))
    run.run()
    return np.array(run.columns()["rope_tension"])[:, 1:] / 981e3, run.counters()["steps"]


def draw_order() -> Figure:
    """Error over tolerance and over steps."""
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    over_tolerance, over_steps = figure.subplots(1, 2, sharey=True)
    cases = (
        ("reference lift, 40 s, with changes of modes", whole_lift, BLUE, "o"),
        ("swinging, ringing load, 20 s, smooth", smooth_swing, ORANGE, "s"),
    )
    for label, solve, colour, marker in cases:
        exact, _ = solve(EXACT)
        errors, steps = [], []
        for factor in FACTORS:
            tensions, count = solve(factor)
            errors.append(float(np.sqrt(np.mean((tensions - exact) ** 2))))
            steps.append(count)
            print(f"{label}: {52 * factor:8.3f} N  rms {errors[-1]:.2e}  steps {count}")
        style = {"color": colour, "marker": marker, "label": label, "markersize": 4.5}
        over_tolerance.loglog([52 * factor for factor in FACTORS], errors, **style)
        over_steps.loglog(steps, errors, **style)
        slope = np.polyfit(np.log(steps), np.log(errors), 1)[0]
        print(f"{label}: slope over steps {slope:.2f}")
    tolerances = np.array([0.1, 1000.0])
    over_tolerance.loglog(tolerances, 3e-7 * tolerances, color=GREY, lw=1, ls="--", label="∝ tolerance")
    counts = np.array([300.0, 2000.0])
    over_steps.loglog(counts, 6e-8 * (counts / 500) ** -5.0, color=GREY, lw=1, ls="--", label="∝ steps⁻⁵")
    over_tolerance.axvline(52.0, ymin=0.24, color=GREY, lw=0.8, ls=":")
    over_tolerance.annotate("default", (52.0, 2e-9), (62.0, 2e-9), color=GREY, fontsize=8)
    over_tolerance.axhline(5e-3, color=GREY, lw=0.8, ls=":")
    over_tolerance.annotate("0.5 %", (0.06, 5e-3), (0.06, 5.8e-3), color=GREY, fontsize=8)
    over_tolerance.set_ylim(top=1.5e-2)
    over_tolerance.set_xlabel("tension tolerance [N]")
    over_tolerance.set_ylabel("rms error of sling tension / static tension")
    over_steps.set_xlabel("steps")
    for axes in (over_tolerance, over_steps):
        tidy(axes)
        axes.legend(fontsize=8, frameon=False)
    return figure


def draw_sideways() -> Figure:
    """Largest sideways displacement over time, and the shape of the chain after the first steps."""
    figure = Figure(figsize=(9.0, 4.2), layout="constrained")
    grid = figure.add_gridspec(1, 3, width_ratios=(2.2, 1, 1))
    over_time = figure.add_subplot(grid[0])
    runs = {True: shake(10.0, geometric_stiffness=True), False: shake(10.0, geometric_stiffness=False)}
    for used, label, colour in ((False, "without", ORANGE), (True, "with", BLUE)):
        run = runs[used]
        over_time.semilogy(run.time, run.largest, color=colour, marker=".", ms=4, lw=1)
        at = 0.62 * run.time[-1]
        place = float(np.interp(at, run.time, run.largest)) * (12 if used else 2e-3)
        over_time.annotate(f"{label} geometric stiffness", (at, place), color=colour, ha="center", fontsize=9)
        print(f"{label}: largest [m] at the first steps {run.largest[:4]}, at the end {run.largest[-1]:.2e}")
    over_time.axhline(runs[True].largest[0], color=GREY, lw=0.8, ls=":")
    over_time.annotate("start, 1 µm", (0.2, 1.4e-6), color=GREY, fontsize=8)
    over_time.set_xlabel("time [s], a dot a step")
    over_time.set_ylabel("largest sideways displacement [m]")
    over_time.set_ylim(top=1e4)
    tidy(over_time)
    for column, used, label, colour in ((1, False, "without", ORANGE), (2, True, "with", BLUE)):
        axes = figure.add_subplot(grid[column])
        run = runs[used]
        for step, alpha in ((0, 0.25), (1, 0.5), (2, 1.0)):
            x = np.concatenate([[0.0], run.sideways[step]])
            z = np.concatenate([[0.0], run.height[step]])
            axes.plot(x, z, color=colour, alpha=alpha, lw=1.3, marker="o", ms=3, zorder=step)
            axes.plot(x[[1, -1]], z[[1, -1]], color=colour, alpha=alpha, ls="", marker="s", ms=8)
        axes.set_title(f"{label}, steps 0, 1, 2", fontsize=9)
        axes.set_xlabel("sideways [m]")
        axes.set_xlim(-1.0, 1.0)
        axes.set_ylim(-33, 1)
        axes.axhline(0, color=GREY, lw=3)
        if column == 1:
            axes.set_ylabel("height [m]")
        else:
            axes.set_yticklabels([])
        tidy(axes)
    print(f"h = {STEP} s")
    return figure


#: Look of a set-up of the measured section by the motion that is held.
SET_UPS = {
    None: ("free to sway, heave and roll", BLUE, "o"),
    "roll": ("roll held", ORANGE, "s"),
    "sway": ("sway held", GREEN, "^"),
}


def draw_section() -> Figure:
    """Motions of a floating section over the period of waves, measured and simulated."""
    figure = Figure(figsize=(9.0, 3.9), layout="constrained")
    panels = figure.subplots(1, 3)
    motions = (
        ("sway / wave amplitude", "linear", (0.0, 1.3)),
        ("heave / wave amplitude", "linear", (0.0, 2.2)),
        ("roll / wave slope", "log", (0.03, 30.0)),
    )
    for held, (label, colour, marker) in SET_UPS.items():
        measured = [one for one in MEASURED if one.held == held]
        periods = np.unique(np.concatenate([np.linspace(0.62, 1.54, 24), np.linspace(1.14, 1.36, 23)]))
        with tempfile.TemporaryDirectory() as folder:
            runs = [simulated(Path(folder), 2 * np.pi / period, 0.012, held) for period in periods]
        for axes, found, known in zip(
            panels, zip(*runs, strict=True), ("sway", "heave", "roll"), strict=True
        ):
            if known == held:
                continue
            axes.plot(periods, found, color=colour, lw=1.4)
            values = [getattr(one, known) for one in measured]
            places = [one.period for one in measured]
            axes.plot(
                places, values, color=colour, marker=marker, ls="", ms=5.5, mfc="white", mew=1.4, label=label
            )
    for axes, (label, scale, limits) in zip(panels, motions, strict=True):
        axes.set_xlabel("period of waves [s]")
        axes.set_ylabel(label)
        axes.set_ylim(*limits)
        axes.set_yscale(scale)
        tidy(axes)
    handles, labels = (panels[1].get_legend_handles_labels()[k] for k in (0, 1))
    figure.legend(handles, labels, loc="outside upper center", ncols=3, frameon=False, fontsize=9)
    return figure


def draw_lines() -> Figure:
    """Tensions at the lower end, or at the end that does not move, by MoorDyn and by gantline."""
    rows = (ROOT / "tests" / "validation" / "lines_in_moordyn.csv").read_text(encoding="utf-8").splitlines()
    names, kept = rows[2].split(","), np.loadtxt(rows[3:], delimiter=",")
    figure = Figure(figsize=(9.0, 5.6), layout="constrained")
    for axes, line in zip(figure.subplots(2, 2).flat, LINES, strict=True):
        own = tensions(line)[:, 1] / 1e3
        every = slice(4, None, 8)
        theirs = kept[every, names.index(f"{line.name}: last")]
        times = kept[every, 0]
        axes.plot(times, theirs, "o", color=ORANGE, ms=3.2, mfc="white", mew=0.9, label="MoorDyn")
        axes.plot(SAMPLE_INTERVAL * np.arange(len(own)), own, color=BLUE, lw=1.2, label="gantline")
        axes.set_title(line.name, fontsize=10, loc="left")
        axes.set_xlim(0.0, 20.0)
        axes.set_ylim(bottom=0.0)
        axes.set_xlabel("time [s]")
        axes.set_ylabel("tension [kN]")
        tidy(axes)
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=2, frameon=False, fontsize=9)
    return figure


def draw_drift() -> Figure:
    """Mean forces of waves over their period by what is held, and amplitudes on the held section."""
    figure = Figure(figsize=(9.0, 5.4), layout="constrained")
    panels = figure.subplots(2, 3, sharex=True)
    for axes, set_up in zip(panels.flat, PUSHED_AS, strict=False):
        frequencies, forces = drift(set_up)
        axes.plot(2 * np.pi / frequencies, forces / (DENSITY * G * LENGTH / 2), color=BLUE, lw=1.4)
        for one in PUSHED:
            if one.set_up == set_up:
                _mark(axes, one.period, one.share, one.amplitude, ORANGE)
        axes.set_title(set_up, fontsize=9)
        axes.set_ylim(0.0, 1.2)
        axes.set_ylabel("mean force / ½ρga²L")
    axes = panels[1, 2]
    database = read_database(FILE)
    assert database.excitation is not None
    for motion, colour, name in ((1, BLUE, "sway"), (2, GREEN, "heave")):
        shown = database.frequencies > 3.5
        sizes = np.abs(database.excitation[shown, 0, motion]) / 1e3
        axes.plot(2 * np.pi / database.frequencies[shown], sizes, color=colour, lw=1.4, label=name)
        for shaken in FORCES:
            _mark(axes, shaken.period, getattr(shaken, name) / 1e3, shaken.amplitude, colour)
    axes.set_title("held: amplitudes", fontsize=9)
    axes.set_ylim(0.0, 2.0)
    axes.set_xlim(0.6, 1.55)
    axes.set_ylabel("force / wave amplitude [kN/m]")
    axes.legend(fontsize=8, frameon=False)
    for axes in panels.flat:
        tidy(axes)
    for axes in panels[1]:
        axes.set_xlabel("period of waves [s]")
    return figure


def _mark(axes: Axes, period: float, value: float, amplitude: float, colour: str) -> None:
    """One measured value, by the height of the waves."""
    marker = "s" if amplitude > 0.015 else "o"
    axes.plot(period, value, color=colour, marker=marker, ls="", ms=5, mfc="white", mew=1.3)


def draw_turning() -> Figure:
    """Periods of a rod on two slings over the amplitude of its turns, by the length of the slings."""
    figure = Figure(figsize=(9.0, 4.6), layout="constrained")
    axes = figure.subplots()
    hung = records()
    for length in sorted({one.length for one in hung}):
        with tempfile.TemporaryDirectory() as folder:
            curve = periods(Path(folder), length)
        wide = np.linspace(0.0, AMPLITUDES[-1], 100)
        axes.plot(wide, curve(wide), color=GREY, lw=1.4, zorder=1)
        axes.annotate(f"{length:.3f} m", (1.52, float(curve(1.5))), va="center", fontsize=8, color=GREY)
        for one in hung:
            if one.length == length:
                colour, marker = ((BLUE, "o"), (ORANGE, "s"), (GREEN, "^"))[one.series - 1]
                label = f"series {one.series}" if length == 0.494 else None
                axes.plot(
                    one.amplitudes, one.periods, ls="", color=colour, marker=marker, mfc="none", label=label
                )
    axes.set_xlim(0.0, 1.65)
    axes.set_xlabel("amplitude of the turn [rad]")
    axes.set_ylabel("period [s]")
    axes.legend(fontsize=9, frameon=False, loc="upper left")
    tidy(axes)
    return figure


def tidy(axes: Axes) -> None:
    """Light grid behind, no box."""
    axes.grid(True, which="major", color="#dddddd", lw=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def main() -> None:
    """Draw all."""
    pictures = (
        ("order", draw_order),
        ("sideways", draw_sideways),
        ("measured_section", draw_section),
        ("lines_in_moordyn", draw_lines),
        ("measured_drift", draw_drift),
        ("measured_turning", draw_turning),
    )
    for name, draw in pictures:
        with matplotlib.rc_context(RC):
            draw().savefig(FOLDER / f"{name}.png", dpi=DOTS_PER_INCH, metadata={"Software": None})


if __name__ == "__main__":
    main()
