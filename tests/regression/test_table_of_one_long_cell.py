"""A table of RAOs, or of a recorded motion, with a cell that no CSV has.

A file of another kind may be one line without end, such as JSON or base64 under the name of the table. What
Python reads CSV with gives up at more than 131072 characters in a cell, with an error that nothing caught: a
traceback.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.hydro import DatabaseError, read_raos
from gantline.hydro.motion_record import read_motion_record

#: `csv.field_size_limit()` of Python.
MOST = 131_072
SAID = "has more than 131072 characters here; commas, tabs or semicolons part columns"


def written(folder: Path, text: str) -> Path:
    path = folder / "vessel.csv"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(("above", "line"), [("", 1), ("# from another program\n\n", 3)])
def test_it_is_said(tmp_path: Path, above: str, line: int) -> None:
    path = written(tmp_path, f"{above}{'x' * (MOST + 1)}\n")
    with pytest.raises(DatabaseError) as problem:
        read_raos(path, "lag")
    assert str(problem.value) == f"{path}:{line}: a column of RAOs {SAID}"


def test_it_is_said_of_a_later_line(tmp_path: Path) -> None:
    path = written(tmp_path, f"time [s],heave [m]\n0,0\n0.5,{'0' * (MOST + 1)}\n")
    with pytest.raises(DatabaseError) as problem:
        read_motion_record(path)
    assert str(problem.value) == f"{path}:3: a column of a record of motion {SAID}"


def test_one_as_long_as_may_be_is_a_number(tmp_path: Path) -> None:
    """0.1 with as many zeros in front as fit."""
    lines = ["time [s],heave [m]", *(f"{0.5 * k:g},{0.1 * (k % 3):g}" for k in range(40))]
    plain = read_motion_record(written(tmp_path, "\n".join(lines)))
    assert lines[2] == "0.5,0.1"
    lines[2] = f"0.5,{'0.1':0>{MOST}}"
    assert (read_motion_record(written(tmp_path, "\n".join(lines))).motion == plain.motion).all()
