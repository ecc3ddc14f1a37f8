"""Text tables whose first line names columns and units, `heave [m/m]`, and whose other lines are numbers."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from gantline.hydro.database import DatabaseError

__all__ = ["Titles", "read_table"]

#: A column of the first line: its name and its unit.
_TITLE = re.compile(r"\s*(.*?)\s*\[\s*(.*?)\s*\]\s*")
#: Bytes of a table that is read, and no more.
_LARGEST = 50_000_000


@dataclass(frozen=True)
class Titles:
    """What columns a table may have.

    Attributes:
        units: of every column the units that it may have, and what one of them is in SI.
        needed: columns that no table does without.
        what: what they are columns of, such as `RAOs`.
        right: some that are right, for who has written others.
        empty: what to say of a cell in which nothing stands.
        hints: of a column what to say of a cell that is no number, by what stands in it.
    """

    units: Mapping[str, Mapping[str, float]]
    needed: tuple[str, ...]
    what: str
    right: str
    empty: str
    hints: Mapping[str, Mapping[str, str]]

    def of(self, place: Path, number: int, titles: list[str]) -> dict[str, float]:
        """What each column is, in its order, and what one of its unit is in SI.

        Raises:
            DatabaseError: if one is none, or one that is needed is not there.
        """
        found: dict[str, float] = {}
        for title in titles:
            parts = _TITLE.fullmatch(title)
            name, unit = (" ".join(title.split()).lower(), "") if parts is None else parts.groups()
            name = " ".join(name.lower().split())
            known = self.units.get(name)
            shown = f"{place}:{number}: '{title.strip()[:40]}'"
            if known is None:
                raise DatabaseError(f"{shown} is no column of {self.what}; {self.right} are right")
            if unit not in known:
                right = " or ".join(f"'{name} [{one}]'" for one in known)
                raise DatabaseError(f"{shown} has no unit of it; {right} is right")
            if name in found:
                raise DatabaseError(f"{place}:{number}: there are two columns '{name}'")
            found[name] = known[unit]
        missing = [name for name in self.needed if name not in found]
        if missing:
            more = f" and {len(missing) - 1} more" if len(missing) > 1 else ""
            unit = next(iter(self.units[missing[0]]))
            raise DatabaseError(f"{place}:{number}: there is no column '{missing[0]} [{unit}]'{more}")
        return found


def read_table(place: Path, titles: Titles) -> tuple[tuple[str, ...], Iterator[tuple[int, dict[str, float]]]]:
    """Columns of a table, and its other lines with their numbers, by column in SI.

    Columns are parted by commas, by tabs, or by semicolons, where numbers may have decimal commas.
    Lines that are empty or begin with # are none.

    Args:
        place: of the file.
        titles: what columns it may have.

    Raises:
        DatabaseError: if the file or a line of it cannot be read, in one plain sentence; of lines as they are
            asked for.
    """
    try:
        if place.stat().st_size > _LARGEST:
            raise DatabaseError(f"{place}: larger than {_LARGEST // 1_000_000} MB, so it is not read")
        text = place.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise DatabaseError(f"{place}: is no text in UTF-8; save it as CSV in UTF-8") from None
    except OSError as problem:
        reason = (problem.strerror or str(problem)).lower()
        raise DatabaseError(f"{place}: cannot be read ({reason})") from None
    by = _parted_by(text)
    rows = _rows(text, by, (place, titles))
    scale = titles.of(place, *next(rows, (1, [])))
    return tuple(scale), _lines(rows, (place, titles), scale, by)


def _parted_by(text: str) -> str:
    """What parts the columns of the line that names them."""
    first = next((line for line in text.splitlines() if line.strip() and not line.startswith("#")), "")
    return ";" if ";" in first else "\t" if "\t" in first else ","


def _rows(text: str, by: str, of: tuple[Path, Titles]) -> Iterator[tuple[int, list[str]]]:
    """Lines that are not empty and no remarks, with their numbers, in columns."""
    place, titles = of
    for number, line in enumerate(text.splitlines(), 1):
        if line.strip() and not line.startswith("#"):
            try:
                row = next(csv.reader([line], delimiter=by))
            except csv.Error:  # the one that is left of whole lines: a cell that is too long
                found = f"a column of {titles.what} has more than {csv.field_size_limit()} characters here"
                right = "commas, tabs or semicolons part columns"
                raise DatabaseError(f"{place}:{number}: {found}; {right}") from None
            yield number, row


def _lines(
    rows: Iterator[tuple[int, list[str]]], of: tuple[Path, Titles], scale: Mapping[str, float], by: str
) -> Iterator[tuple[int, dict[str, float]]]:
    place, titles = of
    marks: dict[str, tuple[int, str]] = {}
    for number, row in rows:
        plain = _with_points(place, number, row, marks) if by == ";" else row
        if len(row) != len(scale):
            raise DatabaseError(f"{place}:{number}: {len(row)} numbers; there are {len(scale)} columns")
        found = {}
        for cell, written, (name, unit) in zip(plain, row, scale.items(), strict=True):
            try:
                value = float(cell)
            except ValueError:
                value = math.nan
            if not math.isfinite(value):
                shown = f"'{written.strip()[:40]}' is no number; it is the {name}"
                raise DatabaseError(f"{place}:{number}: {shown}{_hint(titles, written, name)}")
            found[name] = value * unit
        yield number, found


def _with_points(place: Path, number: int, row: list[str], marks: dict[str, tuple[int, str]]) -> list[str]:
    """A line with decimal points; `marks` has of both marks the first number and its line, and grows.

    Where a table has both, one of them may part thousands: 1,004 beside 0.97 is 1004 as well as 1.004.
    """
    for cell in row:
        for mark in ",.":
            if mark in cell:
                marks.setdefault(mark, (number, cell.strip()[:40]))
    if len(marks) > 1:
        (line, comma), (other, point) = marks[","], marks["."]
        if comma != point:
            both = f"'{comma}' in line {line} has a comma, '{point}' in line {other} a point"
            right = "decimals take one of them throughout, thousands no mark"
            raise DatabaseError(f"{place}:{number}: {both}; {right}")
    return [cell.replace(",", ".") for cell in row]


def _hint(titles: Titles, cell: str, name: str) -> str:
    """What is right in place of a cell that is no number, where that is known."""
    for part, hint in titles.hints.get(name, {}).items():
        if part in cell.lower():
            return f"; {hint}"
    if not cell.strip():
        return f"; {titles.empty}"
    if "%" in cell:
        return "; 30 % is 0.3"
    if "," in cell:
        return "; decimals take a point, or a comma where semicolons part the columns, thousands no mark"
    return ""
