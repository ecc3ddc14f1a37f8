"""How a vessel answers waves, as a table: motion per metre of wave, RAOs of displacement.

Within the table and beyond its periods it is as wave forces of a hydrodynamic database are: splines over
frequency and direction, nothing for shorter waves, that of its longest for longer ones.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
import numpy.typing as npt

from gantline.arguments import path_of
from gantline.hydro.database import AXES, DatabaseError, ForcesAround
from gantline.hydro.database.around import all_round
from gantline.hydro.table_file import Titles, read_table

__all__ = ["DisplacementRaos", "Phases", "read_raos", "write_raos"]

Array = npt.NDArray[np.float64]
Complex = npt.NDArray[np.complex128]

#: Whether phases of a table are told as how late a motion is after the crest, or how early before it.
Phases = Literal["lag", "lead"]

#: Units that a column may have, and what one of them is in SI; ω of a period T is 2π/T.
_ANGLE = {"deg": math.radians(1.0), "rad": 1.0}
_UNITS: Mapping[str, Mapping[str, float]] = {
    "direction": _ANGLE,
    "period": {"s": 1.0},
    **{
        key: unit
        for place, axis in enumerate(AXES)
        for key, unit in (
            (axis, {"m/m": 1.0} if place < 3 else {"deg/m": _ANGLE["deg"], "rad/m": 1.0}),
            (f"{axis} phase", _ANGLE),
        )
    },
}
_TITLES = Titles(
    _UNITS,
    tuple(_UNITS),
    "RAOs",
    "'direction [deg]', 'period [s]', 'heave [m/m]', 'heave phase [deg]'",
    "a motion that there is none of is 0, and so is its phase",
    {
        "period": {
            "inf": "leave waves of infinite period out, longer ones than those of a table move as its longest"
        }
    },
)
#: Lines of a table that is read: 100 directions of 1000 periods, and no more.
_MOST_ROWS = 100_000
#: What no vessel does, and of which numbers have slipped [m/m or rad/m].
_NO_MOTION = 1000.0


@dataclass(frozen=True, eq=False)
class DisplacementRaos:
    """Motion of a vessel per metre of wave amplitude.

    The motion of the point that it is of is Re(X exp(−iωt)) in the wave Re(exp(i(k·x − ωt))), x from that
    point: surge forward, sway to port, heave up, roll to starboard, pitch by the bow down, yaw to port.

    Attributes:
        source: name of its file.
        frequencies: ω, rising (n,) [rad/s].
        directions: that waves run in, from the vessel's x towards y (k,) [rad].
        motion: X (n, k, 6) [m/m, rad/m].
    """

    source: str
    frequencies: Array
    directions: Array
    motion: Complex

    def around(self, frequency: Array) -> ForcesAround:
        """X of waves of these frequencies (n,) [rad/s] in all directions, mirrored where it has one side."""
        mirror = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])
        motion, directions = all_round(self.directions, self.motion, mirror)
        return ForcesAround.between(self.frequencies, motion, frequency, directions)

    def at(self, frequency: Array, direction: float) -> Complex:
        """X of waves in one direction, from the vessel's x towards y [rad], shape (n, 6).

        Args:
            frequency: of the waves (n,) [rad/s].
            direction: that they run in [rad].

        Raises:
            DatabaseError: if the table has none within 60 degrees there.
        """
        found = self.around(frequency).at(direction)
        if found is None:
            shown = ", ".join(f"{angle:.4g}" for angle in np.degrees(np.sort(self.directions))[:12])
            wanted = f"{math.degrees(direction) % 360.0:.4g} deg"
            sentence = f"no waves that run {wanted} from its bow; it has {shown} deg"
            raise DatabaseError(
                f"{self.source}: {sentence}; between two that are at most 60 deg apart it is known"
            )
        return found


def read_raos(path: str | Path, phases: Phases) -> DisplacementRaos:
    """A table of RAOs.

    Its first line names the columns with their units, `direction [deg]`, `period [s]`, `surge [m/m]`,
    `surge phase [deg]` to `yaw [deg/m]`, `yaw phase [deg]`, in any order; every other line is one wave.
    Columns are parted by commas, by tabs, or by semicolons, where numbers may have decimal commas.

    Args:
        path: of the file.
        phases: `lag` where a phase says how late a motion is after the crest at the vessel's point, `lead`
            where how early before it.

    Raises:
        DatabaseError: if it cannot be read, with the line, in one plain sentence.
    """
    place = path_of(path, "the file of a table of motions")
    _, lines = read_table(place, _TITLES)
    values: dict[tuple[float, float], tuple[int, Complex]] = {}
    for number, said in lines:
        wave = round(math.degrees(said["direction"]) % 360.0, 6), said["period"]
        if not wave[1] > 0.0:
            raise DatabaseError(f"{place}:{number}: a period of {wave[1]:g} s; one above 0 s is right")
        if wave in values:
            again = f"waves of {wave[1]:g} s in {wave[0]:g} deg"
            told = math.degrees(said["direction"])
            same = f"; {told:g} deg is that direction" if abs(told - wave[0]) > 1.0 else ""
            raise DatabaseError(f"{place}:{number}: {again} stand in line {values[wave][0]} already{same}")
        values[wave] = number, np.array([_phasor(place, number, said, axis, phases) for axis in AXES])
        if len(values) > _MOST_ROWS:
            raise DatabaseError(f"{place}:{number}: more than {_MOST_ROWS} waves; none needs that many")
    if not values:
        raise DatabaseError(f"{place}: has no waves; below the names of its columns each line is one")
    return _table(place, {wave: motion for wave, (_, motion) in values.items()})


def _phasor(place: Path, number: int, said: Mapping[str, float], axis: str, phases: Phases) -> complex:
    """X of one motion: cos(ωt − lag) is Re(exp(i lag) exp(−iωt))."""
    size, lag = said[axis], said[f"{axis} phase"] * (1.0 if phases == "lag" else -1.0)
    if size < 0.0:
        raise DatabaseError(f"{place}:{number}: a {axis} below zero; its phase tells its direction")
    if size > _NO_MOTION:
        unit = "m/m" if AXES.index(axis) < 3 else "rad/m"
        raise DatabaseError(f"{place}:{number}: a {axis} of {size:.3g} {unit}; see its number and its unit")
    return complex(size * math.cos(lag), size * math.sin(lag))


def _table(place: Path, values: Mapping[tuple[float, float], Complex]) -> DisplacementRaos:
    directions = sorted({direction for direction, _ in values})
    periods = sorted({period for _, period in values}, reverse=True)
    for direction in directions:
        for period in periods:
            if (direction, period) not in values:
                wave = f"{period:g} s in {direction:g} deg"
                raise DatabaseError(f"{place}: has no waves of {wave}; every direction needs all periods")
    motion = np.array([[values[direction, period] for direction in directions] for period in periods])
    return DisplacementRaos(
        place.name, 2 * math.pi / np.array(periods), np.radians(np.array(directions)), motion
    )


def write_raos(raos: DisplacementRaos, path: str | Path) -> None:
    """Write a table that `read_raos` reads, with phases as lags in degrees and turns in degrees.

    Args:
        raos: any.
        path: of the file, `.csv`.
    """
    with path_of(path, "a file to write").open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([f"{name} [{next(iter(unit))}]" for name, unit in _UNITS.items()])
        for place, direction in enumerate(np.degrees(raos.directions)):
            for omega, motion in zip(raos.frequencies, raos.motion[:, place], strict=True):
                size = np.abs(motion) * np.repeat([1.0, 1.0 / _ANGLE["deg"]], 3)
                both = zip(size, np.degrees(np.angle(motion)), strict=True)
                row = [direction, 2 * math.pi / omega, *(value for one in both for value in one)]
                writer.writerow([f"{value:.12g}" for value in row])
