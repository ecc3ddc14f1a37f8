"""What `gantline hydro` says of a hydrodynamic database."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import typer

from gantline.cli.messages import DONE, stop, warn
from gantline.cli.table import table

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from gantline.hydro import HydrodynamicDatabase

#: Share of the largest force of a unit below which one is rounding [1].
_ROUNDING = 1e-6
#: Motions that are shown: number, name, and units of their added mass and damping.
_SHOWN = ((2, "heave", "t", "kN s/m"), (3, "roll", "t m²", "kN m s"), (4, "pitch", "t m²", "kN m s"))


#: Forces of waves that are shown: motion, units of force over amplitude and of drift force over its square.
_PUSHES = (
    *((name, "kN/m", "kN/m²") for name in ("surge", "sway", "heave")),
    *((name, "kN", "kN/m") for name in ("roll", "pitch", "yaw")),
)


def show_database(
    path: Path, body: str | None, directions: Sequence[float], as_json: bool, refused: Sequence[str]
) -> NoReturn:
    """Print tables of a database, or all of its numbers as JSON, and end.

    Args:
        path: the file.
        body: of the file, where it has several.
        directions: of waves whose forces are wanted, from body x towards y [rad].
        as_json: whether as JSON, SI units.
        refused: options that were given and have no meaning here.
    """
    if refused:
        stop(f"{refused[0]}: is for a hull; {path} is a hydrodynamic database")
    from gantline.hydro import DatabaseError, read_database

    try:
        found = read_database(path, body)
        waves = [_Waves.of(found, direction) for direction in directions]
    except DatabaseError as problem:
        stop(str(problem))
    if as_json:
        numbers = {**_as_json(found), "waves": [one.to_json() for one in waves]}
        typer.echo(json.dumps(numbers, indent=2, allow_nan=False))
    else:
        typer.echo("\n".join([*_report(found), *(line for one in waves for line in one.table(found))]))
    for doubt in (*found.doubts, *found.outlying(None)):
        warn(doubt)
    raise typer.Exit(DONE)


@dataclass(frozen=True)
class _Waves:
    """What waves of the frequencies of a database push with.

    Attributes:
        direction: that they run in, from body x towards y [rad].
        forces: over the amplitude (n, 6) [N/m, N].
        drift: of surge, sway and yaw over its square (n, 3) [N/m², N/m], if the file has any.
    """

    direction: float
    forces: npt.NDArray[np.complex128]
    drift: npt.NDArray[np.float64] | None

    @classmethod
    def of(cls, found: HydrodynamicDatabase, direction: float) -> _Waves:
        """Those of a database, between its directions by splines.

        Raises:
            DatabaseError: if it has none, or none close to that direction.
        """
        density = found.density or 1.0
        forces, _ = found.excitation_at(found.frequencies, direction, density)
        around = found.drift_around(found.frequencies, density)
        drift = None if around is None else around.at(direction)
        return cls(direction, forces, None if drift is None else drift.real)

    def table(self, found: HydrodynamicDatabase) -> list[str]:
        """Sizes of the forces, over the period; what is rounding beside others of its unit is 0."""
        from gantline.hydro.database.model import DRIFTING

        sizes = abs(self.forces)
        columns = [(name, unit, sizes[:, k]) for k, (name, unit, _) in enumerate(_PUSHES)]
        if self.drift is not None:
            units = {name: unit for name, _, unit in _PUSHES}
            columns += [(f"drift {name}", units[name], self.drift[:, k]) for k, name in enumerate(DRIFTING)]
        kinds = [(name.startswith("drift"), unit) for name, unit, _ in columns]
        most = dict.fromkeys(kinds, 0.0)
        for kind, (_, _, values) in zip(kinds, columns, strict=True):
            most[kind] = max(most[kind], float(abs(values).max()))
        names = ["Period", *(name for name, *_ in columns)]
        cells = [("[s]", *(f"[{unit}]" for _, unit, _ in columns))]
        for k in reversed(range(len(found.periods))):
            row = [
                f"{values[k] / 1e3:.4g}" if abs(values[k]) > _ROUNDING * most[kind] else "0"
                for kind, (_, _, values) in zip(kinds, columns, strict=True)
            ]
            cells.append((f"{found.periods[k]:.3f}", *row))
        runs = f"Waves that run {math.degrees(self.direction):.4g} deg from its bow: sizes of forces"
        runs += f" beside {', '.join(found.others)} held fast," if found.others else ""
        per = "per metre of amplitude" + ("" if self.drift is None else ", drift forces per square metre")
        return ["", f"{runs} {per}", *table(tuple(names), cells, "r" * len(names))]

    def to_json(self) -> dict[str, Any]:
        """SI units, time as exp(−iωt)."""
        return {
            "direction": self.direction,
            "excitation_real": self.forces.real.tolist(),
            "excitation_imaginary": self.forces.imag.tolist(),
            "drift": None if self.drift is None else self.drift.tolist(),
        }


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
    if found.others:
        parts.append(f"beside {', '.join(found.others)}")
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
        "others": {
            name: {"added_mass": other.added_mass.tolist(), "damping": other.damping.tolist()}
            for name, other in found.others.items()
        },
    }
