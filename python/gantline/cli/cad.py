"""`gantline cad`: what a CAD file weighs, part by part, and how far to trust it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gantline.cli.lift import folder_option, output_folder, quantity_of, unit_of
from gantline.cli.messages import stop

if TYPE_CHECKING:
    from gantline.cad import Assumptions, CadModel


def cad(
    file: Annotated[
        Path,
        typer.Argument(metavar="FILE", help="OCX (.3docx, .ocx, .xml), STEP, IGES, STL, OBJ, glTF or GLB."),
    ],
    output: Annotated[
        Path | None, folder_option("Folder to write into.  [default: results/cad-<name of FILE>]")
    ] = None,
    unit: Annotated[
        str | None,
        typer.Option(
            metavar="UNIT", help="Unit of length: mm, m, ...  [default: what the file says, or guessed]"
        ),
    ] = None,
    density: Annotated[
        str,
        typer.Option(metavar="DENSITY", help="Density of solids and plates where the file names none."),
    ] = "7850 kg/m^3",
    thickness: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help="Plate thickness of open surfaces: '10 mm'.  [default: they have no weight]",
        ),
    ] = None,
    up: Annotated[
        str | None,
        typer.Option(metavar="AXIS", help="Axis that points up, y or z.  [default: y in glTF, z elsewhere]"),
    ] = None,
    list_parts: Annotated[bool, typer.Option("--parts", help="List every part.")] = False,
    plots: Annotated[bool, typer.Option("--plots/--no-plots", help="Draw a picture.")] = True,
    keep: Annotated[
        bool, typer.Option("--cache/--no-cache", help="Use what was read from the same file before.")
    ] = True,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print everything as JSON, and nothing else to standard output.")
    ] = False,
) -> None:
    """Read a ship structure from CAD: parts, mass, centre of gravity, inertia, doubts; and draw it.

    Masses come from the geometry and are held against those that the file declares, part by part.
    """
    from gantline.cad import CadError, read
    from gantline.cli.cad_table import cad_json, cad_table
    from gantline.cli.check_table import width_of_terminal

    try:
        model = read(file, _assumptions(unit, density, thickness, up), keep=keep)
        if as_json:
            typer.echo(cad_json(model))
        else:
            typer.echo("\n".join(cad_table(model, width_of_terminal(), list_parts=list_parts)))
    except CadError as problem:
        stop(str(problem))
    if plots:
        folder = output_folder(output if output is not None else Path("results") / f"cad-{file.stem}")
        typer.echo(f"Picture     {_drawn(model, folder)}", err=as_json)


def _assumptions(unit: str | None, density: str, thickness: str | None, up: str | None) -> Assumptions:
    from gantline.cad import Assumptions

    if up is not None and up not in ("y", "z"):
        stop(f"--up: '{up}' is neither y nor z")
    size = quantity_of("--thickness", thickness, "length")
    mass = quantity_of("--density", density, "density")
    return Assumptions(unit_of(unit), mass, size, "y" if up == "y" else "z" if up == "z" else None)


def _drawn(model: CadModel, folder: Path) -> Path:
    """Write the picture of a model; the answer is its path."""
    from gantline.cli.cad_picture import model_picture
    from gantline.cli.messages import writing
    from gantline.plot.pictures import write_pictures

    figure = model_picture(model)
    if figure is None:
        stop(f"{model.name}: no part has geometry that can be drawn; --no-plots goes without the picture")
    with writing(folder):
        return write_pictures([("model", figure)], folder)[0]
