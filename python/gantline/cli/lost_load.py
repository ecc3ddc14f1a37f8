"""A load that is lost at once, as `gantline statics --lost` shows it."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import typer

from gantline.cli.lift import output_folder
from gantline.cli.messages import CHECK_FAILED, COULD_NOT_GO_ON, DONE, NO_VERDICT, stop, writing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from gantline.statics import Statics
    from gantline.study.lost_load import LostLoad, Swing

#: Of pictures.
_DOTS_PER_INCH = 200
_SWING = (
    "First swing", "towards", "with the load", "at rest", "farthest", "freeboard there", "deck edge under"
)  # fmt: skip
_WORK = ("Righting work", "water comes in", "arms vanish", "A1", "A2", "A2/A1")


def lose(
    question: Statics, load: str, moment: float | None, *, held: bool, output: Path | None, as_json: bool
) -> NoReturn:
    """Lose a load of a lift at rest and show what becomes of it; code 1 where a vessel stays away.

    Where the load stands, and turns no vessel, nothing was lost: code 4.
    """
    from gantline.replacing import replace_text
    from gantline.results.file.saved import LOST_LOAD

    found = _found(question, load, moment, held=held)
    numbers = {**found.to_json(), "left_out": question.scenario.left_out_at_rest}
    text = json.dumps(numbers, indent=2, allow_nan=False)
    if output is not None:
        place = output_folder(output)
        with writing(place):
            written = _draw(found, place)
            replace_text(place / LOST_LOAD, text + "\n")
        lines = [f"Picture     {path}" for path in written]
        typer.echo("\n".join([*lines, f"Lost load   {place / LOST_LOAD}"]), err=as_json)
    typer.echo(text if as_json else "\n".join(_as_lines(question, found)))
    if not found.is_sound:
        raise typer.Exit(CHECK_FAILED)
    raise typer.Exit(NO_VERDICT if found.stands and not found.swings else DONE)


def _found(question: Statics, load: str, moment: float | None, *, held: bool) -> LostLoad:
    from gantline.statics import NoEquilibriumError
    from gantline.study.lost_load import lose_load

    try:
        rest = question.equilibrium(moment, losses="held" if held else "none")
    except NoEquilibriumError as problem:
        stop(str(problem), COULD_NOT_GO_ON)
    try:
        return lose_load(question, rest, load)
    except ValueError as problem:
        stop(f"--lost: {problem}")
    except NoEquilibriumError as problem:
        stop(f"--lost: without '{load}' {problem}", CHECK_FAILED)


def _as_lines(question: Statics, found: LostLoad) -> list[str]:
    """How vessels lie without the load, and how they swing there."""
    from gantline.cli.summary import heading
    from gantline.cli.table import table
    from gantline.cli.vessels import righting, vessels
    from gantline.study.standing import least_heights

    state = "stable" if found.rest.is_stable else "UNSTABLE"
    lines = [
        *heading(question.rig),
        *question.scenario.left_out_at_rest,
        f"'{found.load}' lost at {found.rest.time:g} s; at rest without it: {state}",
    ]
    lines += ["", *vessels(found.rest.recording), "", *righting(least_heights(found.heights, {}))]
    if found.under_with_load:
        lines += ["", *(line for vessel in found.under_with_load for line in _under(found, vessel))]
    if not found.swings:
        stands = f": '{found.load}' stands then; --time says when in the plan it is lost"
        return [*lines, "", f"It turns no vessel{stands if found.stands else ''}", ""]
    lines += ["", *table(_SWING, [_swing(one) for one in found.swings], "llrrrrr")]
    lines += ["", *table(_WORK, [_work(one) for one in found.swings], "lrrrrr")]
    return [*lines, *(note for one in found.swings for note in _notes(one)), ""]


def _under(found: LostLoad, vessel: str) -> list[str]:
    """What of a vessel is under water before the load is lost."""
    from gantline.checks.measure import named

    openings = found.flooded.get(vessel, [])
    if openings:
        comes = "water comes in, which arms and areas do not know of"
        return [
            f"  WARNING: {vessel} has {named(openings)} under water already with '{found.load}' on: {comes}"
        ]
    return [f"  {vessel} has the edge of its deck under water already with '{found.load}' on"]


def _swing(one: Swing) -> tuple[str, ...]:
    from gantline.cli.table import show

    angles = (one.before, one.after, one.farthest)
    return (
        one.vessel,
        one.towards,
        *(show(angle, "deg", 2) for angle in angles),
        show(one.freeboard, "m", 2),
        show(one.under.get("deck_edge"), "deg", 2),
    )


def _work(one: Swing) -> tuple[str, ...]:
    from gantline.cli.table import show

    areas = (f"{math.degrees(area):.2f} m deg" for area in (one.left, one.taken))
    return (
        one.vessel,
        *(show(angle, "deg", 2) for angle in (one.flooding, one.vanishing)),
        *areas,
        _ratio(one.ratio),
    )


def _ratio(ratio: float) -> str:
    return f"{ratio:.2f}" if ratio < 100.0 else "over 100"


def _notes(one: Swing) -> list[str]:
    lines = []
    left, ratio = one.left_at_design, one.ratio_at_design
    if left is not None and ratio is not None:
        area = f"A1 {math.degrees(left):.2f} m deg and A2/A1 {_ratio(ratio)}"
        lines.append(f"  {one.vessel} with the design weight on: {area}")
    if not one.is_held:
        weight = " with the design weight" if one.taken > one.left else ""
        stays = f"{one.vessel}{weight} does not swing back before water comes in or its arms vanish"
        lines.append(f"  WARNING: {stays}")
    if not one.has_openings:
        goes = "A2 goes to where its arms vanish, or 50 deg"
        lines.append(f"  {one.vessel} has no 'openings' in the lift file: {goes}")
    return lines


def figures_of(found: LostLoad) -> list[tuple[str, Figure]]:
    """Pictures of the righting arms by the names of the vessels that turn."""
    from gantline.plot.lost_load import SwingCurve, lost_load_picture

    return [
        (
            one.vessel,
            lost_load_picture(
                SwingCurve(
                    title=f"{one.vessel}, '{found.load}' lost: righting arms towards its {one.towards}",
                    angles=one.angles,
                    arms=one.arms,
                    before=one.before,
                    after=one.after,
                    farthest=one.farthest,
                    end=one.end,
                    under=dict(one.under),
                )
            ),
        )
        for one in found.swings
    ]


def _draw(found: LostLoad, folder: Path) -> list[Path]:
    """The pictures as files in a folder."""
    from gantline.replacing import replaced

    written = []
    for vessel, figure in figures_of(found):
        path = folder / f"lost_load_{vessel}.png"
        with replaced(path) as trial:
            figure.savefig(trial, format="png", dpi=_DOTS_PER_INCH)
        written.append(path)
    return written
