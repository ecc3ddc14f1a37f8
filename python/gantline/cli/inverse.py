"""`gantline statics LIFT --level`, `--want`, `--plumb`: what makes a load hang as it is wanted."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import typer

from gantline.cli.lift import output_folder, quantity_of
from gantline.cli.messages import COULD_NOT_GO_ON, DONE, scenario_errors, stop, writing

if TYPE_CHECKING:
    from gantline.statics import Equilibrium
    from gantline.study import HookAnswer, LengthAnswer

_WRITTEN = "wanted is written like 'slope_x=0 deg, slope_y=1 deg, heading=90 deg, S1=25 %'"
_SLOPES = ("slope_x", "slope_y")
#: Less than this is no step of the plan: 0.0000 m would stand there [m].
_SHOWN = 5e-5


@dataclass(frozen=True)
class Wanted:
    """What is wanted of a load that hangs."""

    slopes: tuple[float, float] | None = None
    heading: float | None = None
    shares: Mapping[str, float] = field(default_factory=dict)


def hang_as_wanted(
    lift: Path,
    *,
    level: bool,
    want: str | None,
    plumb: bool,
    adjust: str | None,
    most: str | None,
    time: float | None,
    output: Path | None,
    as_json: bool,
) -> NoReturn:
    """Answer an inverse question, and end.

    Args:
        lift: Lift file, folder, or name of a lift that comes with gantline.
        level: Whether the load shall be level.
        want: What else is wanted, as it stands behind its option.
        plumb: Whether hooks are moved, and not lengths changed.
        adjust: Slings or hooks that may change; all if not given.
        most: Largest change of a length, as written.
        time: Time of the plan [s]; None for the end of the lift.
        output: Folder for the answer's equilibrium.
        as_json: Whether all numbers are printed as JSON, and nothing else.

    Raises:
        typer.Exit: Always; with 3 where it cannot be had.
    """
    wanted = _wanted(level, want)
    limit = quantity_of("--most", most, "length")
    if limit is not None and limit <= 0.0:
        stop(f"--most: '{most}' is no change of a length; more than 0 mm is right")
    chosen = None if adjust is None else [name.strip() for name in adjust.split(",") if name.strip()]
    if chosen == []:
        stop(
            "--adjust: names nothing; slings or hooks are written like 'S1,S2', and without it all may change"
        )
    option = "--plumb" if plumb else "--level" if want is None else "--want"
    with scenario_errors():
        from gantline.scenario import ScenarioError, load_scenario
        from gantline.statics import NoEquilibriumError
        from gantline.study import AdjustError, CannotBeError, HookAnswer, adjust_lengths, plumb_hooks

        answer: LengthAnswer | HookAnswer
        scenario = load_scenario(lift)
        try:
            if plumb:
                answer = plumb_hooks(scenario, hooks=chosen, time=time)
            else:
                answer = adjust_lengths(
                    scenario,
                    slopes=wanted.slopes,
                    heading=wanted.heading,
                    shares=wanted.shares,
                    slings=chosen,
                    most=limit,
                    time=time,
                )
        except NoEquilibriumError as problem:
            stop(str(problem), COULD_NOT_GO_ON)
        except CannotBeError as problem:
            stop(f"{option}: {problem}", COULD_NOT_GO_ON)
        except ScenarioError:
            raise
        except AdjustError as problem:
            stop(f"--adjust: {problem}")
        except ValueError as problem:
            stop(f"{option}: {problem}")
    if as_json:
        numbers = {**answer.to_json(), "left_out": list(scenario.left_out_at_rest)}
        typer.echo(json.dumps(numbers, indent=2, allow_nan=False))
    else:
        lines = _hooks(answer) if isinstance(answer, HookAnswer) else _slings(answer)
        typer.echo("\n".join([*scenario.left_out_at_rest, *lines]))
    if output is not None:
        place = output_folder(output)
        with writing(place):
            written = answer.after.recording.save(place / "equilibrium.nc")
        typer.echo(f"\nRecording   {written}", err=as_json)
    raise typer.Exit(DONE)


def _wanted(level: bool, want: str | None) -> Wanted:
    """What is wanted, from both options."""
    from gantline.units import UnitError, quantity

    slopes: dict[str, float] = dict.fromkeys(_SLOPES, 0.0) if level else {}
    heading, shares = None, dict[str, float]()
    for part in (want or "").split(",") if want is not None else ():
        name, equals, value = (word.strip() for word in part.partition("="))
        if not (name and equals and value):
            stop(f"--want: '{part.strip()}' says nothing; {_WRITTEN}")
        is_angle = name in (*_SLOPES, "heading")
        # Another name is that of a sling, and what is wanted of it is a share.
        other = "" if is_angle else "; angles are those of slope_x, slope_y and heading"
        try:
            number = quantity(value, "angle" if is_angle else "ratio")
        except UnitError as problem:
            stop(f"--want: {name}: {problem}{other}")
        if name in _SLOPES:
            slopes[name] = number
        elif name == "heading":
            heading = number
        else:
            shares[name] = number
    if slopes and len(slopes) < len(_SLOPES):
        missing = next(name for name in _SLOPES if name not in slopes)
        stop(f"--want: '{missing}' is not given; a slope needs the other, or --level")
    both = (slopes["slope_x"], slopes["slope_y"]) if slopes else None
    if both is not None and max(map(abs, both)) >= math.pi / 2:
        stop("--want: a slope is less than 90 deg")
    return Wanted(both, heading, shares)


def _slings(answer: LengthAnswer) -> list[str]:
    """New lengths, and what they change."""
    from gantline.cli.table import show, signed, table

    rows = [
        (
            name,
            show(answer.given[name], "m", 4),
            show(length, "m", 4),
            signed(length - answer.given[name], "mm", 1),
            show(answer.before.tension(f"sling.{name}"), "kN", 1),
            show(answer.after.tension(f"sling.{name}"), "kN", 1),
        )
        for name, length in answer.lengths.items()
    ]
    head = ("Sling", "length", "new length", "change", "tension", "new tension")
    way, slack = "least change of lengths", ", ".join(answer.slack_by_least_change)
    if slack:
        way = f"least change with even shares of the load: that without would leave {slack} slack"
    return [
        *table(head, rows, "lrrrrr"),
        "",
        *_attitude(answer.before, answer.after),
        *_chain_hoists(answer),
        f"  {way}; residual {answer.residual:.1e}, {_steps(answer.steps)}",
        "",
        *_as_case("lengths", answer),
    ]


def _chain_hoists(answer: LengthAnswer) -> list[str]:
    """What steps of the plan would say of the chain hoists in slings that get other lengths."""
    from gantline.cli.table import show

    recording = answer.before.recording
    ranges = {one.name: one.range for one in recording.rig.chain_hoists}
    lines = []
    for name, way in answer.chain_hoists.items():
        if abs(way) < _SHOWN:
            continue
        verb = "haul" if way < 0.0 else "veer"
        line = f"  {verb}: sling.{name}, by: {abs(way):.4f} m"
        room, out = ranges[name], float(recording.column("chain_paid_out", name)[-1]) + way
        if room is not None and not room[0] <= out <= room[1]:
            ends = " to ".join(show(end, "m", 2) for end in room)
            line += f" brings its chain hoist to {show(out, 'm', 3)}, PAST ITS RANGE of {ends}"
        lines.append(line)
    return lines and ["  by the chain hoists, as steps of the plan:", *(f"  {line}" for line in lines)]


def _hooks(answer: HookAnswer) -> list[str]:
    """New places, and what they change."""
    from gantline.cli.table import ABSENT, show, signed, table

    rows = []
    for name, pulls in answer.side_pulls.items():
        forces = [show(math.hypot(*pull), "kN", 2) for pull in pulls]
        cells = [ABSENT] * 4
        if name in answer.places:
            (x, y), (new_x, new_y) = answer.given[name], answer.places[name]
            moved = (signed(new_x - x, "mm", 1), signed(new_y - y, "mm", 1))
            cells = [show(new_x, "m", 4), show(new_y, "m", 4), *moved]
        rows.append((name, *cells, *forces))
    head = ("Hook", "new x", "new y", "along x", "along y", "side pull", "new side pull")
    drift = []
    if answer.drift is not None:
        before, after = (show(one, "mm", 1) for one in answer.drift)
        drift = [f"  drift when it comes off: {before}, then {after}"]
    if answer.steps == 0:
        within = show(math.atan(answer.residual), "deg", 4)
        return [
            *table(head, rows, "lrrrrrr"),
            "",
            *_attitude(answer.before, answer.after),
            *drift,
            f"  falls hang plumb already, to {within}: nothing has to move",
        ]
    return [
        *table(head, rows, "lrrrrrr"),
        "",
        *_attitude(answer.before, answer.after),
        *drift,
        f"  residual {answer.residual:.1e}, {_steps(answer.steps)}",
        "",
        *_as_case("plumb", answer),
    ]


def _attitude(before: Equilibrium, after: Equilibrium) -> list[str]:
    from gantline.cli.table import show
    from gantline.results.rotation import heading

    load = before.recording.rig.loads[0]
    tilts = [
        show(float(one.recording.column("load_tilt", load.name)[-1]), "deg", 3) for one in (before, after)
    ]
    headings = [
        show(float(heading(one.recording.column("body_orientation", load.body)[-1])), "deg", 3)
        for one in (before, after)
    ]
    return [
        f"{load.name} at rest at {after.time:g} s",
        f"  tilt {tilts[0]}, then {tilts[1]}; heading {headings[0]}, then {headings[1]}",
    ]


def _as_case(name: str, answer: LengthAnswer | HookAnswer) -> Sequence[str]:
    """The answer as a case, to be put into the lift file, and what a run with it would need besides."""
    changes = ", ".join(f"{path}: {round(value, 4) + 0.0:.4f} m" for path, value in answer.values.items())
    lines = ["As a case of the lift file, to the tenth of a millimetre:", f"  {name}: {{set: {{{changes}}}}}"]
    if answer.cannot_start:
        lines += ["", "With these values a run cannot start where the lift does; begin with hooks lower:"]
    return [*lines, *(f"  {refused}" for refused in answer.cannot_start)]


def _steps(count: int) -> str:
    return "1 step" if count == 1 else f"{count} steps"
