"""`gantline statics LIFT --sweep PATH=FROM..TO/N`: how a lift hangs over the values of one quantity."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import typer

from gantline.cli.messages import (
    CHECK_FAILED,
    COULD_NOT_GO_ON,
    DONE,
    INTERRUPTED,
    NO_VERDICT,
    scenario_errors,
    stop,
    warn,
)
from gantline.cli.spans import count_of

if TYPE_CHECKING:
    from gantline.study.state import State
    from gantline.study.sweep import SweepError, SweepPoint

_WRITTEN = "a sweep is written like 'cranes.hook.at.z=36 m..37 m/5', five values from 36 m to 37 m"


def sweep(lift: Path, text: str, time: float | None, *, as_json: bool = False) -> NoReturn:
    """Print the table of a sweep, and end.

    Args:
        lift: Lift file, folder, or name of a lift that comes with gantline.
        text: The sweep as it stands behind its option.
        time: Time of the plan [s]; None for the end of the lift.
        as_json: Whether all numbers are printed as JSON in place of the table.

    Raises:
        typer.Exit: Always; with 1 where a check fails, a lift is unstable or cannot start, with 3 where it
            falls, with 4 where nothing hangs at that time, and with 130 where Ctrl-C ended it with what there
            was.
    """
    path, first, last, count = _read(text)
    with scenario_errors():
        from gantline.cli.cases_table import nothing_hangs
        from gantline.cli.check_table import width_of_terminal
        from gantline.cli.lift import refuse_beyond
        from gantline.cli.progress import telling
        from gantline.interrupt import noted_interrupt
        from gantline.scenario import load_scenario
        from gantline.scenario.file.tree_path import PathError
        from gantline.study import SweepPoint, run_sweep
        from gantline.study.sweep import SweepError
        from gantline.units import UnitError

        scenario = load_scenario(lift)
        refuse_beyond(scenario, time)
        try:
            points = list[SweepPoint]()
            with telling("sweep") as tell, noted_interrupt() as is_interrupted:
                for point in run_sweep(scenario, path, first, last, count, time):
                    points.append(point)
                    tell(f"{len(points)} of {count} values")
                    if is_interrupted():
                        break
        except (PathError, UnitError) as problem:
            stop(f"--sweep: {problem}")
        except SweepError as problem:
            stop(_wrong_value(path, problem))
    if as_json:
        found = [{"value": point.value, **point.state.to_json()} for point in points]
        document = {"path": path, "left_out": scenario.left_out_at_rest, "points": found}
        typer.echo(json.dumps(document, indent=2, allow_nan=False))
    else:
        typer.echo("\n".join([*scenario.left_out_at_rest, *_lines(path, points, width_of_terminal())]))
    if len(points) < count:
        warn(f"interrupted after {len(points)} of {count} values")
        raise typer.Exit(INTERRUPTED)
    if any(point.state.starts and point.state.rest is None for point in points):
        raise typer.Exit(COULD_NOT_GO_ON)
    states = [point.state for point in points]
    if not all(state.is_sound for state in states):
        raise typer.Exit(CHECK_FAILED)
    raise typer.Exit(NO_VERDICT if nothing_hangs(states) else DONE)


def _wrong_value(path: str, problem: SweepError) -> str:
    """What a value makes wrong, a line each; the lift file has no line that says it."""
    from gantline.scenario.errors import ScenarioError

    elsewhere = [
        replace(one, line=None, path="" if one.path == path else one.path) for one in problem.problems
    ]
    return str(ScenarioError(f"--sweep: {path}={problem.value}", elsewhere))


def _read(text: str) -> tuple[str, str, str, int]:
    """Path, first and last value as written, and how many."""
    path, equals, values = (word.strip() for word in text.partition("="))
    span, slash, number = (word.strip() for word in values.rpartition("/"))
    first, dots, last = (word.strip() for word in span.partition(".."))
    if not (path and equals and slash and dots and first and last):
        stop(f"--sweep: '{text}' is no sweep; {_WRITTEN}")
    return path, first, last, count_of("--sweep", number)


def _lines(path: str, points: Sequence[SweepPoint], width: int) -> list[str]:
    """The table; slings that find no room beside the others stand below them."""
    from gantline.cli.cases_table import notes, nothing_hangs, outcome
    from gantline.cli.table import show, tables
    from gantline.study.state import QUANTITIES, values_of

    values = [values_of(point.state) for point in points]
    kinds = {
        "load_tilt": "{} tilt",
        "hook_load": "{} hook load",
        "hinge_force": "{} force",
        "sling_tension": "{}",
    }
    columns: list[list[str]] = []
    for kind, title in kinds.items():
        unit, digits = QUANTITIES[kind]
        for element in dict.fromkeys(name for one in values for name in one[kind]):
            cells = (show(one[kind].get(element), unit, digits) for one in values)
            columns.append([title.format(element), *cells])
    first = [path, *(_shown(point) for point in points)]
    last = ["", *(outcome([point.state]) for point in points)]
    parts = tables(first, columns, last, width=width)
    states = [point.state for point in points]
    why = list(notes(states, lambda found: _runs(points, found), width))
    why += _idle(path, states)
    why += textwrap.wrap(nothing_hangs(states), max(width, 60), initial_indent="  ", subsequent_indent="    ")
    return [line for part in (*parts, why) if part for line in (*part, "")][:-1]


def _idle(path: str, states: Sequence[State]) -> list[str]:
    """That a quantity decides nothing at rest, as one of waves that push no moored vessel."""
    from gantline.study.effect import is_as

    first = states[0]
    if any(state.rest is None or not is_as(state, first) for state in states):
        return []
    return [f"  nothing changes with {path}: forces, tilts and checks are alike, at rest"]


def _runs(points: Sequence[SweepPoint], found: Sequence[int]) -> str:
    """Values of some points; those one after another as from the first to the last."""
    runs: list[list[int]] = []
    for place in found:
        if runs and runs[-1][-1] == place - 1:
            runs[-1].append(place)
        else:
            runs.append([place])
    ends = ((_shown(points[run[0]]), _shown(points[run[-1]])) for run in runs)
    return ", ".join(first if first == last else f"{first} to {last}" for first, last in ends)


def _shown(point: SweepPoint) -> str:
    from gantline.units import in_unit

    return in_unit(point.value, point.dimension, point.unit)
