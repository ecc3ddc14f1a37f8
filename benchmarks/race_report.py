"""Tables and the work-precision picture of a race."""

from __future__ import annotations

import csv
import math
import platform
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from rich.console import Console
from rich.table import Table

from benchmarks.measure import TARGETS, Cost, Point, cost
from gantline.plot.style import COLOURS, INK, QUIET, RC

SUBJECT = "gantline"
# Colour, marker and dashes of each line: one colour for a code, dashes for its second model.
LOOKS = {
    "gantline": (0, "o", "-"),
    "C for E(n)": (2, "s", "-"),
    "C for E(n), vectorised": (2, "s", "--"),
    "MuJoCo": (1, "^", "-"),
    "MuJoCo, nested sheaves": (1, "^", "--"),
    "Exudyn, reeving": (3, "D", "-"),
    "Exudyn": (3, "D", "--"),
    "OpenSim": (7, "v", "-"),
}
SHOWN = (3e-7, 0.3)  # rms errors in the picture


@dataclass(frozen=True)
class Result:
    """Of a race."""

    cases: list[str]
    durations: dict[str, float]
    versions: dict[str, str]
    """By code, in order."""
    ladders: dict[tuple[str, str], list[Point]]
    """By case and code; settings from tight to loose."""

    def milliseconds(self, case: str, seconds: float) -> float:
        """Wall time for one simulated second [ms/s]."""
        return 1e3 * seconds / self.durations[case]

    def cost(self, case: str, code: str, target: float) -> Cost | None:
        """Of an rms error."""
        return cost(self.ladders.get((case, code), []), target)


def processor() -> str:
    """Its model, as the system tells it."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def rows(result: Result, target: float) -> list[list[str]]:
    """For each code its time per simulated second in every case, and how many times gantline's that is."""
    table = []
    for code in result.versions:
        cells = [code]
        for case in result.cases:
            if (case, code) not in result.ladders:
                cells.append("")
                continue
            found, own = result.cost(case, code, target), result.cost(case, SUBJECT, target)
            if found is None:
                reached = min(point.rms for point in result.ladders[case, code])
                cells.append(f"not below {100 * reached:.2g} %" if math.isfinite(reached) else "failed")
                continue
            text = f"{result.milliseconds(case, found.seconds):.3g}"
            if own is not None and code != SUBJECT:
                text += f" ({found.seconds / own.seconds:.3g} ×)"
            cells.append(text)
        table.append(cells)
    return table


def write(result: Result, folder: Path) -> None:
    """Page, picture and all points."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "race.md").write_text(page(result), encoding="utf-8")
    with rc_context(RC):
        picture(result).savefig(folder / "race.png")
    with (folder / "race.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["lift", "code", "setting", "value", "ms_per_s", "rms", "peak", "final", "failure"])
        for (case, code), ladder in result.ladders.items():
            for point in ladder:
                setting = [point.setting.method, point.setting.value]
                writer.writerow([case, code, *setting, *_numbers(result, case, point)])


def _numbers(result: Result, case: str, point: Point) -> list[str]:
    if point.errors is None:
        return ["", "", "", "", point.failure]
    numbers = [point.errors.rms, point.errors.peak, point.errors.final]
    return [f"{result.milliseconds(case, point.seconds):.4g}", *(f"{number:.3e}" for number in numbers), ""]


def page(result: Result) -> str:
    """The generated page."""
    versions = {code.split(",")[0]: version for code, version in result.versions.items()}
    versions = {("compiler" if code == "C for E(n)" else code): version for code, version in versions.items()}
    codes = ", ".join(f"{code} {version}" for code, version in versions.items())
    lines = [
        "# Race",
        "",
        "Written by `python -m benchmarks.race`; [Benchmarks](index.md) says what is compared and how.",
        "",
        "Wall milliseconds for one simulated second, one thread of a processor that calls itself "
        f"{processor()}; in brackets how many times gantline's time that is. "
        "Medians where there were several runs, interleaved.",
        "",
        f"Codes: {codes}.",
    ]
    for target in TARGETS:
        lines += ["", f"## At an rms error of {100 * target:g} %", ""]
        lines.append("| code | " + " | ".join(result.cases) + " |")
        lines.append("|---|" + "---:|" * len(result.cases))
        lines += ["| " + " | ".join(cells) + " |" for cells in rows(result, target)]
    lines += [
        "",
        "## All settings",
        "",
        "![Error against wall time for every code and setting](race.png)",
        "",
        "The numbers behind the picture are in `race.csv` beside this page.",
        "",
    ]
    return "\n".join(lines)


def show(result: Result, console: Console) -> None:
    """The tables on the terminal."""
    for target in TARGETS:
        title = f"ms per simulated second at an rms error of {100 * target:g} %"
        table = Table("code", *result.cases, title=title)
        for cells in rows(result, target):
            table.add_row(*cells)
        console.print(table)


def picture(result: Result) -> Figure:
    """Error against wall time, a panel per case, a line per code."""
    columns = min(3, len(result.cases))
    height = math.ceil(len(result.cases) / columns)
    figure = Figure(figsize=(3.6 * columns, 3.1 * height + 0.7), layout="constrained")
    panels = figure.subplots(height, columns, squeeze=False).ravel().tolist()
    for panel, case in zip(panels, result.cases, strict=False):
        _panel(panel, result, case)
    for panel in panels[len(result.cases) :]:
        panel.set_axis_off()
    for panel in panels[::columns]:
        panel.set_ylabel("rms error of sling tension")
    for panel in panels[len(result.cases) - columns : len(result.cases)]:
        panel.set_xlabel("wall time per simulated second [ms/s]")
    keys: dict[str, Any] = {str(line.get_label()): line for panel in panels for line in panel.get_lines()}
    named = [code for code in result.versions if code in keys]
    figure.legend(
        [keys[code] for code in named],
        named,
        loc="outside upper center",
        ncols=min(4, len(named)),
        fontsize=8.5,
    )
    return figure


def _panel(panel: Axes, result: Result, case: str) -> None:
    panel.set_title(case, loc="left", fontsize=10, fontweight="bold", color=INK)
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_ylim(*SHOWN)
    panel.grid(True, axis="both")
    for target in TARGETS:
        panel.axhline(target, color=QUIET, linewidth=0.8, linestyle=(0, (4, 3)), zorder=1)
        panel.annotate(
            f"{100 * target:g} %", (1.0, target), xycoords=("axes fraction", "data"), xytext=(3, 0),
            textcoords="offset points", ha="left", va="center", fontsize=7.5, color=QUIET,
        )  # fmt: skip
    for code in result.versions:
        ladder = result.ladders.get((case, code), [])
        points = [point for point in ladder if SHOWN[0] < point.rms < SHOWN[1]]
        if not points:
            continue
        colour, marker, dashes = LOOKS.get(code, (6, "x", ":"))
        panel.plot(
            [result.milliseconds(case, point.seconds) for point in points],
            [point.rms for point in points],
            color=COLOURS[colour],
            marker=marker,
            markersize=4.5,
            markerfacecolor=COLOURS[colour] if dashes == "-" else "white",
            markeredgewidth=0.9,
            linestyle=dashes,
            linewidth=2.4 if code == SUBJECT else 1.4,
            zorder=4 if code == SUBJECT else 3,
            label=code,
        )
