"""In which seas a lift may be done: its plan, simulated in sea after sea and held against its limits."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, replace
from functools import partial
from numbers import Integral
from pathlib import Path
from typing import Any

from gantline.arguments import told
from gantline.assembly.afloat.steepness import highest_sea
from gantline.results.afloat.sea_grid import SeaGrid
from gantline.results.file.saved import digest_of
from gantline.results.file.saved_json import number_in
from gantline.scenario import Scenario, load_scenario
from gantline.simulation import Simulation
from gantline.study.kept_runs import KeptRuns, RunKind, kept_runs
from gantline.study.sea import NoSeaError, Sea, SeaRecord
from gantline.study.side_by_side import SideBySide
from gantline.units import si_text

__all__ = ["SeasResult", "run_seas"]

_RUNS = RunKind(
    "run in a sea",
    {"height": number_in, "period": number_in, "direction": number_in, "record": number_in},
    SeaRecord.from_json,
)
#: A full turn, and rounding of it [rad]: 180 stands for degrees.
_ROUND = math.tau * (1 + 1e-9)


@dataclass(frozen=True)
class SeasResult(SeaGrid[Sea]):
    """A lift in the seas of a grid.

    Attributes:
        title: Title of the lift.
        scenario: Text of its lift file.
        waves: Name of the waves in it that were varied.
        is_regular: Whether these are all alike.
        records: Records of each sea that were asked for.
        seas: All seas of the grid, by direction, period and height.
        interrupted: Whether Ctrl-C ended it before all were run.
        duration: What each run was to simulate [s].
        taken_over: How many runs were taken from those that had been kept.
    """

    title: str
    scenario: str
    waves: str
    is_regular: bool
    records: int
    seas: Sequence[Sea]
    interrupted: bool = False
    duration: float = 0.0
    taken_over: int = 0

    def __repr__(self) -> str:
        run = sum(bool(sea.records) for sea in self.seas)
        return f"<SeasResult {self.title!r}: {len(self.seas)} seas of {self.waves!r}, {run} of them run>"

    def allowed_height(self, direction: float, period: float) -> float | None:
        """Largest height of the grid up to which the lift is a go, with warnings or without [m].

        None where it is none in the lowest sea. A sea that was not run, or that is too steep, shows nothing.

        Raises:
            KeyError: If the grid has no such sea.
        """
        allowed = None
        for sea in self.of(direction, period):
            if not sea.is_allowed:
                break
            allowed = sea.height
        return allowed

    @property
    def is_allowed(self) -> bool:
        """Whether the lift is a go in every sea that there is; in those that were not run it is not."""
        return all(sea.is_allowed or sea.is_too_steep for sea in self.seas)

    def to_json(self) -> dict[str, Any]:
        """All of it as a JSON object, SI units."""
        return {
            "title": self.title,
            "scenario_sha256": digest_of(self.scenario),
            "waves": self.waves,
            "regular": self.is_regular,
            "records": self.records,
            "interrupted": self.interrupted,
            "duration": self.duration,
            "allowed": [
                {
                    "direction": direction,
                    "period": period,
                    "height": self.allowed_height(direction, period),
                }
                for direction in self.directions
                for period in self.periods
            ],
            "seas": [sea.to_json() for sea in self.seas],
        }


def run_seas(
    lift: str | Path | Scenario,
    *,
    waves: str | None = None,
    heights: Sequence[float] | None = None,
    periods: Sequence[float] | None = None,
    directions: Sequence[float] | None = None,
    records: int = 1,
    all_heights: bool = False,
    workers: int | None = None,
    kept: str | Path | None = None,
    anew: bool = False,
    on_progress: Callable[[str], None] | None = None,
    **overrides: Any,
) -> SeasResult:
    """Simulate a lift in each sea of a grid, and hold each run against its limits.

    Of each direction and period the lowest sea comes first, and no higher one than the first in which the
    lift is no go, unless `all_heights`. Seas that are steeper than any are left out. Runs go on side by side;
    what is found does not depend on how many. Ctrl-C ends it with what there is.

    Args:
        lift: A lift file, its folder, or a loaded scenario.
        waves: Name of the waves that are varied; may be left out where the lift has one.
        heights: Significant heights, of waves that are all alike their heights [m]; that of the file if None.
        periods: Peak periods, or periods [s]; that of the file if None.
        directions: Directions in which they run [rad]; that of the file if None.
        records: How many records of each sea: the seeds of all seas and gusts of the file, and those after.
        all_heights: Whether higher seas are run, too.
        workers: Runs at a time; None for as many as there are processors.
        kept: A file that each run is written to as soon as it ends, by one search at a time. Runs that it has
            already, of the same lift with the same settings, are taken from there: after Ctrl-C or a power
            cut the search goes on, and further seas and records cost no run that has been made.
        anew: Whether to begin that file anew.
        on_progress: Is told in words how far it is.
        overrides: Settings of `simulate`, such as `duration` [s].

    Raises:
        ScenarioError: If the lift file is not right.
        SettingError: If an override is not right.
        NoSeaError: If the lift has no such waves, nothing that differs from record to record, or a value is
            none that waves can have; a ValueError.
        KeptRunsError: If `kept` is of another lift, or of nothing of the kind, or another study writes to it;
            a ValueError.
        OSError: If `kept` cannot be read or written.
    """
    tell = told(on_progress) or (lambda _: None)
    scenario = lift if isinstance(lift, Scenario) else load_scenario(lift)
    name = _name_of(scenario, waves)
    train = (scenario.waves or {})[name]
    if isinstance(records, bool) or not isinstance(records, Integral):
        raise NoSeaError("records", f"{records!r} is no whole number from 1 on")
    if records < 1:
        raise NoSeaError("records", f"{records} are none")
    if records > 1 and not _seeds(scenario):
        sentence = "waves that are all alike, without gusts, are the same in every record; one is right"
        raise NoSeaError("records", sentence)
    heights = sorted(_values("heights", heights, train.main_height))
    seas = [
        Sea(height, period, direction, highest_sea(scenario, name, period))
        for direction in _values("directions", directions, train.direction, least=-math.inf)
        for period in _values("periods", periods, train.main_period)
        for height in heights
    ]
    # What is wrong with the lift as such, or with a setting, is no matter of a sea.
    simulation = Simulation(scenario, **overrides)
    path = None if kept is None else Path(kept)
    interrupted, numbers = False, range(1, records + 1)
    with (
        kept_runs(path, _RUNS, simulation, anew=anew, waves=name) as known,
        SideBySide(workers) as pool,
    ):
        try:
            for height in heights:
                pending = {
                    place: [
                        _submit(pool, scenario, name, (seas[place], number), overrides, known)
                        for number in numbers
                    ]
                    for place in _worth_a_run(seas, height, all_heights=all_heights)
                }
                for place, runs in pending.items():
                    tell(f"{sum(len(sea.records) for sea in seas)} runs done, height {height:g} m")
                    seas[place] = replace(seas[place], records=tuple(run.result() for run in runs))
        except KeyboardInterrupt:
            interrupted = True
            pool.give_up()
    title, text = scenario.lift.title, scenario.text
    return SeasResult(
        title,
        text,
        name,
        train.is_regular,
        records,
        seas,
        interrupted,
        simulation.duration,
        known.taken_over,
    )


def _worth_a_run(seas: Sequence[Sea], height: float, *, all_heights: bool) -> list[int]:
    """Places of the seas of a height [m] that there are, and below which the lift is no go nowhere."""
    ended = {(sea.direction, sea.period) for sea in seas if sea.is_refused and not all_heights}
    return [
        place
        for place, sea in enumerate(seas)
        if sea.height == height and not sea.is_too_steep and (sea.direction, sea.period) not in ended
    ]


def _name_of(scenario: Scenario, wanted: str | None) -> str:
    """The waves that are meant."""
    names = list(scenario.waves or {})
    if not names:
        right = "waves: {sea: {significant_height: 1.5 m, peak_period: 8 s, direction: 180 deg}}"
        raise NoSeaError("waves", f"there are none in this lift; some are written like '{right}'")
    if wanted is None and len(names) > 1:
        raise NoSeaError("waves", f"the lift has {', '.join(names)}; name one of them")
    if wanted is not None and wanted not in names:
        raise NoSeaError("waves", f"the lift has no '{wanted}'; it has {', '.join(names)}")
    return names[0] if wanted is None else wanted


def _values(name: str, given: Sequence[float] | None, own: float, least: float = 0.0) -> list[float]:
    """Values of one axis, each once."""
    try:
        values = [own] if given is None else list(dict.fromkeys(float(value) for value in given))
    except (TypeError, ValueError):
        raise NoSeaError(name, f"{given!r} is no list of numbers, in m, s or rad") from None
    if not values:
        raise NoSeaError(name, "there are none")
    for value in values:
        if not (math.isfinite(value) and value > least):
            raise NoSeaError(name, f"{value:g} is none that waves can have")
        if name == "directions" and abs(value) > _ROUND:
            sentence = f"{value:.6g} rad are more than a full turn"
            raise NoSeaError(name, f"{sentence}; {math.pi:.5g} rad are 180 deg")
    return values


def _seeds(scenario: Scenario) -> dict[str, int]:
    """Seeds of all that differs from record to record, by their paths."""
    seeds = {
        f"waves.{name}.seed": train.seed
        for name, train in (scenario.waves or {}).items()
        if not train.is_regular
    }
    gusts = getattr(scenario.wind, "gusts", None)
    return seeds if gusts is None else {**seeds, "wind.gusts.seed": gusts.seed}


def _submit(
    pool: SideBySide,
    scenario: Scenario,
    name: str,
    wanted: tuple[Sea, int],
    overrides: Mapping[str, Any],
    kept: KeptRuns[SeaRecord],
) -> Future[SeaRecord]:
    """A record of a sea, by its number: run, or taken from those that are kept."""
    sea, number = wanted
    train = (scenario.waves or {})[name]
    height, period = ("height", "period") if train.is_regular else ("significant_height", "peak_period")
    changes: dict[str, Any] = {
        f"waves.{name}.{height}": si_text(sea.height, "length"),
        f"waves.{name}.{period}": si_text(sea.period, "time"),
        f"waves.{name}.direction": si_text(sea.direction, "angle"),
    }
    if number > 1:
        changes |= {path: seed + number - 1 for path, seed in _seeds(scenario).items()}

    place = {"height": sea.height, "period": sea.period, "direction": sea.direction, "record": number}
    make = partial(
        SeaRecord.of, lambda: scenario.changed(changes), overrides, goes_on=pool.goes_on, number=number
    )
    return pool.submit(partial(kept.made, place, make, pool.goes_on))
