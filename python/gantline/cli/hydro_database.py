"""What `gantline hydro` says of a hydrodynamic database."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import typer

from gantline.cli.messages import DONE, stop, warn
from gantline.cli.table import table

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from gantline.hydro import HydrodynamicDatabase

#: Motions that are shown: number, name, and units of their added mass and damping.
_SHOWN = ((2, "heave", "t", "kN s/m"), (3, "roll", "t m²", "kN m s"), (4, "pitch", "t m²", "kN m s"))


def show_database(path: Path, body: str | None, as_json: bool, refused: Sequence[str]) -> NoReturn:
    """Print a table of a database, or all of its numbers as JSON, and end.

    Args:
        path: the file.
        body: of the file, where it has several.
        as_json: whether as JSON, SI units.
        refused: options that were given and have no meaning here.
    """
    if refused:
        stop(f"{refused[0]}: is for a hull; {path} is a hydrodynamic database")
    from gantline.hydro import DatabaseError, read_database

    try:
        found = read_database(path, body)
    except DatabaseError as problem:
        stop(str(problem))
    if as_json:
        typer.echo(json.dumps(_as_json(found), indent=2, allow_nan=False))
    else:
        typer.echo("\n".join(_report(found)))
    for doubt in found.doubts:
        warn(doubt)
    raise typer.Exit(DONE)


def _report(found: HydrodynamicDatabase) -> list[str]:
    water = "density not said" if found.density is None else f"for water of {found.density / 1e3:.4g} t/m³"
    about = "reference point not said"
    if found.reference is not None:
        about = f"about ({', '.join(f'{part:.4g}' for part in found.reference)}) m of the file"
    parts = [f"{found.name}, from {found.source}", water, about]
    if found.displacement is not None:
        parts.append(f"displaces {found.displacement:.6g} m³")
    if found.water_depth is not None:
        deep = math.isinf(found.water_depth)
        parts.append("deep water" if deep else f"water {found.water_depth:.4g} m deep")
    waves = (
        "no wave forces" if found.excitation is None else f"wave forces in {len(found.directions)} directions"
    )
    parts.append(waves + ("" if found.drift is None else ", with drift forces"))
    head, units = ["Period", "Frequency"], ["[s]", "[rad/s]"]
    for _, name, mass, damping in _SHOWN:
        head += [f"a {name}", f"b {name}"]
        units += [f"[{mass}]", f"[{damping}]"]
    cells = [tuple(units)]
    if found.infinite_added_mass is not None:
        cells.append(("0", "infinite", *_cells(found.infinite_added_mass, None)))
    rows = zip(found.periods, found.frequencies, found.added_mass, found.damping, strict=True)
    for period, frequency, mass, damping in reversed([*rows]):
        cells.append((f"{period:.3f}", f"{frequency:.4f}", *_cells(mass, damping)))
    shares = [f"{100 * share:.2g} %" for share in found.asymmetry]
    symmetry = (
        f"largest difference from the transpose: added mass {shares[0]}, damping {shares[1]} of the diagonal"
    )
    return [
        "; ".join(parts),
        symmetry,
        _memory(found),
        "",
        "Added mass a and damping b",
        *table(tuple(head), cells, "r" * len(head)),
    ]


def _memory(found: HydrodynamicDatabase) -> str:
    """How well the file serves as `radiation` of a vessel."""
    from gantline.hydro import DatabaseError, fit_memory

    try:
        misfit = fit_memory(found, found.density or 1.0).misfit
    except DatabaseError as problem:
        return f"for 'radiation', with memory: {problem}"
    return f"for 'radiation', with memory: the fit misses {misfit.in_words}"


def _cells(mass: npt.NDArray[np.float64], damping: npt.NDArray[np.float64] | None) -> list[str]:
    cells = []
    for axis, *_ in _SHOWN:
        cells.append(f"{mass[axis, axis] / 1e3:.6g}")
        cells.append("" if damping is None else f"{damping[axis, axis] / 1e3:.6g}")
    return cells


def _as_json(found: HydrodynamicDatabase) -> dict[str, Any]:
    depth, infinite, excitation = found.water_depth, found.infinite_added_mass, found.excitation
    return {
        "name": found.name,
        "source": found.source,
        "density": found.density,
        "reference": None if found.reference is None else found.reference.tolist(),
        "displacement": found.displacement,
        "water_depth": None if depth is None or math.isinf(depth) else depth,
        "is_deep": depth is not None and math.isinf(depth),
        "frequencies": found.frequencies.tolist(),
        "added_mass": found.added_mass.tolist(),
        "damping": found.damping.tolist(),
        "infinite_added_mass": None if infinite is None else infinite.tolist(),
        "directions": found.directions.tolist(),
        "excitation_real": None if excitation is None else excitation.real.tolist(),
        "excitation_imaginary": None if excitation is None else excitation.imag.tolist(),
        "drift": None if found.drift is None else found.drift.tolist(),
    }
