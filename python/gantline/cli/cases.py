"""`gantline cases`: a lift and everything that may be otherwise than planned, at rest or simulated."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from gantline.cli.kept import Continue, kept_file, taking_over, tell_of_going_on, tell_taken_over
from gantline.cli.lift import Lift, Moment, folder_in_use, folder_option, moment_of, refuse_beyond
from gantline.cli.messages import (
    CHECK_FAILED,
    COULD_NOT_GO_ON,
    DONE,
    INTERRUPTED,
    NO_VERDICT,
    scenario_errors,
    stop,
    warn,
    writing,
)
from gantline.cli.pictured import write_pictured
from gantline.cli.progress import telling

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from gantline.scenario import Scenario


def cases(
    lift: Lift,
    time: Moment = None,
    simulate: Annotated[
        bool,
        typer.Option(
            "--simulate",
            help="Simulate the whole plan of each, and hold it against the limits; --time is then that at "
            "whose rest the worst lengths are looked for.",
        ),
    ] = False,
    variants: Annotated[
        bool, typer.Option("--variants", help="Show each variant of a case in a line of its own.")
    ] = False,
    go_on: Continue = False,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print all numbers and checks as JSON, SI units.")
    ] = False,
    output: Annotated[
        Path | None,
        folder_option(
            "Folder for all numbers as cases.json, with --simulate as case_runs.json and a picture; a report "
            "in the same folder shows the worst of them."
        ),
    ] = None,
) -> None:
    """Find how a lift hangs in each of its cases, or simulate each, and the worst case of each element.

    Ends with code 1 where a check fails, an equilibrium is unstable or a case cannot start, with 3 where
    there is no equilibrium, and with 4 where nothing hangs at that time. With --simulate it ends with 1 where
    the lift is no go in a case, and with 4 where one gives no verdict or is not simulated. Ctrl-C ends it
    with what has been found by then, or a word that nothing has, and with 130.
    """
    moment = moment_of(time)
    if go_on and not simulate:
        stop("--continue: only runs are kept, no equilibria; with --simulate it is right")
    with scenario_errors():
        from gantline.scenario import load_scenario

        scenario = load_scenario(lift)
        refuse_beyond(scenario, moment)
        if not scenario.cases:
            right = "cases: {heavy: {set: {load.weight.simulate: design}}}"
            stop(f"{scenario.source}: there are no 'cases' in this file; one is written like '{right}'")
    from gantline.results.file.saved import KEPT_CASE_RUNS

    with folder_in_use(output) as folder:
        kept = kept_file(folder, KEPT_CASE_RUNS, go_on=go_on) if simulate else None
        with scenario_errors():
            try:
                with telling("cases") as tell:
                    if simulate:
                        with taking_over(kept):
                            found = _simulated(scenario, moment, tell, variants, kept, anew=not go_on)
                    else:
                        found = _at_rest(scenario, moment, tell, variants)
            except KeyboardInterrupt:
                what, how = ("run", "had ended") if simulate else ("equilibrium", "was found")
                warn(f"interrupted before the {what} of the lift as it is given {how}: no case is known")
                tell_of_going_on(kept)
                raise typer.Exit(INTERRUPTED) from None
        found.tell(folder, as_json=as_json)
    if found.not_done:
        what = "simulated" if simulate else "worked out"
        warn(f"interrupted; not all variants of these were {what}: {', '.join(found.not_done)}")
        tell_of_going_on(kept)
        raise typer.Exit(INTERRUPTED)
    raise typer.Exit(found.code)


@dataclass(frozen=True)
class _Found:
    """What is to be told of cases: as JSON and as a table, into which file, and the code to end with.

    Of runs also a picture, and how many were taken over.
    """

    document: dict[str, Any]
    table: list[str]
    file: str
    code: int
    not_done: Sequence[str]
    picture: Callable[[dict[str, Any]], Figure] | None = None
    taken_over: int = 0

    def tell(self, folder: Path | None, *, as_json: bool) -> None:
        """Print it, and write it into a folder if there is one."""
        from gantline.replacing import replace_text
        from gantline.results.file.saved import KEPT_CASE_RUNS

        text = json.dumps(self.document, indent=2, allow_nan=False)
        typer.echo(text if as_json else "\n".join(self.table))
        if folder is not None:
            numbers = folder / self.file
            with writing(folder):
                if self.picture is None:
                    replace_text(numbers, text + "\n")
                else:
                    picture = write_pictured(self.picture(self.document), text + "\n", numbers)
                    typer.echo(f"Picture     {picture}", err=as_json)
            typer.echo(f"Cases       {numbers}", err=as_json)
        tell_taken_over(self.taken_over, KEPT_CASE_RUNS, aside=as_json)


def _at_rest(scenario: Scenario, moment: float | None, tell: Callable[[str], None], variants: bool) -> _Found:
    from gantline.cli.cases_table import cases_table, nothing_hangs
    from gantline.cli.check_table import width_of_terminal
    from gantline.results.file.saved import CASES
    from gantline.study import run_cases

    result = run_cases(scenario, moment, on_progress=tell)
    table = cases_table(result, width=width_of_terminal(), variants=variants)
    code = NO_VERDICT if nothing_hangs(result.states) else DONE
    if not result.is_sound:
        code = CHECK_FAILED
    if not result.has_equilibria:
        code = COULD_NOT_GO_ON
    return _Found(result.to_json(), [*scenario.left_out_at_rest, *table], CASES, code, result.not_done)


def _simulated(
    scenario: Scenario,
    moment: float | None,
    tell: Callable[[str], None],
    variants: bool,
    kept: Path | None,
    *,
    anew: bool,
) -> _Found:
    from gantline.checks import Outcome
    from gantline.cli.case_runs_table import case_runs_table
    from gantline.cli.check_table import width_of_terminal
    from gantline.results.file.saved import CASE_RUNS
    from gantline.study import simulate_cases

    result = simulate_cases(scenario, moment, kept=kept, anew=anew, on_progress=tell)
    table = case_runs_table(result, width=width_of_terminal(), variants=variants)
    is_no_go = any(run.outcome is Outcome.NO_GO for run in result.runs)
    code = DONE if result.is_go else CHECK_FAILED if is_no_go else NO_VERDICT
    return _Found(
        result.to_json(), table, CASE_RUNS, code, result.not_done, _picture, taken_over=result.taken_over
    )


def _picture(document: dict[str, Any]) -> Figure:
    from gantline.plot.case_runs import case_runs_picture
    from gantline.results.file.saved_case_runs import SavedCaseRuns

    return case_runs_picture(SavedCaseRuns.from_json(document))
