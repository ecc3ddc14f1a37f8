"""`gantline cases`: statics of a lift and of everything that may be otherwise than planned."""

from __future__ import annotations

import json
from typing import Annotated

import typer

from gantline.cli.lift import Lift, Moment, moment_of
from gantline.cli.messages import CHECK_FAILED, COULD_NOT_GO_ON, DONE, scenario_errors, stop


def cases(
    lift: Lift,
    time: Moment = None,
    variants: Annotated[
        bool, typer.Option("--variants", help="Show each variant of a case in a line of its own.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print all numbers as JSON.")] = False,
) -> None:
    """Find how a lift hangs in each of its cases, and the worst case of each element; nothing is simulated.

    Ends with code 1 where a check fails or an equilibrium is unstable, and with 3 where there is none.
    """
    moment = moment_of(time)
    with scenario_errors():
        from gantline.scenario import load_scenario
        from gantline.study import run_cases

        scenario = load_scenario(lift)
        if not scenario.cases:
            right = "cases: {heavy: {set: {load.weight.simulate: design}}}"
            stop(f"{scenario.source}: there are no 'cases' in this file; one is written like '{right}'")
        result = run_cases(scenario, moment)
    if as_json:
        typer.echo(json.dumps(result.to_json(), indent=2, allow_nan=False))
    else:
        from gantline.cli.cases_table import cases_table
        from gantline.cli.check_table import width_of_terminal

        typer.echo("\n".join(cases_table(result, width=width_of_terminal(), variants=variants)))
    if not result.has_equilibria:
        raise typer.Exit(COULD_NOT_GO_ON)
    raise typer.Exit(DONE if result.is_sound else CHECK_FAILED)
