"""`gantline statics`: how a lift hangs at rest, how it swings about that, what it answers to errors."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from gantline.cli.lift import Lift, Moment, moment_of, output_folder, refuse_beyond
from gantline.cli.messages import CHECK_FAILED, COULD_NOT_GO_ON, DONE, scenario_errors, stop, writing
from gantline.cli.statics_options import (
    Adjust,
    AsJson,
    Held,
    Level,
    Lost,
    Margins,
    Modes,
    Most,
    Output,
    Plumb,
    Sensitivities,
    StateFile,
    Steps,
    Sweep,
    Want,
    refuse_unrelated,
)

if TYPE_CHECKING:
    from concurrent.futures import Future

    from gantline.cli.rest_table import Answer
    from gantline.statics import Equilibrium, Losses, Mode, NoEquilibriumError, Statics
    from gantline.study.side_by_side import SideBySide
    from gantline.study.tilting import Margin

#: Modes that are shown where it is not said how many.
_MODES = 6


def statics(
    context: typer.Context,
    lift: Lift,
    time: Moment = None,
    modes: Modes = _MODES,
    sensitivities: Sensitivities = False,
    margins: Margins = False,
    sweep: Sweep = None,
    level: Level = False,
    want: Want = None,
    plumb: Plumb = False,
    adjust: Adjust = None,
    most: Most = None,
    held: Held = False,
    steps: Steps = False,
    lost: Lost = None,
    state: StateFile = None,
    output: Output = None,
    as_json: AsJson = False,
) -> None:
    """Find the equilibrium of a lift, and its natural motions about it; nothing is simulated.

    An unstable equilibrium is told first, then the stable one that it leads to. Ends with code 1 where the
    equilibrium is unstable or a check fails, with 3 where there is none, and with 4 where checks give no
    verdict.
    """
    refuse_unrelated(context)
    moment = moment_of(time)
    if sweep is not None:
        from gantline.cli.sweep import sweep as run_sweep

        run_sweep(lift, sweep, moment, as_json=as_json)
    if steps:
        from gantline.cli.steps_at_rest import steps as run_steps

        run_steps(_question(lift, moment), held=held, as_json=as_json)
    if lost is not None:
        from gantline.cli.lost_load import lose

        lose(_question(lift, moment), lost, moment, held=held, output=output, as_json=as_json)
    if level or plumb or want is not None:
        from gantline.cli.inverse import hang_as_wanted

        hang_as_wanted(
            lift,
            level=level,
            want=want,
            plumb=plumb,
            adjust=adjust,
            most=most,
            time=moment,
            output=output,
            as_json=as_json,
        )
    question = _question(lift, moment)
    answer = _answer(question, moment, state, held=held, modes=modes)
    if margins:
        answer.margins = _margins(question, answer.rest)
    if output is not None:
        _write(question, answer.rest, answer.shown, output, aside=as_json)
    text = _as_json if as_json else _as_tables
    typer.echo(text(question, answer, sensitivities))
    raise typer.Exit(_code(answer))


def _code(answer: Answer) -> int:
    """The code that the program ends with: of the worst of the equilibrium and its bounds."""
    from gantline.checks import has_failed
    from gantline.cli.check_table import exit_code

    if answer.nowhere:
        return COULD_NOT_GO_ON
    if not answer.rest.is_stable or any(has_failed(checks) for checks in answer.of_bounds):
        return CHECK_FAILED
    return exit_code(answer.checks) if answer.checks else DONE


def _question(lift: Path, moment: float | None) -> Statics:
    with scenario_errors():
        from gantline.statics import Statics

        question = Statics(lift)
    refuse_beyond(question.scenario, moment)
    return question


def _answer(question: Statics, moment: float | None, state: Path | None, *, held: bool, modes: int) -> Answer:
    from gantline.checks import check_recording
    from gantline.cli.rest_table import Answer

    rest, bounds, nowhere, ranges = _settled(question, moment, state, held=held)
    found = question.modes(max(modes, _MODES) + rest.unstable + rest.neutral)
    shown = found[: max(modes, rest.unstable)]
    checks, *of_bounds = [check_recording(one.recording) for one in (rest, *bounds)]
    return Answer(rest, bounds, nowhere, ranges, found, shown, checks, of_bounds)


def _as_json(question: Statics, answer: Answer, sensitivities: bool) -> str:
    from gantline.cli.rest_table import statics_json

    numbers = statics_json(question, answer, question.sensitivities() if sensitivities else [])
    return json.dumps(numbers, indent=2, allow_nan=False)


def _as_tables(question: Statics, answer: Answer, sensitivities: bool) -> str:
    from gantline.cli import rest_table
    from gantline.cli.chain_hoist_table import chain_hoist_table
    from gantline.cli.friction import contact_forces
    from gantline.cli.hinge_table import hinges_at_rest
    from gantline.cli.tilting import tilting_lines
    from gantline.cli.vessels import vessels_at_rest
    from gantline.study.tilting import tilting_of, untold

    rest = answer.rest
    tilting = tilting_of(question, rest, answer.found)
    parts = [
        rest_table.heading_of(question, rest, answer.found, answer.checks),
        rest_table.slings_of(rest, answer.bounds),
        chain_hoist_table(rest.recording),
        rest_table.ropes(rest, answer.bounds),
        rest_table.fenders(rest),
        rest_table.hooks(rest),
        vessels_at_rest(question, rest),
        rest_table.loads(rest),
        tilting_lines(tilting, answer.margins, untold(rest, tilting)),
        contact_forces(rest) if rest.losses == "held" else [],
        answer.ranges,
        rest_table.moving_sheaves(rest),
        rest_table.compensators(rest),
        hinges_at_rest(rest.recording),
        rest_table.motions(answer.shown),
        *(rest_table.changes(rest, question.sensitivities()) if sensitivities else []),
        rest_table.checks_at_rest(rest, answer.checks),
        rest_table.bounds_at_rest(answer),
    ]
    if not rest.is_stable:
        parts += _beyond(question)
    return "\n".join(line for part in parts if part for line in (*part, ""))


def _settled(
    question: Statics, moment: float | None, state: Path | None, *, held: bool
) -> tuple[Equilibrium, list[Equilibrium], dict[Losses, NoEquilibriumError], list[str]]:
    """The equilibrium; with all sheaves slipping one way and the other; lines on what friction may hold.

    Of a way to slip with which there is none why not: that takes nothing from the equilibrium itself.
    """
    from gantline.cli.friction import stick_ranges
    from gantline.results import series
    from gantline.statics import NoEquilibriumError
    from gantline.study.side_by_side import SideBySide

    with SideBySide() as pool:
        try:
            pending = _bounds(pool, question, moment) if state is None else {}
            rest = _rest(question, moment, state, held=held)
            ranges = []
            if held and state is None and any(contact.bound > 0.0 for contact in rest.contacts):
                ranges = stick_ranges(question, rest)
                # Motions are those of the equilibrium found last.
                rest = _rest(question, moment, state, held=held)
            bounds, nowhere = _found(pending)
            if held and rest.recording.rig.loads and not series.is_clear(rest.recording)[-1]:
                # In them contacts slide freely: a load that friction holds would stand elsewhere.
                bounds, nowhere = [], {}
        except NoEquilibriumError as problem:
            stop(str(problem), COULD_NOT_GO_ON)
    return rest, bounds, nowhere, ranges


def _found(
    pending: dict[Losses, Future[Equilibrium]],
) -> tuple[list[Equilibrium], dict[Losses, NoEquilibriumError]]:
    """Equilibria that are asked for, and why there are none where there are none."""
    from gantline.statics import NoEquilibriumError

    bounds: list[Equilibrium] = []
    nowhere: dict[Losses, NoEquilibriumError] = {}
    for way, one in pending.items():
        try:
            bounds.append(one.result())
        except NoEquilibriumError as problem:
            nowhere[way] = problem
    return bounds, nowhere


def _rest(question: Statics, moment: float | None, state: Path | None, *, held: bool) -> Equilibrium:
    """The equilibrium that was asked for."""
    if state is None:
        return question.equilibrium(moment, losses="held" if held else "none")
    try:
        return question.equilibrium_of(state.read_bytes())
    except OSError as problem:
        stop(f"--state: {state}: cannot be read ({(problem.strerror or str(problem)).lower()})")
    except ValueError as problem:
        stop(f"--state: {state}: {problem}; a run of this lift that cannot go on leaves one, 'state.bin'")


def _beyond(question: Statics) -> list[list[str]]:
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


def _bounds(pool: SideBySide, question: Statics, moment: float | None) -> dict[Losses, Future[Equilibrium]]:
    """With all sheaves slipping one way and the other; none where no sheave has losses."""
    if not any(sheave.has_losses for sheave in question.rig.sheaves):
        return {}
    ways: tuple[Losses, ...] = ("forward", "backward")
    ask = pool.question(question.scenario, question.assembly).equilibrium
    return {way: pool.submit(ask, moment, losses=way) for way in ways}


def _margins(question: Statics, rest: Equilibrium) -> list[Margin]:
    """How far the centre of gravity may be elsewhere; nothing where there is no load."""
    from gantline.scenario.file.variants import without_cases
    from gantline.study.tilting import margins_of

    if not rest.recording.rig.loads:
        return []
    try:
        return margins_of(without_cases(question.scenario), rest)
    except ValueError as problem:
        stop(f"--margins: {problem}")


def _write(question: Statics, rest: Equilibrium, modes: list[Mode], folder: Path, *, aside: bool) -> None:
    from gantline.results.file.saved import EQUILIBRIUM
    from gantline.statics.inclining import metacentric_heights
    from gantline.study.standing import AsHeld, least_heights

    place = output_folder(folder)
    heights = least_heights(metacentric_heights(question, rest), AsHeld(question).heights(rest))
    with writing(place):
        written = [rest.with_modes(modes, heights).save(place / EQUILIBRIUM)]
        for mode in modes:
            written.append(question.swing(mode).save(place / f"motion_{mode.number + 1}.nc"))
    typer.echo("\n".join(f"Recording   {path}" for path in written), err=aside)
