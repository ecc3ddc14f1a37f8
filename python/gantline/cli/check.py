"""`gantline check`: is this lift file right, and does the lift keep its limits?"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from gantline.cli.lift import lifts_that_begin, opened, recording_file, warn_of_gaps
from gantline.cli.messages import (
    COULD_NOT_GO_ON,
    INTERRUPTED,
    scenario_errors,
    stop,
    warn,
)
from gantline.cli.progress import progress

if TYPE_CHECKING:
    from gantline.results.gear import Sheave
    from gantline.results.recording import Recording
    from gantline.results.rig import Rig
    from gantline.scenario import Scenario
    from gantline.scenario.gear import RopeMaterial
    from gantline.simulation import Simulation
    from gantline.study.heave_demand import HeaveDemand


def check(
    lift: Annotated[
        Path,
        typer.Argument(
            metavar="LIFT|RECORDING",
            help="Lift file, its folder, the name of a lift that comes with gantline; or a recording (.nc), "
            "or a folder that `gantline run` wrote; or a library of types.",
            autocompletion=lifts_that_begin,
        ),
    ],
    simulate: Annotated[
        bool, typer.Option("--simulate", help="Simulate the lift, and check its limits; nothing is written.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print the checks as JSON.")] = False,
) -> None:
    """Check a recording, or a simulated lift, against its limits; or look a lift file over.

    Ends with code 1 if a check failed, with 3 if the simulation could not go on, and with 4 if the checks
    give no verdict. Nothing is written.
    """
    file = recording_file(lift)
    if file is not None:
        if simulate:
            stop(f"{file} is a recording: its lift has been simulated already")
        raise typer.Exit(_print_checks(opened(file), as_json=as_json))
    if not simulate and not as_json and _is_looked_over_as_library(lift):
        return
    with scenario_errors():
        from gantline.simulation import Simulation

        simulation = Simulation(lift)
    if simulate:
        _simulate_and_check(simulation, as_json=as_json)
    if as_json:
        stop("--json prints the checks of a recording, or of a lift with --simulate")
    _look_over(simulation)


def _is_looked_over_as_library(file: Path) -> bool:
    """Whether a file is a library; what it holds is printed then."""
    with scenario_errors():
        from gantline.scenario import check_library

        held = check_library(file)
    if held is None:
        return False
    counted = ", ".join(f"{section} {count}" for section, count in held.items())
    typer.echo(f"{file}: a library, in order ({counted})")
    return True


def _print_checks(recording: Recording, *, as_json: bool) -> int:
    """Print the checks of a recording; the answer is the code that says how they went."""
    from gantline.checks import check_recording
    from gantline.cli.check_table import check_table, checks_json, exit_code, width_of_terminal
    from gantline.cli.ending import ending_lines
    from gantline.cli.summary import heading, weights
    from gantline.results.status import INCOMPLETE

    checks = check_recording(recording)
    if as_json:
        typer.echo(checks_json(recording, checks))
    else:
        rig = recording.rig
        rule = str(rig.limits.get("rule") or "")
        width = width_of_terminal()
        table = check_table(checks, rule, width=width, full=True)
        ending = ending_lines(recording, width)
        apart = [""] if table and ending else []
        typer.echo("\n".join([*heading(rig), *weights(rig), "", *table, *apart, *ending]))
    warn_of_gaps(recording)
    status = str(recording.attributes.get("status", ""))
    if status in INCOMPLETE:
        end = f"{recording.time[-1]:.2f} s" if len(recording.time) else "its start"
        warn(f"this run {INCOMPLETE[status]} at {end}: what would have come after is not checked")
    if not checks:
        warn("nothing to check: the lift sets no limits, and has nothing that is checked without")
    return exit_code(checks)


def _simulate_and_check(simulation: Simulation, *, as_json: bool) -> NoReturn:
    """Simulate a lift, print its checks, also those up to where it could not go on, and end."""
    from gantline.simulation import SimulationError

    try:
        with progress(simulation) as report:
            recording = simulation.run(on_progress=report)
    except SimulationError as problem:
        _print_checks(problem.recording, as_json=as_json)
        stop(str(problem), COULD_NOT_GO_ON)
    code = _print_checks(recording, as_json=as_json)
    raise typer.Exit(INTERRUPTED if recording.attributes["status"] == "stopped" else code)


def _stretch(kind: RopeMaterial) -> str:
    """How a kind of rope stretches, in words."""
    from gantline.units import format_by_size

    if kind.stiffness is None:
        return "inextensible"
    stiffness = format_by_size(kind.stiffness, "force", 4)
    return stiffness if kind.curve is None else f"curve, about {stiffness}"


def _look_over(simulation: Simulation) -> None:
    """What a lift file describes, all of which has been found right."""
    from gantline.cli.check_table import width_of_terminal
    from gantline.cli.guides_table import guides_table
    from gantline.cli.lead_table import lead_table
    from gantline.cli.summary import heading, weights
    from gantline.cli.supports_table import supports_table
    from gantline.cli.table import show, table
    from gantline.cli.vessels import recorded_motions
    from gantline.results.rig import Rig
    from gantline.study.heave_demand import doubts_of_demand, heave_demands

    rig, width = Rig.from_json(simulation.assembly.rig), width_of_terminal()
    document = simulation.assembly.document
    kinds = [
        (
            name,
            kind.construction or "-",
            _stretch(kind),
            show(kind.mass_per_length, "kg/m", 2),
            show(kind.breaking_force, "kN", 0),
        )
        for name, kind in (simulation.scenario.ropes or {}).items()
    ]
    head = ("Kind of rope", "construction", "EA", "mass", "minimum breaking force")
    ropes = table(head, kinds, "llrrr", width) if kinds else []
    later = _put_on_later(simulation.scenario, width)
    centre = _centre_from_cad(simulation)
    demands = heave_demands(simulation.scenario)
    lines = [*heading(rig), *weights(rig), *centre, *ropes, *_rope_weights(rig, width), *later]
    lines += _sheaves(rig, width)
    lines += _compensators(simulation.scenario, width)
    lines += lead_table(simulation.scenario, width)
    lines += recorded_motions(rig, width)
    load = simulation.scenario.load
    base = None if load is None else load.stands_on
    lines += supports_table(simulation.assembly.under_load, base, width)
    lines += guides_table(simulation.assembly.guide_fits, width)
    typer.echo("\n".join([*lines, *_heave(demands, width)]))
    for doubt in simulation.assembly.doubts:
        warn(doubt.of(simulation.scenario.source))
    for found in doubts_of_demand(demands):
        warn(simulation.scenario.problem(*found).of(simulation.scenario.source))
    _warn_of_curves(simulation, rig)
    _warn_of_time(simulation)
    _warn_of_winches(simulation.scenario)
    nodes = sum(rope.nodes for rope in rig.ropes)
    drums = sum(not drum.flow for drum in rig.drums)
    numbers = {
        ("body", "bodies"): len(document["bodies"]) - nodes - len(rig.sheaves) - drums,
        ("rope", "ropes"): len(rig.ropes),
        ("node of a rope", "nodes of ropes"): nodes,
        ("drum", "drums"): drums,
        ("contact", "contacts"): len(document["contacts"]),
        ("support", "supports"): len(rig.supports),
        ("landing guide", "landing guides"): len(rig.guides),
    }
    counts = ", ".join(f"{number} {what[number > 1]}" for what, number in numbers.items() if number)
    typer.echo(f"{simulation.scenario.source}: in order ({counts}; {simulation.duration:g} s to simulate)")


def _warn_of_curves(simulation: Simulation, rig: Rig) -> None:
    """Tell of ropes that pull more at the start than their curve has, as a run does of all its time."""
    from gantline.results.ropes.beyond_curve import beyond_curve_at_start

    scenario = simulation.scenario
    curves = {
        name: [list(point) for point in kind.curve.points]
        for name, kind in (scenario.ropes or {}).items()
        if kind.curve is not None
    }
    bent = [rope for rope in rig.ropes if rope.curve]
    tensions = {rope.name: float(simulation.now("rope_tension", rope.name)) for rope in bent}
    for rope, sentence in beyond_curve_at_start(bent, tensions):
        kind = next(name for name, points in curves.items() if points == [list(one) for one in rope.curve])
        warn(scenario.problem(("ropes", kind, "curve"), sentence).of(scenario.source))


def _warn_of_time(simulation: Simulation) -> None:
    """Tell of a plan that cannot be over when the run ends."""
    from gantline.scenario.plan.plan_time import earliest_ends

    plan = simulation.scenario.plan
    ends = earliest_ends(plan)
    late = [step.step for step, end in zip(plan, ends, strict=True) if end > simulation.duration]
    if late:
        least = f"the plan takes {max(ends):.0f} s at least; {simulation.duration:g} s are simulated"
        sentence = f"{least}, and end before '{late[0]}' does: make 'duration' longer"
        scenario = simulation.scenario
        warn(scenario.problem(("duration",), sentence).of(scenario.source))


def _warn_of_winches(scenario: Scenario) -> None:
    """Tell of motors and brakes that hold less than what hangs at rest where a step of the plan ends."""
    from gantline.study.weak_brakes import weak_brakes
    from gantline.study.weak_motors import weak_motors

    for doubt in (*weak_motors(scenario), *weak_brakes(scenario)):
        warn(scenario.problem(*doubt).of(scenario.source))


def _centre_from_cad(simulation: Simulation) -> list[str]:
    """The centre of gravity of a load that has it from CAD and outfitting: the lift file does not say it."""
    load = simulation.scenario.load
    if load is None or load.centre_of_gravity.at != "from_cad":
        return []
    from gantline.assembly.loads.load_body import load_body

    # By itself: with what is lumped on its lugs it would have that twice, once written into the lift file.
    place = ", ".join(f"{coordinate:z.3f} m" for coordinate in load_body(simulation.scenario, load).centre)
    return [f"Centre of gravity of {load.name} by CAD and outfitting: [{place}] from its datum"]


def _rope_weights(rig: Rig, width: int) -> list[str]:
    """How the weight of each rope acts, for those that have one."""
    from gantline.cli.table import filled, show, table

    rows = [
        (rope.name, rope.weight, show(rope.mass, "kg", 1), show(rope.mass_on_world or None, "kg", 1))
        for rope in rig.ropes
        if rope.mass > 0.0
    ]
    return table(*filled(("Rope", "weight", "mass", "on the world"), rows, "llrr"), width) if rows else []


def _heave(demands: Sequence[HeaveDemand], width: int) -> list[str]:
    """What heave compensation is asked for in the waves of the lift, and what it can."""
    from gantline.cli.table import show, table

    units = (("m/s", 2), ("m/s^2", 2), ("m", 2))
    rows = [
        (
            one.hook,
            one.over or "the ground",
            f"'{one.step}'",
            *(
                show(number, *unit)
                for asked, has, unit in zip(
                    (one.speed, one.acceleration, one.stroke), one.has, units, strict=True
                )
                for number in (asked, has)
            ),
        )
        for one in demands
    ]
    head = (
        "Heave compensation, most in 3 h",
        "over",
        "step",
        "speed",
        "has",
        "acceleration",
        "has",
        "stroke",
    )
    return table((*head, "has"), rows, "lllrrrrrr", width) if rows else []


def _compensators(scenario: Scenario, width: int) -> list[str]:
    """What hangs on the gas of each compensator by weights, and how it takes that."""
    from gantline.assembly.cranes.compensator_stages import stages
    from gantline.cli.table import ABSENT, show, table
    from gantline.scenario import resolve

    rows = []
    for one in stages(scenario, resolve(scenario)):
        given = (scenario.compensators or {})[one.name]
        ends = (show(given.law.pull(out), "kN", 1) for out in (0.0, given.stroke))
        period = ABSENT if one.period is None else show(one.period, "s", 2)
        rows.append((one.name, *ends, one.where, show(one.pull, "kN", 1), show(one.out, "m", 3), period))
    head = ("Compensator", "rod in", "rod out", "with the load", "its gas holds", "out", "own period")
    return table(head, rows, "lrrlrrr", width) if rows else []


def _put_on_later(scenario: Scenario, width: int) -> list[str]:
    """Slings that are not there at the start; bodies keep their masses, so they hang at their upper ends."""
    from gantline.assembly.yard import upper_lump
    from gantline.cli.table import show, table
    from gantline.scenario import resolve
    from gantline.scenario.plan.slinging import first_put_on

    slings = resolve(scenario).slings
    rows = [
        (
            name,
            f"'{scenario.plan[step].step}'",
            slings[name].upper_body,
            show(upper_lump(slings[name]), "kg", 1),
        )
        for name, step in first_put_on(scenario).items()
    ]
    head = ("Sling put on later", "by step", "all its mass hangs at", "mass")
    return table(head, rows, "lllr", width) if rows else []


def _sheaves(rig: Rig, width: int) -> list[str]:
    """Losses and inertia of each sheave that is not ideal; neighbours on a rope that are alike in one row."""
    from gantline.cli.table import ABSENT, filled, show, table

    head = ("Sheave", "rope", "turns at a ratio of", "groove friction", "moves with the rope", "")

    def turns_at(ratio: float | None) -> str:
        return "never" if ratio is None else f"{ratio:.4f}" if ratio > 1.0 else ABSENT

    def is_like(sheave: Sheave) -> tuple[str, ...]:
        return (
            sheave.rope,
            turns_at(sheave.ratio),
            ABSENT if sheave.groove_friction is None else f"{sheave.groove_friction:g}",
            show(sheave.inertia, "kg", 1),
            sheave.inertia_from,
        )

    def named(sheaves: Sequence[Sheave]) -> str:
        first, last = sheaves[0].name, sheaves[-1].name.rpartition("/")[2]
        return first if len(sheaves) == 1 else f"{first} to {last}, {len(sheaves)} sheaves"

    rows = [(named(list(alike)), *like) for like, alike in groupby(rig.sheaves, is_like)]
    return table(*filled(head, rows, "llrrrl"), width) if rows else []
