"""`gantline statics`: how a lift hangs at rest, how it swings about that, what it answers to errors."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from gantline.cli.lift import Lift, Moment, moment_of, output_folder, refuse_beyond
from gantline.cli.messages import CHECK_FAILED, COULD_NOT_GO_ON, DONE, scenario_errors, stop, writing

if TYPE_CHECKING:
    from gantline.statics import Equilibrium, Mode, Sensitivity, Statics

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
        typer.Option(
            "--output",
            "-o",
            metavar="DIR",
            help="Folder for the equilibrium and one period of each motion shown, as recordings.",
        ),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print all numbers as JSON, SI units, and nothing else.")
    ] = False,
) -> None:
    """Find the equilibrium of a lift, and its natural motions about it; nothing is simulated.

    An unstable equilibrium is told first, then the stable one that it leads to. Ends with code 1 where the
    equilibrium is unstable, and with 3 where there is none.
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
        from gantline.cli.friction import contact_forces, stick_ranges
        from gantline.scenario.variants import without_cases
        from gantline.statics import NoEquilibriumError, Statics

        question = Statics(lift)
    refuse_beyond(question.scenario, moment)
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
    from gantline.cli.tilting import tilting_lines
    from gantline.cli.vessels import vessels_at_rest
    from gantline.study.tilting import margins_of, tilting_of

    found = question.modes(max(modes, _MODES) + rest.unstable + rest.neutral)
    far = []
    if margins and rest.recording.rig.loads:
        try:
            far = margins_of(without_cases(question.scenario), rest)
        except ValueError as problem:
            stop(f"--margins: {problem}")
    shown = found[: max(modes, rest.unstable)]
    if output is not None:
        _write(question, rest, shown, output, aside=as_json)
    if as_json:
        more = question.sensitivities() if sensitivities else []
        typer.echo(json.dumps(statics_json(rest, bounds, shown, more), indent=2, allow_nan=False))
        raise typer.Exit(DONE if rest.is_stable else CHECK_FAILED)
    parts = [
        _heading(question, rest, found),
        _slings(rest, bounds),
        _ropes(rest),
        _hooks(rest),
        vessels_at_rest(question, rest),
        _loads(rest),
        tilting_lines(tilting_of(question, rest, found), far),
        contact_forces(rest) if rest.losses == "held" else [],
        ranges,
        _sheaves(rest),
        _modes(shown),
        _sensitivities(rest, question.sensitivities()) if sensitivities else [],
    ]
    if not rest.is_stable:
        parts += _beyond(question, rest)
    typer.echo("\n".join(line for part in parts if part for line in (*part, "")))
    raise typer.Exit(DONE if rest.is_stable else CHECK_FAILED)


def _rest(question: Statics, moment: float | None, state: Path | None, *, held: bool) -> Equilibrium:
    """The equilibrium that was asked for."""
    if state is None:
        return question.equilibrium(moment, losses="held" if held else "none")
    try:
        return question.equilibrium_of(state.read_bytes())
    except OSError as problem:
        stop(f"--state: {state}: {problem.strerror}")
    except ValueError as problem:
        stop(f"--state: {state}: {problem}")


def _beyond(question: Statics, rest: Equilibrium) -> list[list[str]]:
    """Where the lift goes that is left by itself."""
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
    return [head, _slings(beyond, []), _hooks(beyond), vessels(beyond.recording), _loads(beyond)]


def _bounds(question: Statics, moment: float | None) -> list[Equilibrium]:
    """With all sheaves slipping one way and the other; none where no sheave has losses."""
    along = question.equilibrium(moment, losses="forward")
    return [along, question.equilibrium(moment, losses="backward")] if along.lossy else []


def _heading(question: Statics, rest: Equilibrium, modes: list[Mode]) -> list[str]:
    from gantline.cli.summary import heading, weights

    lines = [*heading(question.rig), *weights(question.rig)]
    if rest.is_stable:
        state = "stable"
    else:
        count = "one motion leads" if rest.unstable == 1 else f"{rest.unstable} motions lead"
        state = f"UNSTABLE: {count} away"
    lines.append(f"Equilibrium at {rest.time:g} s: {state}")
    free = [mode.motion for mode in modes if mode.period is None and mode.growth_time is None]
    lines += [f"  nothing holds: {motion}; nearest to the start" for motion in free]
    if rest.losses == "held":
        lines.append("  friction of contacts and sheaves holds what it can, from where the lift was")
        return lines
    if rest.lossy:
        lines.append(
            f"  losses of {len(rest.lossy)} sheaves left out; bounds: all slip along the rope, all against"
        )
    if rest.recording.rig.loads:
        lines.append("  contacts without friction")
    return lines


def _slings(rest: Equilibrium, bounds: list[Equilibrium]) -> list[str]:
    from gantline.cli.table import ABSENT, show, table
    from gantline.results import series

    slings = rest.recording.rig.slings
    tensions = {sling.name: rest.tension(sling.rope) for sling in slings}
    mean = sum(tensions.values()) / max(len(tensions), 1)
    rows = [
        (
            sling.name,
            show(tensions[sling.name], "kN", 3),
            f"{tensions[sling.name] / mean:.4f}" if mean > 0.0 else ABSENT,
            show(float(series.sling_angle(rest.recording, sling)[-1]), "deg", 2),
            "slack" if tensions[sling.name] <= 0.0 else "",
            *(show(bound.tension(sling.rope), "kN", 1) for bound in bounds),
        )
        for sling in slings
    ]
    head = (
        "Sling",
        "tension",
        "of the mean",
        "angle",
        "",
        *(("slip along", "slip against") if bounds else ()),
    )
    return table(head, rows, "lrrrl" + "r" * len(bounds)) if rows else []


def _ropes(rest: Equilibrium) -> list[str]:
    from gantline.cli.table import show, table

    slings = {sling.rope for sling in rest.recording.rig.slings}
    names = [name for name in rest.recording.coordinates.get("rope", ()) if name not in slings]
    rows = [(name, show(rest.tension(name), "kN", 3)) for name in names]
    return table(("Rope", "tension"), rows, "lr") if rows else []


def _hooks(rest: Equilibrium) -> list[str]:
    from gantline.cli.table import show, table

    rows = [
        (hook.name, *(show(float(rest.recording.column(name, hook.name)[-1]), "kN", 1) for name in loads))
        for loads in [("hook_load", "hoist_load")]
        for hook in rest.recording.rig.hooks
    ]
    return table(("Hook", "hook load", "hoist load"), rows, "lrr") if rows else []


def _loads(rest: Equilibrium) -> list[str]:
    from gantline.cli.table import show, table

    rows = [
        (
            load.name,
            show(float(rest.recording.column("load_tilt", load.name)[-1]), "deg", 3),
            # Rounding of a load that stands is no negative share.
            show(max(0.0, float(rest.recording.column("load_transferred", load.name)[-1])), "%", 1),
        )
        for load in rest.recording.rig.loads
    ]
    return table(("Load", "tilt", "load transferred"), rows, "lrr") if rows else []


def _sheaves(rest: Equilibrium) -> list[str]:
    from gantline.cli.table import show, table

    rows = [
        (sheave, show(float(rest.recording.column("sheave_travel", sheave)[-1]), "m", 3))
        for equalizer in rest.recording.rig.equalizers
        for sheave in equalizer.moving_sheaves
    ]
    return table(("Moving sheave", "travel, down positive"), rows, "lr") if rows else []


def _modes(modes: list[Mode]) -> list[str]:
    from gantline.cli.table import show, table

    def course(mode: Mode) -> str:
        if mode.growth_time is not None:
            return f"leads away, e-fold in {show(mode.growth_time, 's', 2)}"
        return show(mode.period, "s", 3) if mode.period is not None else "nothing holds it"

    rows = [
        (str(mode.number + 1), course(mode), show(mode.damping_ratio, "%", 2), mode.motion) for mode in modes
    ]
    return table(("Motion", "period", "damping ratio", "what moves"), rows, "lrrl") if rows else []


#: What one error of each kind is, for the table: its size, and in words.
_ERRORS = {
    "length": (0.01, "10 mm longer"),
    "stiffness": (0.0, "1 % stiffer"),
    "mass": (1000.0, "1 t heavier"),
    "centre_x": (0.1, "centre of gravity 100 mm along x"),
    "centre_y": (0.1, "centre of gravity 100 mm along y"),
    "centre_z": (0.1, "centre of gravity 100 mm along z"),
}


def _sensitivities(rest: Equilibrium, all_of_them: list[Sensitivity]) -> list[str]:
    """Changes of the slings' tensions, first order."""
    from gantline.cli.table import show, table

    slings = rest.recording.rig.slings
    stiffness = rest.recording.attributes["axial_stiffness"]
    rows = []
    for one in all_of_them:
        size, words = _ERRORS[one.kind]
        if one.kind == "stiffness":
            size = 0.01 * stiffness.get(one.name, 0.0)
        changes = [show(one.of(sling.rope) * size, "kN", 3) for sling in slings]
        rows.append((f"{one.name} {words}", *changes))
    head = ("Change of tension", *(sling.name for sling in slings))
    return table(head, rows, "l" + "r" * len(slings)) if slings else []


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


def statics_json(
    rest: Equilibrium, bounds: list[Equilibrium], modes: list[Mode], sensitivities: list[Sensitivity]
) -> dict[str, Any]:
    """An equilibrium as a JSON object, SI units."""
    from gantline.study.state import State, values_of

    def numbers(one: Equilibrium) -> dict[str, Any]:
        values = values_of(State("", "", one.losses, one.time, one))
        return {**one.to_json(), **{key: of for key, of in values.items() if key != "smallest_sling_tension"}}

    return {
        **numbers(rest),
        "bounds": [numbers(one) for one in bounds],
        "contacts": [
            {"name": one.contact, "support": one.support, "friction": list(one.friction), "bound": one.bound}
            for one in rest.contacts
        ],
        "modes": [mode.to_json() for mode in modes],
        "sensitivities": [
            {
                "kind": one.kind,
                "of": one.name,
                "rope_tension": dict(zip(one.ropes, map(float, one.tension), strict=True)),
            }
            for one in sensitivities
        ],
    }
