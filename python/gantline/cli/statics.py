"""`gantline statics`: how a lift hangs at rest, how it swings about that, what it answers to errors."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gantline.cli.lift import Lift, Moment, folder_option, moment_of, output_folder, refuse_beyond
from gantline.cli.messages import CHECK_FAILED, COULD_NOT_GO_ON, DONE, scenario_errors, stop, writing

if TYPE_CHECKING:
    from gantline.statics import Equilibrium, Mode, Statics
    from gantline.study.tilting import Margin

#: Modes that are shown where it is not said how many.
_MODES = 6


def statics(
    lift: Lift,
    time: Moment = None,
    modes: Annotated[int, typer.Option(min=0, help="How many natural motions to show.")] = _MODES,
    sensitivities: Annotated[
        bool, typer.Option("--sensitivities", help="Show what lengths, stiffness and weight change.")
    ] = False,
    margins: Annotated[
        bool,
        typer.Option(
            "--margins", help="Show how far the centre of gravity may be elsewhere, by solving anew."
        ),
    ] = False,
    sweep: Annotated[
        str | None,
        typer.Option(
            metavar="PATH=FROM..TO/N",
            help="Show tensions and tilt over N values of a quantity of the lift file, such as "
            "'cranes.hook.at.z=36 m..37 m/5'.",
        ),
    ] = None,
    level: Annotated[
        bool, typer.Option("--level", help="Find lengths of slings with which the load hangs level.")
    ] = False,
    want: Annotated[
        str | None,
        typer.Option(
            metavar="NAME=VALUE,…",
            help="Find lengths of slings for 'slope_x', 'slope_y' and 'heading' of the load, or a sling's "
            "share of it, such as 'heading=90 deg, S1=25 %'.",
        ),
    ] = None,
    plumb: Annotated[
        bool, typer.Option("--plumb", help="Find places of the hooks from which none is pulled aside.")
    ] = False,
    adjust: Annotated[
        str | None,
        typer.Option(metavar="NAME,…", help="Slings or hooks that these may change.  [default: all]"),
    ] = None,
    most: Annotated[
        str | None,
        typer.Option(metavar="LENGTH", help="Most by which a length may change.  [default: a tenth of it]"),
    ] = None,
    held: Annotated[
        bool,
        typer.Option(
            "--held", help="Let friction of contacts and sheaves hold what it can, from the start on."
        ),
    ] = False,
    state: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="Ask for the equilibrium of where a run had got to, by the state that it left.",
        ),
    ] = None,
    output: Annotated[
        Path | None,
        folder_option("Folder for the equilibrium and one period of each motion shown, as recordings."),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print all numbers as JSON, SI units, and nothing else.")
    ] = False,
) -> None:
    """Find the equilibrium of a lift, and its natural motions about it; nothing is simulated.

    An unstable equilibrium is told first, then the stable one that it leads to. Ends with code 1 where the
    equilibrium is unstable or a check fails, and with 3 where there is none.
    """
    moment = moment_of(time)
    if state is not None and (time is not None or sweep is not None):
        stop("--state: a run had got to a time of its own; --time and --sweep do not go with it")
    if sweep is not None:
        from gantline.cli.sweep import sweep as run_sweep

        if sensitivities or held or output is not None:
            stop(
                "--sweep: makes a table of many equilibria; --held, --sensitivities and --output are for one"
            )
        run_sweep(lift, sweep, moment, as_json=as_json)
    if (level or plumb or want is not None) and as_json:
        stop("--json: is for an equilibrium and --sweep; --level, --want and --plumb print tables")
    if level or plumb or want is not None:
        from gantline.cli.inverse import hang_as_wanted

        hang_as_wanted(
            lift, level=level, want=want, plumb=plumb, adjust=adjust, most=most, time=moment, output=output
        )
    if adjust is not None or most is not None:
        stop("--adjust and --most belong to --level, --want or --plumb")
    with scenario_errors():
        from gantline.statics import Statics

        question = Statics(lift)
    refuse_beyond(question.scenario, moment)
    from gantline.checks import check_recording, has_failed
    from gantline.cli import rest_table
    from gantline.cli.friction import contact_forces
    from gantline.cli.tilting import tilting_lines
    from gantline.cli.vessels import vessels_at_rest
    from gantline.study.tilting import tilting_of

    rest, bounds, ranges = _settled(question, moment, state, held=held)
    found = question.modes(max(modes, _MODES) + rest.unstable + rest.neutral)
    far = _margins(question, rest) if margins else []
    shown = found[: max(modes, rest.unstable)]
    if output is not None:
        _write(question, rest, shown, output, aside=as_json)
    checks = check_recording(rest.recording)
    is_sound = rest.is_stable and not has_failed(checks)
    if as_json:
        more = question.sensitivities() if sensitivities else []
        left_out = question.scenario.left_out_at_rest
        numbers = rest_table.statics_json(rest, bounds, shown, more, checks, left_out)
        typer.echo(json.dumps(numbers, indent=2, allow_nan=False))
        raise typer.Exit(DONE if is_sound else CHECK_FAILED)
    parts = [
        rest_table.heading_of(question, rest, found),
        rest_table.slings_of(rest, bounds),
        rest_table.ropes(rest),
        rest_table.hooks(rest),
        vessels_at_rest(question, rest),
        rest_table.loads(rest),
        tilting_lines(tilting_of(question, rest, found), far),
        contact_forces(rest) if rest.losses == "held" else [],
        ranges,
        rest_table.moving_sheaves(rest),
        rest_table.motions(shown),
        *(rest_table.changes(rest, question.sensitivities()) if sensitivities else []),
        rest_table.checks_at_rest(rest, checks),
    ]
    if not rest.is_stable:
        parts += _beyond(question, rest)
    typer.echo("\n".join(line for part in parts if part for line in (*part, "")))
    raise typer.Exit(DONE if is_sound else CHECK_FAILED)


def _settled(
    question: Statics, moment: float | None, state: Path | None, *, held: bool
) -> tuple[Equilibrium, list[Equilibrium], list[str]]:
    """The equilibrium; with all sheaves slipping one way and the other; lines on what friction may hold."""
    from gantline.cli.friction import stick_ranges
    from gantline.statics import NoEquilibriumError

    try:
        bounds = _bounds(question, moment) if state is None else []
        rest = _rest(question, moment, state, held=held)
        ranges = []
        if held and state is None and any(contact.bound > 0.0 for contact in rest.contacts):
            ranges = stick_ranges(question, rest)
            # Motions are those of the equilibrium found last.
            rest = _rest(question, moment, state, held=held)
    except NoEquilibriumError as problem:
        stop(str(problem), COULD_NOT_GO_ON)
    return rest, bounds, ranges


def _rest(question: Statics, moment: float | None, state: Path | None, *, held: bool) -> Equilibrium:
    """The equilibrium that was asked for."""
    if state is None:
        return question.equilibrium(moment, losses="held" if held else "none")
    try:
        return question.equilibrium_of(state.read_bytes())
    except OSError as problem:
        stop(f"--state: {state}: cannot be read ({(problem.strerror or str(problem)).lower()})")
    except ValueError as problem:
        if str(problem).endswith("cut off"):
            found = "is no state of a run, or is damaged or cut off"
            stop(f"--state: {state}: {found}; a run that cannot go on leaves one, 'state.bin'")
        stop(f"--state: {state}: {problem}")


def _beyond(question: Statics, rest: Equilibrium) -> list[list[str]]:
    """Where the lift goes that is left by itself."""
    from gantline.cli import rest_table
    from gantline.cli.vessels import vessels
    from gantline.statics import NoEquilibriumError

    try:
        beyond = question.step_off()
    except NoEquilibriumError as problem:
        return [[f"Left by itself it goes along motion 1: {problem}"]]
    if beyond is None:
        return []
    state = "the stable equilibrium there" if beyond.is_stable else "still not stable"
    head = [f"Left by itself it goes along motion 1; {state}:"]
    return [
        head,
        rest_table.slings_of(beyond, []),
        rest_table.hooks(beyond),
        vessels(beyond.recording),
        rest_table.loads(beyond),
    ]


def _bounds(question: Statics, moment: float | None) -> list[Equilibrium]:
    """With all sheaves slipping one way and the other; none where no sheave has losses."""
    if not any(sheave.has_losses for sheave in question.rig.sheaves):
        return []
    return [question.equilibrium(moment, losses="forward"), question.equilibrium(moment, losses="backward")]


def _margins(question: Statics, rest: Equilibrium) -> list[Margin]:
    """How far the centre of gravity may be elsewhere; nothing where there is no load."""
    from gantline.scenario.variants import without_cases
    from gantline.study.tilting import margins_of

    if not rest.recording.rig.loads:
        return []
    try:
        return margins_of(without_cases(question.scenario), rest)
    except ValueError as problem:
        stop(f"--margins: {problem}")


def _write(question: Statics, rest: Equilibrium, modes: list[Mode], folder: Path, *, aside: bool) -> None:
    from gantline.results.saved import EQUILIBRIUM
    from gantline.study.inclining import metacentric_heights

    place = output_folder(folder)
    found = metacentric_heights(question, rest)
    heights = {name: (one.transverse, one.longitudinal) for name, one in found.items()}
    with writing(place):
        written = [rest.with_modes(modes, heights).save(place / EQUILIBRIUM)]
        for mode in modes:
            written.append(question.swing(mode).save(place / f"motion_{mode.number + 1}.nc"))
    typer.echo("\n".join(f"Recording   {path}" for path in written), err=aside)
