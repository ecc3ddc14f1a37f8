"""Text tables whose first line names columns and units: what is read of them, and what is said of others."""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.hydro import DatabaseError
from gantline.hydro.table_file import Titles, read_table

#: Three columns that are needed and one that is not; of one of them two units.
TITLES = Titles(
    units={"time": {"s": 1.0}, "sea level": {"m": 1.0, "mm": 1e-3}, "heel": {"deg": 2.0}, "draft": {"m": 1}},
    needed=("time", "sea level", "heel"),
    what="tides",
    right="'time [s]', 'sea level [m]'",
    empty="leave the line out",
    hints={},
)
HEAD = "time [s],sea level [m],heel [deg]"


def written(folder: Path, *lines: str, encoding: str = "utf-8") -> Path:
    path = folder / "table.csv"
    path.write_text("\n".join(lines) + "\n", encoding=encoding)
    return path


def read(path: Path) -> tuple[tuple[str, ...], list[tuple[int, list[float]]]]:
    columns, lines = read_table(path, TITLES)
    return columns, [(number, list(line.values())) for number, line in lines]


def refusal(path: Path) -> str:
    with pytest.raises(DatabaseError) as problem:
        read(path)
    return str(problem.value).removeprefix(f"{path}")


@pytest.mark.parametrize(
    ("mark", "encoding"), [(",", "utf-8"), ("\t", "utf-8"), (";", "utf-8"), (";", "utf-8-sig")]
)
@pytest.mark.parametrize("above", [(), ("",), ("   ", "# 1; 2, 3\t4")])
def test_lines_are_numbered_and_columns_parted(
    tmp_path: Path, mark: str, encoding: str, above: tuple[str, ...]
) -> None:
    """Whatever stands above; empty lines and remarks count as lines of the file. In SI: mm are 1/1000 m."""
    lines = ["1,-2.5,3", "  ", "# 7,8,9", "4,5e2,6"]
    head = " TIME [s],Sea  Level [ mm ],heel[deg]"
    path = written(tmp_path, *above, *(line.replace(",", mark) for line in (head, *lines)), encoding=encoding)
    first = len(above) + 1
    columns, found = read(path)
    assert columns == ("time", "sea level", "heel")
    assert found == [(first + 1, [1.0, -2.5e-3, 6.0]), (first + 4, [4.0, 0.5, 12.0])]


def test_how_many_columns_are_missing(tmp_path: Path) -> None:
    assert refusal(written(tmp_path, "draft [m]")) == ":1: there is no column 'time [s]' and 2 more"
    assert refusal(written(tmp_path, "heel [deg]")) == ":1: there is no column 'time [s]' and 1 more"
    assert refusal(written(tmp_path, "", "heel [deg],time [s]")) == ":2: there is no column 'sea level [m]'"
    assert refusal(written(tmp_path, "")) == ":1: there is no column 'time [s]' and 2 more"


def test_units_that_a_column_may_have_are_said(tmp_path: Path) -> None:
    """Names may be written large, units not: a millimetre is no megametre."""
    said = ":1: 'sea level [Mm]' has no unit of it; 'sea level [m]' or 'sea level [mm]' is right"
    assert refusal(written(tmp_path, HEAD.replace("[m]", "[Mm]"))) == said


def test_of_a_long_title_and_a_long_number_the_begin_is_shown(tmp_path: Path) -> None:
    """40 characters of each."""
    for length in (40, 41):
        said = f":1: '{'x' * 40}' is no column of tides; 'time [s]', 'sea level [m]' are right"
        assert refusal(written(tmp_path, "x" * length)) == said
        said = f":2: '{'x' * 40}' is no number; it is the heel"
        assert refusal(written(tmp_path, HEAD, f"1,2,{'x' * length}")) == said
        said = f":2: '{'1' * 39},' in line 2 has a comma, '3.5' in line 2 a point"
        mixed = f"1;{'1' * 39},{'1' * (length - 40)};3.5"
        assert refusal(written(tmp_path, HEAD.replace(",", ";"), mixed)).startswith(said)


def test_what_is_too_large_is_not_read(tmp_path: Path) -> None:
    """50 MB, of which nothing but their size is on the disk; just as many are read, a remark and no table."""
    path = tmp_path / "table.csv"
    path.write_bytes(b"#")
    with path.open("r+b") as file:
        file.truncate(50_000_000)
    assert refusal(path) == ":1: there is no column 'time [s]' and 2 more"
    with path.open("r+b") as file:
        file.truncate(50_000_001)
    assert refusal(path) == ": larger than 50 MB, so it is not read"


def test_what_is_no_file_is_said(tmp_path: Path) -> None:
    for name, why in (("none.csv", "no such file or directory"), ("", "is a directory")):
        assert refusal(tmp_path / name) == f": cannot be read ({why})"
