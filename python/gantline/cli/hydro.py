"""`gantline hydro`: what a hull displaces at its drafts, and how it rights itself."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from gantline.cli.lift import quantity_of, refuse_to_replace, unit_of
from gantline.cli.messages import DONE, stop, warn, writing
from gantline.cli.spans import values_of_option
from gantline.replacing import replaced

if TYPE_CHECKING:
    from gantline.hydro import Hull, Hydrostatics, RightingArms

#: Axes of a file that may point up.
_AXES: dict[str, Literal["y", "z"]] = {"y": "y", "z": "z"}
#: Drafts and angles where none are asked for.
_DRAFTS = 9
#: Curves of righting arms in one table and picture.
_CURVES = 5


def hydro(
    hull: Annotated[
        str,
        typer.Argument(
            metavar="HULL",
            help="File of the hull: STL, OBJ, GLB, STEP or IGES; or a box as in box:100m,30m,8m; or a "
            "hydrodynamic database: .nc, .h5, .dhyd, .hyd.",
        ),
    ],
    drafts: Annotated[
        str | None,
        typer.Option(
            metavar="DRAFTS",
            help="Drafts above z = 0 of the hull, such as '4 m, 4.5 m' or '2 m..6 m/9'.  "
            "[default: round ones over its depth]",
        ),
    ] = None,
    heel: Annotated[
        str | None,
        typer.Option(
            metavar="ANGLES", help="Angles of heel for righting arms, such as '0 deg..60 deg/13'; with --kg."
        ),
    ] = None,
    kg: Annotated[
        str | None,
        typer.Option(metavar="HEIGHT", help="Centre of gravity above z = 0, such as '5 m'; shows GM."),
    ] = None,
    trim: Annotated[
        str | None,
        typer.Option(metavar="ANGLE", help="Trim by the stern, such as '1 deg'.  [default: even keel]"),
    ] = None,
    density: Annotated[str, typer.Option(metavar="DENSITY", help="Density of the water.")] = "1.025 t/m^3",
    unit: Annotated[
        str | None,
        typer.Option(
            metavar="UNIT",
            help="Unit of length in the file.  [default: what it says, else m]",
            show_default=False,
        ),
    ] = None,
    up: Annotated[
        str | None,
        typer.Option(
            metavar="AXIS", help="Axis of the file that points up, y or z.  [default: y in glTF, z elsewhere]"
        ),
    ] = None,
    half: Annotated[
        bool,
        typer.Option(
            "--half", help="The file has one side of the hull, up to the centre plane y = 0; mirror it."
        ),
    ] = False,
    body: Annotated[
        str | None, typer.Option(metavar="NAME", help="Body of a hydrodynamic database that has several.")
    ] = None,
    waves: Annotated[
        str | None,
        typer.Option(
            metavar="ANGLES",
            help="Directions of waves, such as '0 deg, 45 deg': what a hydrodynamic database has of their "
            "forces. From body x towards y, where they run to; 180 deg is head sea.",
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="FILE", help="Picture of the curves, such as hull.png, .svg or .pdf."
        ),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print all numbers as JSON, SI units.")] = False,
) -> None:
    """Print hydrostatics of a hull over its drafts, with righting arms where angles and --kg are given.

    Figures are exact for the mesh. Righting arms are free to trim, at the displacement of each draft. Of a
    hydrodynamic database: added mass and damping over the period, and forces of waves with --waves.
    """
    from gantline.hydro.database import DATABASE_FORMATS

    if Path(hull).suffix.lower() in DATABASE_FORMATS:
        from gantline.cli.hydro_database import show_database

        given = {
            "--drafts": drafts,
            "--heel": heel,
            "--kg": kg,
            "--trim": trim,
            "--unit": unit,
            "--up": up,
            "--half": half or None,
            "--output": output,
        }
        refused = [name for name, value in given.items() if value is not None]
        show_database(Path(hull), body, values_of_option("--waves", waves, "angle") or [], as_json, refused)
    for name, value in (("--body", body), ("--waves", waves)):
        if value is not None:
            stop(f"{name}: is for a hydrodynamic database; this is a hull")
    water = quantity_of("--density", density, "density")
    height, tilt = quantity_of("--kg", kg, "length"), quantity_of("--trim", trim, "angle")
    angles = values_of_option("--heel", heel, "angle")
    _refuse_angles(angles, height)
    from gantline.scenario.afloat.water import HEAVIEST_WATER, LIGHTEST_WATER

    if not water or not LIGHTEST_WATER <= water <= HEAVIEST_WATER:
        stop(f"--density: {density!r} is not the density of water; sea water has '1.025 t/m^3'")
    if tilt is not None and abs(tilt) > math.radians(45):
        stop(f"--trim: {trim!r} is too steep; at most 45 deg, to either side")
    if up is not None and up not in _AXES:
        stop(f"--up: {up!r} is no axis that a hull has upwards; 'y' or 'z' is right")
    _refuse_picture(hull, output)
    from gantline.hydro import Attitude, HullError, hydrostatics, read_hull

    try:
        found = read_hull(hull, unit_of(unit), up=_AXES.get(up or ""), half=half)
    except HullError as problem:
        stop(str(problem))
    low, high = found.box
    wanted = values_of_option("--drafts", drafts, "length") or _usual(float(low[2]), float(high[2]))
    middle = float(low[0] + high[0]) / 2
    rows = [hydrostatics(found, Attitude(draft, 0.0, tilt or 0.0, middle), water) for draft in wanted]
    _refuse_drafts(found, rows)
    arms = _righting(found, rows, angles, height) if angles is not None and height is not None else []
    if as_json:
        typer.echo(json.dumps(_as_json(found, rows, arms, height), indent=2, allow_nan=False))
    else:
        from gantline.cli.hydro_table import report

        typer.echo("\n".join(report(found, rows, arms, height)))
    for doubt in found.doubts():
        warn(f"{found.name}: {doubt}")
    if output is not None:
        _draw(found, rows, arms, height, output)
    raise typer.Exit(DONE)


def _refuse_angles(angles: list[float] | None, kg: float | None) -> None:
    if angles is None:
        return
    if kg is None:
        stop("--heel: righting arms need the centre of gravity; give it with --kg")
    if max(map(abs, angles)) > math.pi:
        stop("--heel: angles go up to 180 deg, to either side")


def _refuse_picture(hull: str, output: Path | None) -> None:
    if output is None:
        return
    from gantline.plot.hydrostatics import FORMATS

    if output.suffix.lower() not in FORMATS:
        stop(f"--output: '{output}' is no picture that can be drawn; names end in {', '.join(FORMATS)}")
    refuse_to_replace([Path(hull)], [output], "--output needs another file")


def _refuse_drafts(hull: Hull, rows: list[Hydrostatics]) -> None:
    """Refuse drafts at which nothing of the hull is in the water, or all of it."""
    low, high = hull.box[:, 2]
    vertices, triangles = hull.mesh
    places = vertices[triangles.reshape(-1)]
    for row in rows:
        # By heights, not by volume: what a hull without a deck has inside depends on where it is closed.
        heights = places @ row.attitude.normal + row.attitude.height
        if heights.min() >= 0 or heights.max() <= 0:
            where = "is out of the water" if heights.min() >= 0 else "is wholly under water"
            stop(
                f"--drafts: at {row.attitude.draft:g} m {hull.name} {where}; "
                f"it reaches from {low:g} to {high:g} m"
            )


def _usual(low: float, high: float) -> list[float]:
    """Round drafts over the middle of the depth [m]."""
    step = 10 ** math.floor(math.log10((high - low) / _DRAFTS))
    step = next(size * step for size in (1, 2, 2.5, 5, 10) if size * step * (_DRAFTS + 1) >= high - low)
    first = math.ceil((low + 0.5 * step) / step)
    return [k * step for k in range(first, first + 2 * _DRAFTS) if k * step < high - 0.25 * step]


def _righting(
    hull: Hull, rows: list[Hydrostatics], angles: list[float], kg: float
) -> list[tuple[Hydrostatics, RightingArms]]:
    """Righting arms at some of the drafts, with the centre of gravity above that of buoyancy."""
    from gantline.hydro import CannotFloatError, righting_arms

    count = min(_CURVES, len(rows))
    chosen = [rows[round(k * (len(rows) - 1) / max(count - 1, 1))] for k in range(count)]
    found = []
    for row in chosen:
        centre = row.centre_of_gravity_at(kg)
        try:
            arms = righting_arms(hull, row.mass, centre, angles, density=row.density)
        except CannotFloatError as problem:
            stop(f"--heel: {problem}")
        found.append((row, arms))
    return found


def _as_json(
    hull: Hull, rows: list[Hydrostatics], arms: list[tuple[Hydrostatics, RightingArms]], kg: float | None
) -> dict[str, Any]:
    closure = hull.closure
    listed: list[dict[str, Any]] = []
    for row in rows:
        figures = row.as_dict()
        if kg is not None:
            figures["gm_transverse"], figures["gm_longitudinal"] = row.gm(row.centre_of_gravity_at(kg))
        listed.append(figures)
    return {
        "hull": hull.name,
        "box": hull.box.tolist(),
        "density": rows[0].density,
        "kg": kg,
        "closure": {
            "is_closed": closure.is_closed,
            "boundary_edges": closure.boundary_edges,
            "boundary_length": closure.boundary_length,
            "lowest_boundary": closure.lowest_boundary if closure.boundary_edges else None,
            "turned_edges": closure.turned_edges,
            "crowded_edges": closure.crowded_edges,
            "unbalanced_area": closure.unbalanced_area.tolist(),
            "volume": closure.volume,
        },
        "hydrostatics": listed,
        "righting_arms": [
            {
                "draft": row.attitude.draft,
                "displacement": row.mass,
                "heel": curve.heel.tolist(),
                "arm": curve.arm.tolist(),
                "trim": curve.trim.tolist(),
            }
            for row, curve in arms
        ],
    }


def _draw(
    hull: Hull,
    rows: list[Hydrostatics],
    arms: list[tuple[Hydrostatics, RightingArms]],
    kg: float | None,
    output: Path,
) -> None:
    import numpy as np

    from gantline.hydro import Attitude, hydrostatics
    from gantline.plot.hydrostatics import HullCurves, hydrostatic_curves

    drafts = [row.attitude.draft for row in rows]
    first, last = min(drafts), max(drafts)
    fine = np.linspace(first, last, 120) if last > first else np.array([first])
    trim, middle = rows[0].attitude.trim, rows[0].attitude.middle
    smooth = [
        hydrostatics(hull, Attitude(float(draft), 0.0, trim, middle), rows[0].density) for draft in fine
    ]
    figures: dict[str, Any] = {
        "displacement": [row.mass for row in smooth],
        "waterplane_area": [row.waterplane_area for row in smooth],
        "wetted_surface": [row.wetted_surface for row in smooth],
        "kb": [row.kb for row in smooth],
        "km_transverse": [row.km_transverse for row in smooth],
        "km_longitudinal": [row.km_longitudinal for row in smooth],
        "lcb": [row.lcb for row in smooth],
        "lcf": [row.lcf for row in smooth],
    }
    curves = HullCurves(
        name=hull.name,
        mesh=hull.mesh,
        drafts=fine,
        marked=np.array(drafts),
        trim=trim,
        middle=middle,
        kg=kg,
        figures={name: np.array(values) for name, values in figures.items()},
        arms=[(row.attitude.draft, row.mass, curve.heel, curve.arm) for row, curve in arms],
    )
    with writing(output), replaced(output) as trial:
        hydrostatic_curves(curves).savefig(trial, format=output.suffix[1:].lower())
    typer.echo(f"picture: {output}", err=True)
