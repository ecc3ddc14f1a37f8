"""Time of the everyday jobs of the command line, and where each goes.

    python -m benchmarks.jobs [SCENARIO ...]

Times are of whole processes, the least of three each: processor time, which other programs on the machine
disturb least, and wall time. The parts are found in a run of their own under the profiler, which costs Python
more than the core: they are shares of that run, without the interpreter's own start.
"""

from __future__ import annotations

import marshal
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

SCENARIOS = Path(__file__).resolve().parents[1] / "scenarios"
DEFAULT = ("equalizer", "floating_crane", "crane_barge_in_swell")
RUNS = 3
DONE = (0, 1, 4)  # exit codes: done, a check that failed, and no verdict

#: Functions whose time with all that they call is that of a part: end of the file's name, name.
PARTS = {
    "start-up": (("importlib._bootstrap>", "_find_and_load"),),
    "reading": (
        ("scenario/reading.py", "load_scenario"),
        ("hydro/database/__init__.py", "read_database"),
        ("results/netcdf.py", "load_recording"),
        ("cad/__init__.py", "read"),
    ),
    "simulating": (("gantline/simulation.py", "run"), ("statics/lift.py", "equilibrium")),
    "writing": (("results/netcdf.py", "save_recording"), ("report/page.py", "write_report")),
    "drawing": (("plot/pictures.py", "write_pictures"),),
}


def jobs(lift: Path, folder: Path) -> Iterator[tuple[str, ...]]:
    """Words after `gantline` of each job; the second one of a lift leaves what the later ones read."""
    recording = str(folder / lift.name / "recording.nc")
    yield "check", str(lift)
    yield "run", str(lift), "-o", str(folder / lift.name), "--no-plots", "--no-report"
    yield "run", str(lift), "-o", str(folder / lift.name)
    yield "statics", str(lift)
    yield "statics", str(lift), "--steps"
    yield "check", recording
    yield "report", recording
    yield "compare", recording, recording, "-o", str(folder / "compared")
    for structure in sorted(lift.glob("*.3docx")):
        yield "cad", "file", str(structure)


def finish(words: Sequence[str], *options: str) -> tuple[float, float]:
    """Run a job in a process of its own; its processor time and its wall time [s].

    Raises:
        RuntimeError: If it could not be done.
    """
    start, before = time.perf_counter(), os.times()
    done = subprocess.run(
        [sys.executable, *options, "-m", "gantline", *words], capture_output=True, text=True, check=False
    )
    if done.returncode not in DONE:
        raise RuntimeError(f"gantline {' '.join(words)}: {done.stderr}")
    after = os.times()
    used = after.children_user - before.children_user + after.children_system - before.children_system
    return used, time.perf_counter() - start


def shares(words: Sequence[str], folder: Path) -> dict[str, float]:
    """Share of each part in a profile of a job [1], and of all that is in no part."""
    profile = folder / "profile"
    finish(words, "-m", "cProfile", "-o", str(profile))
    # As `pstats` reads it: own and cumulated time by file, line and name.
    functions: dict[tuple[str, int, str], Any] = marshal.loads(profile.read_bytes())
    whole = sum(own for _, _, own, _, _ in functions.values())
    found = {
        part: sum(
            cumulated
            for (file, _, name), (_, _, _, cumulated, _) in functions.items()
            if any(file.endswith(ending) and name == wanted for ending, wanted in of_part)
        )
        / whole
        for part, of_part in PARTS.items()
    }
    return {**found, "else": 1.0 - sum(found.values())}


def measured(words: Sequence[str], folder: Path) -> list[str]:
    """Cells of a job: its words, least processor time and least wall time [ms], shares."""
    used, lasted = (min(times) for times in zip(*(finish(words) for _ in range(RUNS)), strict=True))
    short = [Path(word).name if os.sep in word else word for word in words]
    return [
        " ".join(short),
        f"{1e3 * used:,.0f}",
        f"{1e3 * lasted:,.0f}",
        *(f"{share:.0%}" for share in shares(words, folder).values()),
    ]


def main(names: Sequence[str]) -> None:
    table = Table("gantline", "processor [ms]", "wall [ms]", *PARTS, "else")
    for column in table.columns[1:]:
        column.justify = "right"
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        table.add_row(*measured(["--help"], folder))
        for name in names:
            for words in jobs(SCENARIOS / name, folder):
                table.add_row(*measured(words, folder))
    Console().print(table)


if __name__ == "__main__":
    main(sys.argv[1:] or DEFAULT)
