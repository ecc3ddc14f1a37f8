"""`gantline statics LIFT --steps`: how a lift hangs at the end of every step of its plan."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NoReturn

import typer

from gantline.cli.messages import CHECK_FAILED, COULD_NOT_GO_ON, DONE

if TYPE_CHECKING:
    from gantline.statics import Statics
    from gantline.study.steps import StepAtRest

#: Columns that the name of a step may have.
_LONGEST = 36
#: What is added to the heading where there are such moments.
_WITHIN = ", and where one pumps that leaves less GM in between"


def steps(question: Statics, *, held: bool, as_json: bool) -> NoReturn:
    """Print how a lift hangs at the end of every step, and end.

    Args:
        question: The lift.
        held: Whether friction of contacts and sheaves holds what it can.
        as_json: Whether all numbers are printed as JSON in place of the tables.

    Raises:
        typer.Exit: Always; with 1 where a check fails or the lift is unstable, and with 3 where it falls.
    """
    from gantline.cli.check_table import width_of_terminal
    from gantline.study.steps import run_steps

    found = list(run_steps(question, "held" if held else "none", pumping=True))
    left_out = question.scenario.left_out_at_rest
    if as_json:
        document = {"left_out": left_out, "steps": [one.to_json() for one in found]}
        typer.echo(json.dumps(document, indent=2, allow_nan=False))
    else:
        typer.echo("\n".join(_lines(question, found, width_of_terminal())))
    if any(one.state.rest is None for one in found):
        raise typer.Exit(COULD_NOT_GO_ON)
    raise typer.Exit(DONE if all(one.state.is_sound for one in found) else CHECK_FAILED)


def _lines(question: Statics, found: Sequence[StepAtRest], width: int) -> list[str]:
    from gantline.cli.cases_table import notes
    from gantline.cli.friction import fails_as_it_slides, slid_loads, stands_loosely
    from gantline.cli.rest_table import friction_of
    from gantline.cli.summary import heading
    from gantline.cli.vessels import held_by_friction, held_elsewhere
    from gantline.study.standing import lessened

    states = [one.state for one in found]
    afloat = [(one.state.rest, one.heights) for one in found if one.state.rest is not None]
    rest = next((state.rest for state in states if state.rest is not None), None)
    slides = [] if rest is None else slid_loads(question, rest)
    loose = [] if slides else stands_loosely([state.rest for state in states if state.rest is not None])
    loose = loose or ([] if slides else fails_as_it_slides(states))
    parts = [
        [
            *(*heading(question.rig), *question.scenario.left_out_at_rest),
            f"At rest where each step ends{_WITHIN if any(map(_is_within, found)) else ''}",
            *(() if rest is None else friction_of(rest)),
            *slides,
            *_not_ended(question, found),
        ],
        *_loads(question, found, width),
        *_vessels(question, found, width),
        [
            *held_elsewhere(question, afloat),
            *held_by_friction([one.name for one in found if lessened(one.heights, one.held)]),
        ],
        [
            *notes(states, lambda places: ", ".join(found[place].name for place in places), width),
            *loose,
        ],
    ]
    return [line for part in parts if part for line in (*part, "")]


def _is_within(one: StepAtRest) -> bool:
    from gantline.study.steps import END, START

    return not one.steps and one.name not in (START, END)


def _not_ended(question: Statics, found: Sequence[StepAtRest]) -> list[str]:
    """Steps that the lift does not get through, which the table lacks; none of a hold until its end."""
    from gantline.checks.measure import named

    told = {name for one in found for name in one.steps}
    plan = question.scenario.plan
    left = [step for step in plan if step.step not in told and getattr(step, "hold", None) != "until_end"]
    begins = {step.step: question.times_of(step.step)[0] for step in left}
    goes_on = [name for name, begin in begins.items() if begin is not None]
    not_begun = [name for name, begin in begins.items() if begin is None]
    end = f"{question.scenario.duration:g} s"
    parts = [f"do not end by {end}: {named(goes_on)}"] if goes_on else []
    parts += [f"not begun: {named(not_begun)}"] if not_begun else []
    return [f"  steps that {'; '.join(parts)}"] if goes_on else [f"  steps {parts[0]}"] if parts else []


def _loads(question: Statics, found: Sequence[StepAtRest], width: int) -> list[list[str]]:
    """What slings and hooks carry, and how loads hang."""
    from gantline.cli.cases_table import outcome
    from gantline.cli.table import tables
    from gantline.study.state import values_of

    values = [values_of(one.state) for one in found]
    columns = [["at", *(f"{one.state.time:.1f} s" for one in found)]]
    names = [load.name for load in question.rig.loads]
    for load in names:
        columns += [
            [_of("transferred", load, names), *_cells(found, "load_transferred", load, "%", 1)],
            [_of("tilt", load, names), *_cells(found, "load_tilt", load, "deg", 2)],
        ]
    hooks = [hook.name for hook in question.rig.hooks]
    columns += [[_of("hook load", hook, hooks), *_cells(found, "hook_load", hook, "kN", 1)] for hook in hooks]
    hinges = [hinge.name for hinge in question.rig.hinges]
    columns += [[f"{hinge} force", *_cells(found, "hinge_force", hinge, "kN", 1)] for hinge in hinges]
    columns.append(["slings", *(_range(one["sling_tension"].values()) for one in values)])
    last = ["", *(outcome([one.state]) for one in found)]
    return tables(_names(found), columns, last, width=width)


def _vessels(question: Statics, found: Sequence[StepAtRest], width: int) -> Iterator[list[str]]:
    """How each vessel lies, and what rights it."""
    from gantline.cli.table import tables

    for vessel in question.rig.vessels:
        name = vessel.name
        columns = [
            ["draft aft", *_cells(found, "vessel_draft_aft", name, "m", 3)],
            ["forward", *_cells(found, "vessel_draft_forward", name, "m", 3)],
            ["heel", *_cells(found, "vessel_heel", name, "deg", 3)],
            ["trim", *_cells(found, "vessel_trim", name, "deg", 3)],
            ["freeboard", *_cells(found, "vessel_freeboard", name, "m", 3)],
        ]
        if not vessel.is_carried:
            gm = [one.gm.get(name, (None, None)) for one in found]
            columns += [
                ["GM heel", *_shown((transverse for transverse, _ in gm), "m", 2)],
                ["GM trim", *_shown((longitudinal for _, longitudinal in gm), "m", 2)],
            ]
        yield from tables([name, *_names(found)[1:]], columns, width=width)


def _names(found: Sequence[StepAtRest]) -> list[str]:
    names = (one.name if len(one.name) <= _LONGEST else f"{one.name[: _LONGEST - 1]}…" for one in found)
    return ["Step", *names]


def _of(title: str, element: str, elements: Sequence[str]) -> str:
    """A title of a column, with the element where there are several."""
    return title if len(elements) == 1 else f"{element} {title}"


def _range(tensions: Collection[float]) -> str:
    """From the least to the largest of some tensions, or what they all are."""
    least, most = _shown((of(tensions, default=None) for of in (min, max)), "kN", 1)
    return most if least == most else f"{least.removesuffix(' kN')} to {most}"


def _cells(found: Sequence[StepAtRest], variable: str, element: str, unit: str, digits: int) -> list[str]:
    """A variable of an element at rest at each moment."""
    rests = (one.state.rest for one in found)
    values = (None if rest is None else float(rest.recording.column(variable, element)[-1]) for rest in rests)
    return _shown(values, unit, digits)


def _shown(values: Iterable[float | None], unit: str, digits: int) -> list[str]:
    from gantline.cli.table import show

    return [show(value, unit, digits) for value in values]
