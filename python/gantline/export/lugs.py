"""What each lug carries as a table, for those who design the structure around it."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator
from pathlib import Path

from gantline.checks.lug_figures import LugFigures, lug_figures
from gantline.export.tables import TableError, csv_file, kept_as_text
from gantline.replacing import replaced
from gantline.results.recording import Recording

__all__ = ["write_lugs"]

_KILO = 1e3
#: Tonne-force [N], as load cells show it.
_TONNE = 9.81e3
_HEAD = (
    "lug", "slings", "x [m]", "y [m]", "z [m]", "static [kN]", "static [t]", "force [kN]", "force [t]",
    "force x [kN]", "force y [kN]", "force z [kN]", "out of plane [deg]", "capacity [kN]", "capacity [t]",
    "used [%]", "at [s]", "how", "remark",
)  # fmt: skip


def write_lugs(recording: Recording, path: str | Path) -> Path:
    """Write a row for each lug as CSV, in kN and t: `gantline.checks.lug_figures` says what stands in it.

    Places are from the centre of gravity of load or spreader, and components of the force along its axes,
    from the lug towards the slings. What is not known is left empty.

    Args:
        recording: Of a run, or of an equilibrium.
        path: File to write, such as `lugs.csv`.

    Returns:
        The path written.

    Raises:
        TableError: If nothing is made fast to a lug, or the name is that of another kind of file.
        OSError: If it cannot be written there.
    """
    found = lug_figures(recording)
    if not found:
        raise TableError("no sling or rope of this recording is made fast to a lug")
    target = csv_file(path)
    with replaced(target) as trial, trial.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(_HEAD)
        writer.writerows([kept_as_text(cell) for cell in _row(one)] for one in found)
    return target


def _row(one: LugFigures) -> Iterator[str]:
    yield one.lug
    yield ", ".join(one.slings)
    yield from (_number(place, 1.0, 4) for place in one.at)
    for force in (one.static, one.force):
        yield _number(force, _KILO, 2)
        yield _number(force, _TONNE, 3)
    yield from (_number(None if one.force is None else part, _KILO, 2) for part in one.pull)
    yield _number(one.out_of_plane, math.radians(1.0), 2)
    yield _number(one.capacity, _KILO, 2)
    yield _number(one.capacity, _TONNE, 3)
    yield _number(one.used, 0.01, 1)
    yield _number(one.time, 1.0, 3)
    yield one.text
    yield one.remark


def _number(value: float | None, unit: float, digits: int) -> str:
    """A number in its unit, or an empty cell; a rounded zero has no sign."""
    return "" if value is None or math.isnan(value) else f"{round(value / unit, digits) + 0.0:.{digits}f}"
