"""`gantline cad block`: a ship block of given size and weight, as OCX and glTF."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gantline.cli.lift import quantity_of
from gantline.cli.messages import stop, writing
from gantline.replacing import replace_bytes

if TYPE_CHECKING:
    from gantline.cad.ship_block import ShipBlock


def make_ship_block(
    output: Annotated[Path, typer.Argument(metavar="FILE", help="OCX file to write; a .glb goes beside it.")],
    length: Annotated[str, typer.Option(metavar="LENGTH", help="Length, along x: '43 m'.")],
    breadth: Annotated[str, typer.Option(metavar="LENGTH", help="Breadth, along y: '23 m'.")],
    height: Annotated[
        str, typer.Option(metavar="LENGTH", help="Height from bottom to uppermost deck: '11 m'.")
    ],
    mass: Annotated[str, typer.Option(metavar="MASS", help="Mass of all steel: '300 t'.")],
    centre_height: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help="Height of the centre of gravity: '5.1 m'.  [default: where the structure puts it]",
        ),
    ] = None,
    double_bottom: Annotated[
        str, typer.Option(metavar="LENGTH", help="Height of the inner bottom.")
    ] = "1.2 m",
    frame_spacing: Annotated[
        str, typer.Option(metavar="LENGTH", help="Between floors and web frames.")
    ] = "3.2 m",
    longitudinal_spacing: Annotated[
        str, typer.Option(metavar="LENGTH", help="Between longitudinals.")
    ] = "0.9 m",
    tween_decks: Annotated[
        int, typer.Option(metavar="N", help="Decks between inner bottom and uppermost deck.")
    ] = 0,
) -> None:
    """Make a ship block: double bottom, sides, decks, web frames and pillars of a given size and mass.

    Plate thicknesses are scaled until the mass is met exactly. Every part carries its weight in the OCX file.
    """
    from gantline.cad.errors import CadError
    from gantline.cad.glb import write_glb
    from gantline.cad.ocx_writer import write_ocx
    from gantline.cad.ship_block import ShipBlockSizes, ship_block

    if output.is_dir():
        stop(f"{output}: is a folder; a file is needed")
    beside = output.with_suffix(".glb")
    if beside == output:
        stop(f"{output}: is where the GLB goes; the OCX file has another ending, such as '.3docx'")
    try:
        sizes = ShipBlockSizes(
            length=quantity_of("--length", length, "length"),
            breadth=quantity_of("--breadth", breadth, "length"),
            height=quantity_of("--height", height, "length"),
            mass=quantity_of("--mass", mass, "mass"),
            centre_height=quantity_of("--centre-height", centre_height, "length"),
            double_bottom=quantity_of("--double-bottom", double_bottom, "length"),
            frame_spacing=quantity_of("--frame-spacing", frame_spacing, "length"),
            longitudinal_spacing=quantity_of("--longitudinal-spacing", longitudinal_spacing, "length"),
            tween_decks=tween_decks,
        )
        made = ship_block(sizes)
    except CadError as problem:
        stop(str(problem))
    with writing(output):
        output.parent.mkdir(parents=True, exist_ok=True)
        replace_bytes(output, write_ocx(made))
        replace_bytes(beside, write_glb(made.model))
    typer.echo("\n".join([*_summary(made), f"Written     {output}, {beside}"]))


def _summary(made: ShipBlock) -> list[str]:
    from gantline.units import format_quantity

    model = made.model
    whole = model.properties
    lines = [f"{model.name}"]
    for kind, parts in model.kinds:
        mass = sum(part.properties.mass for part in parts if part.properties is not None)
        lines.append(f"{kind!s:<12}{len(parts):4d}  {format_quantity(mass, 't', 2)}")
    x, y, z = (part + 0.0 for part in whole.centre.round(6))
    lines.append(
        f"{'Mass':<12}{format_quantity(whole.mass, 't', 3)}, centre of gravity ({x:.3f}, {y:.3f}, {z:.3f}) m"
    )
    xx, yy, zz = (value / 1e3 for value in whole.inertia.diagonal())
    lines.append(f"{'Inertia':<12}{xx:.0f}, {yy:.0f}, {zz:.0f} t m^2 about it")
    kinds: dict[str, float] = {}
    for name, thickness in made.thicknesses.items():
        kinds.setdefault(name.rstrip(" 0123456789.PS"), thickness)
    plates = ", ".join(f"{name.lower()} {1e3 * thickness:.2f} mm" for name, thickness in kinds.items())
    lines.append(f"{'Plates':<12}{plates}")
    return lines
