"""The race: gantline, its peers and the hand-written program on the lifts E(n), in one run.

    python -m benchmarks.race [--quick] [--lifts LIFT ...] [--only CODE ...] [--output FOLDER]
        [--references FOLDER]

Runs are interleaved: every code's every setting once, then all of it again. What is timed is integration with
the recording of all sling tensions a hundred times a second; models are built before. Table and picture go to
docs/benchmarks.
"""

from __future__ import annotations

import argparse
import math
import statistics
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from rich.console import Console

from benchmarks import race_report
from benchmarks.contract import Code, FloatArray, Setting, sample_count
from benchmarks.gantline_code import reference
from benchmarks.lifts import Lift, equalizer_lift, varied_lift
from benchmarks.measure import Errors, Point, errors
from benchmarks.worker import CODES, Worker

OUTPUT = Path(__file__).resolve().parents[1] / "docs" / "benchmarks"
BEGINNING = 1.2  # s, of the largest lift, for codes that need minutes for all of it
SLOW = ("OpenSim", "Exudyn, reeving")  # only the beginning of the largest lift
REPEATS = ((1.0, 5), (20.0, 3), (math.inf, 1))  # up to so many seconds a run, so many runs


@dataclass(frozen=True)
class Case:
    """A lift, or its beginning, and who solves it."""

    lift: Lift
    duration: float
    left_out: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """Of the lift, and how much of it."""
        part = "" if self.duration == self.lift.duration else f", first {self.duration:g} s"
        return self.lift.name + part


@dataclass
class Entry:
    """One setting of one code in one case, over all repeats."""

    setting: Setting
    seconds: list[float] = field(default_factory=list)
    errors: Errors | None = None
    failure: str = ""

    def wanted(self, repeat: int) -> bool:
        """Whether it runs once more."""
        if self.failure:
            return False
        longest = max(self.seconds, default=0.0)
        return repeat < next(count for limit, count in REPEATS if longest <= limit)

    def point(self) -> Point:
        """Its median."""
        seconds = statistics.median(self.seconds) if self.seconds else 0.0
        return Point(self.setting, seconds, self.errors, self.failure)


def cases(quick: bool) -> list[Case]:
    """What is raced."""
    small = [Case(equalizer_lift(n), 30.0) for n in (5, 20)]
    if quick:
        return small
    large = equalizer_lift(400)
    return [
        *small,
        Case(equalizer_lift(100), 30.0),
        Case(varied_lift(100), 30.0),
        Case(large, 30.0, left_out=SLOW),
        Case(large, BEGINNING),
    ]


class Race:
    """All cases with all codes that are installed."""

    def __init__(
        self, all_cases: Sequence[Case], codes: Sequence[Code], quick: bool, console: Console
    ) -> None:
        self._console, self._quick = console, quick
        self.cases = all_cases
        self.versions: dict[str, str] = {}
        self._workers: list[Worker] = []
        for code in codes:
            worker = Worker(code)
            version = worker.version()
            if version is None:
                console.print(f"{code.name} is not installed and left out")
                worker.stop()
                continue
            self.versions[code.name] = version
            self._workers.append(worker)
        self._references: dict[str, FloatArray] = {}
        self.entries: dict[tuple[str, str], list[Entry]] = {}
        for case in all_cases:
            for worker in self._workers:
                ladder = list(worker.code.settings(case.lift))
                if worker.code.name not in case.left_out and ladder:
                    thinned = ladder[::2] if quick else ladder
                    self.entries[case.name, worker.code.name] = [Entry(setting) for setting in thinned]

    def reference(self, lift: Lift) -> FloatArray:
        """Tensions of the whole lift by gantline at a tight tolerance."""
        if lift.name not in self._references:
            self._references[lift.name] = reference(lift)
        return self._references[lift.name]

    def run(self) -> Iterator[None]:
        """All rounds, one for each turn of the caller's loop."""
        for repeat in range(1 if self._quick else max(count for _, count in REPEATS)):
            for case, worker, entry in self._turn():
                if not entry.wanted(repeat):
                    continue
                outcome = worker.run(case.lift, entry.setting, case.duration)
                if outcome.tension is None:
                    entry.failure = outcome.failure
                    self._tell(f"{case.name}: {worker.code.name}, {entry.setting}: {outcome.failure}")
                    continue
                entry.seconds.append(outcome.seconds)
                if entry.errors is None:
                    entry.errors = self._errors(case, outcome.tension)
                    time = f"{1e3 * outcome.seconds / case.duration:.3g} ms/s"
                    name = f"{case.name}: {worker.code.name}, {entry.setting}"
                    self._tell(f"{name}: {time}, rms {entry.errors.rms:.2e}")
            yield
        for worker in self._workers:
            worker.stop()

    def _turn(self) -> Iterator[tuple[Case, Worker, Entry]]:
        for case in self.cases:
            for worker in self._workers:
                for entry in self.entries.get((case.name, worker.code.name), []):
                    yield case, worker, entry

    def _errors(self, case: Case, tension: FloatArray) -> Errors:
        whole = self.reference(case.lift)
        return errors(tension, whole[: sample_count(case.duration)], float(whole[-1].mean()))

    def _tell(self, line: str) -> None:
        self._console.print(line, highlight=False, markup=False, soft_wrap=True)

    def result(self) -> race_report.Result:
        """Medians so far, settings from tight to loose."""
        return race_report.Result(
            cases=[case.name for case in self.cases],
            durations={case.name: case.duration for case in self.cases},
            versions=self.versions,
            ladders={key: [entry.point() for entry in entries] for key, entries in self.entries.items()},
        )


def compare(race: Race, folder: Path) -> list[str]:
    """How far the references are from kept ones, `reference_n5.npz` and so on with `time` and `tension`."""
    lines = []
    for case in race.cases:
        path = folder / f"reference_n{case.lift.sheaves}.npz"
        if case.name != f"E({case.lift.sheaves})" or not path.exists():
            continue
        kept = np.load(path)
        samples = np.round(kept["time"] / (kept["time"][-1] / (len(kept["time"]) - 1))).astype(int)
        ours = race.reference(case.lift)
        stride = (len(ours) - 1) // (len(samples) - 1)
        difference = errors(ours[samples * stride], kept["tension"], float(kept["tension"][-1].mean()))
        lines.append(f"{case.name}: rms {difference.rms:.1e}, peak {difference.peak:.1e}")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two lifts, every other setting, once")
    parser.add_argument("--lifts", nargs="+", metavar="LIFT", help="which lifts, as 'E(5)' 'E(100) varied'")
    parser.add_argument("--references", type=Path, help="folder with references to compare gantline's with")
    parser.add_argument("--only", nargs="+", metavar="CODE", help="names of codes, or their beginnings")
    parser.add_argument("--output", type=Path, default=OUTPUT, help="where table and picture go")
    arguments = parser.parse_args()
    console = Console()
    wanted = tuple(arguments.only or [""])
    codes = [code for code in CODES if code.name.startswith(wanted)]
    raced = cases(arguments.quick and not arguments.lifts)
    raced = [case for case in raced if not arguments.lifts or case.name in arguments.lifts]
    if not raced:
        parser.error("no such lift: " + ", ".join(arguments.lifts))
    race = Race(raced, codes, arguments.quick, console)
    if arguments.references:
        for line in compare(race, arguments.references):
            console.print(f"gantline's reference against the kept one, {line}")
    for _ in race.run():  # written after each round: a race that is stopped leaves what it knows
        race_report.write(race.result(), arguments.output)
    race_report.show(race.result(), console)


if __name__ == "__main__":
    main()
