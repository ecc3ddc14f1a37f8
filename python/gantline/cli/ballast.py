"""`gantline ballast`: contents of tanks with which a vessel floats as it is wanted."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated

import typer

from gantline.cli.lift import Lift, quantity_of
from gantline.cli.messages import COULD_NOT_GO_ON, DONE, scenario_errors, stop, writing
from gantline.cli.progress import telling
from gantline.replacing import replace_text


def ballast(
    lift: Lift,
    time: Annotated[
        str | None,
        typer.Option(
            metavar="TIME",
            help="Time of the plan at which it is wanted, such as '600 s'.  [default: the end of the lift]",
        ),
    ] = None,
    step: Annotated[
        str | None,
        typer.Option(metavar="NAME", help="In place of --time: a step of the plan, at its end."),
    ] = None,
    heel: Annotated[str, typer.Option(metavar="ANGLE", help="Wanted heel, to starboard positive.")] = "0 deg",
    trim: Annotated[str, typer.Option(metavar="ANGLE", help="Wanted trim, by the stern positive.")] = "0 deg",
    draft: Annotated[
        str | None,
        typer.Option(metavar="DRAFT", help="Wanted draft at half length, such as '4.4 m'.  [default: any]"),
    ] = None,
    tanks: Annotated[
        str | None,
        typer.Option(
            metavar="NAMES", help="Tanks whose contents may change, such as 'row1.1,row1.2'.  [default: all]"
        ),
    ] = None,
    vessel: Annotated[
        str | None, typer.Option(metavar="NAME", help="The vessel, where several have tanks.")
    ] = None,
    write: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write the lift file with these contents to a new file."),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print all numbers as JSON, SI units.")] = False,
) -> None:
    """Find contents of tanks with which a vessel floats as wanted at a moment of the plan.

    Everything that hangs on the vessel then counts, exactly. Of all contents that do it those with the least
    water moved are found, and how the vessel floats with them before the lift.

    Ends with code 3 where the tanks cannot do it.
    """
    moment = quantity_of("--time", time, "time")
    angles = {"--heel": quantity_of("--heel", heel, "angle"), "--trim": quantity_of("--trim", trim, "angle")}
    depth = quantity_of("--draft", draft, "length")
    if depth is not None and depth <= 0.0:
        stop(f"--draft: '{draft}' is no draft; more than 0 m is right")
    chosen = None if tanks is None else [name.strip() for name in tanks.split(",") if name.strip()]
    if write is not None and write.exists():
        stop(f"--write: {write} is there already; a new file is needed")
    with scenario_errors():
        from gantline.scenario import load_scenario
        from gantline.statics import NoEquilibriumError
        from gantline.study import CannotBeError, solve_ballast
        from gantline.study.ballast_question import QuestionError

        scenario = load_scenario(lift)
        try:
            with telling("ballast") as tell:
                answer = solve_ballast(
                    scenario,
                    vessel=vessel,
                    time=moment,
                    step=step,
                    heel=angles["--heel"] or 0.0,
                    trim=angles["--trim"] or 0.0,
                    draft=depth,
                    tanks=chosen,
                    on_progress=tell,
                )
        except (NoEquilibriumError, CannotBeError) as problem:
            stop(str(problem), COULD_NOT_GO_ON)
        except QuestionError as problem:
            stop(f"--{problem.argument}: {problem}")
        except ValueError as problem:
            stop(f"{scenario.source}: {problem}")
    if as_json:
        numbers = {**answer.to_json(), "left_out": scenario.left_out_at_rest}
        typer.echo(json.dumps(numbers, indent=2, allow_nan=False))
    else:
        from gantline.cli.ballast_table import report

        typer.echo("\n".join([*scenario.left_out_at_rest, *report(answer)]))
    if write is not None:
        with scenario_errors(), writing(write):
            replace_text(write, answer.text)
        typer.echo(f"\nLift file   {write}", err=as_json)
    raise typer.Exit(DONE)
