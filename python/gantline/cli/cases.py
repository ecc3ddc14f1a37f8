"""`gantline cases`: statics of a lift and of everything that may be otherwise than planned."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

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
from gantline.cli.progress import telling

if TYPE_CHECKING:
    from gantline.scenario import Scenario
    from gantline.study.cases import CasesResult


def cases(
    lift: Lift,
    time: Moment = None,
    variants: Annotated[
        bool, typer.Option("--variants", help="Show each variant of a case in a line of its own.")
    ] = False,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print all numbers and checks as JSON, SI units.")
    ] = False,
    output: Annotated[
        Path | None,
        folder_option(
            "Folder for all numbers as cases.json; a report in the same folder shows the worst of them."
        ),
    ] = None,
) -> None:
    """Find how a lift hangs in each of its cases, and the worst case of each element; nothing is simulated.

    Ends with code 1 where a check fails, an equilibrium is unstable or a case cannot start, with 3 where
    there is no equilibrium, and with 4 where nothing hangs at that time. Ctrl-C ends it with what has been
    found by then, or a word that nothing has, and with 130.
    """
    moment = moment_of(time)
    with scenario_errors():
        from gantline.scenario import load_scenario
        from gantline.study import run_cases

        scenario = load_scenario(lift)
        refuse_beyond(scenario, moment)
        if not scenario.cases:
            right = "cases: {heavy: {set: {load.weight.simulate: design}}}"
            stop(f"{scenario.source}: there are no 'cases' in this file; one is written like '{right}'")
    with folder_in_use(output) as folder:
        with scenario_errors():
            try:
                with telling("cases") as tell:
                    result = run_cases(scenario, moment, on_progress=tell)
            except KeyboardInterrupt:
                warn(
                    "interrupted before the equilibrium of the lift as it is given was found: no case "
                    "is known"
                )
                raise typer.Exit(INTERRUPTED) from None
        _tell(scenario, result, folder, variants=variants, as_json=as_json)
    if result.not_done:
        warn(f"interrupted; not all variants of these were worked out: {', '.join(result.not_done)}")
        raise typer.Exit(INTERRUPTED)
    from gantline.cli.cases_table import nothing_hangs

    if not result.has_equilibria:
        raise typer.Exit(COULD_NOT_GO_ON)
    if not result.is_sound:
        raise typer.Exit(CHECK_FAILED)
    raise typer.Exit(NO_VERDICT if nothing_hangs(result.states) else DONE)


def _tell(
    scenario: Scenario, result: CasesResult, folder: Path | None, *, variants: bool, as_json: bool
) -> None:
    """Print what has been found, and write it into a folder if there is one."""
    from gantline.replacing import replace_text
    from gantline.results.file.saved import CASES

    text = json.dumps(result.to_json(), indent=2, allow_nan=False)
    if as_json:
        typer.echo(text)
    else:
        from gantline.cli.cases_table import cases_table
        from gantline.cli.check_table import width_of_terminal

        table = cases_table(result, width=width_of_terminal(), variants=variants)
        typer.echo("\n".join([*scenario.left_out_at_rest, *table]))
    if folder is not None:
        with writing(folder):
            replace_text(folder / CASES, text + "\n")
        typer.echo(f"Cases       {folder / CASES}", err=as_json)
