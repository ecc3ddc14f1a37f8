"""Variables of a recording as a table: a row for each sample, a column for each named series."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from itertools import product
from math import prod
from pathlib import Path

from gantline.arguments import listed, path_of
from gantline.replacing import replaced
from gantline.results.recording import Recording, no_variable, recorded
from gantline.results.variable import FloatArray

#: Endings by which programs know other kinds of file, under which a table would not open.
_NO_CSV = frozenset({".html", ".json", ".nc", ".ods", ".parquet", ".xls", ".xlsx"})


class TableError(ValueError):
    """A table that cannot be made; the message is a plain sentence."""


class VariableError(TableError):
    """A variable that is asked for is not there, or not over time."""


def columns(recording: Recording, variables: Sequence[str] = ()) -> Iterator[tuple[str, FloatArray]]:
    """Columns of a table: `time [s]`, then `rope_tension.sling.S1 [N]` and so on, SI units.

    Args:
        recording: Any recording.
        variables: Which; all over time, but for `rope_point`, where none is named.

    Raises:
        TypeError: If these are no names.
        VariableError: If a variable is not there, or not over time.
    """
    if isinstance(variables, str):
        raise VariableError(f"'{variables}' is a text, and a list is needed, such as ['{variables}']")
    variables = listed(variables, "variables: a list of names", "such as ['hook_load']")
    known = recorded(recording).variables
    over_time = [name for name, one in known.items() if one.dims[:1] == ("time",) and name != "time"]
    for name in variables:
        if name not in over_time:
            raise VariableError(no_variable(name, over_time, "over time "))
    yield "time [s]", recording.time
    names = {**recording.coordinates, "rope_point": _points(recording)}
    for name in variables or [one for one in over_time if one != "rope_point"]:
        variable = recording[name]
        labels = [names.get(dim) or range(recording.sizes[dim]) for dim in variable.dims[1:]]
        flat = variable.values.reshape(len(recording.time), prod(variable.values.shape[1:]))
        for place, label in enumerate(product(*labels)):
            unit = (
                variable.unit
                if name != "joint_position"
                else _of_joint(recording, str(label[0]), variable.unit)
            )
            told = "" if unit == "1" else f" [{unit}]"
            yield f"{'.'.join([name, *map(str, label)])}{told}", flat[:, place]


def _of_joint(recording: Recording, joint: str, unknown: str) -> str:
    """Unit of the position of a joint; `unknown` of a recording that does not say which of them turn."""
    turning = recording.rig.turning
    if turning is None:
        return unknown
    return "rad" if joint in turning else "m"


def _points(recording: Recording) -> list[str]:
    """Points of drawn ropes by the rope that they are of, from its start: `sling.S1/0`, `sling.S1/1`."""
    ropes = recording.points_of_ropes
    named = {
        int(at): f"{rope}/{number}" for rope, points in ropes.items() for number, at in enumerate(points)
    }
    return [named[at] for at in sorted(named)]


def kept_as_text(cell: str) -> str:
    """A cell that no spreadsheet takes for a formula; numbers stay as they are."""
    if not cell.startswith(("=", "+", "-", "@")):
        return cell
    try:
        float(cell)
    except ValueError:
        return f"'{cell}"
    return cell


def csv_file(path: str | Path) -> Path:
    """The name of a table.

    Raises:
        TableError: If it ends as that of a file of another kind.
    """
    file = path_of(path, "a file to write")
    if file.suffix.lower() in _NO_CSV:
        raise TableError(f"{file}: a table in CSV is {file.stem}.csv, which spreadsheets open")
    return file


def write_csv(recording: Recording, path: str | Path, variables: Sequence[str] = ()) -> Path:
    """Write a table as CSV; numbers read back to the last digit.

    Names that a spreadsheet could take for a formula get an apostrophe before them.

    Args:
        recording: Any recording.
        path: File to write, such as `lift.csv`.
        variables: Which, such as `["hook_load"]`; all over time, but for `rope_point`, where none is named.

    Returns:
        The path written.

    Raises:
        TableError: If a variable is not there, or not over time, or the name is that of another kind of file.
        OSError: If it cannot be written there.
    """
    found, target = list(columns(recording, variables)), csv_file(path)
    with replaced(target) as trial, trial.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([kept_as_text(name) for name, _ in found])
        writer.writerows(zip(*(map(repr, map(float, values)) for _, values in found), strict=True))
    return target


def write_parquet(recording: Recording, path: str | Path, variables: Sequence[str] = ()) -> Path:
    """Write a table as Parquet, by pyarrow; for its arguments see `write_csv`.

    Returns:
        The path written.

    Raises:
        TableError: If a variable is not there, or pyarrow is not installed.
        OSError: If it cannot be written there.
    """
    target = path_of(path, "a file to write")
    try:
        import pyarrow
        from pyarrow import parquet
    except ImportError:
        raise TableError(
            "Parquet needs the package pyarrow, which is not installed; CSV needs nothing"
        ) from None
    found = pyarrow.table(dict(columns(recording, variables)))
    # Files of Python say what is wrong with a disk in words of the system, those of the package in its own.
    with replaced(target) as trial, trial.open("wb") as file:
        parquet.write_table(found, file)
    return target
