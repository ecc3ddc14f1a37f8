"""Text tables whose first line names columns and units, `heave [m/m]`, and whose other lines are numbers."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from gantline.hydro.database import DatabaseError

__all__ = ["Titles", "numbers_of", "read_rows"]

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


def read_rows(place: Path) -> Iterator[tuple[int, list[str]]]:
    """Lines of a table that are not empty and no remarks, with their numbers, in columns.

    Columns are parted by commas, by tabs, or by semicolons, where numbers may have decimal commas.

    Raises:
        DatabaseError: if the file cannot be read, in one plain sentence.
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
    return _rows(text)


def _rows(text: str) -> Iterator[tuple[int, list[str]]]:
    lines = text.splitlines()
    first = next((line for line in lines if line.strip() and not line.startswith("#")), "")
    by = ";" if ";" in first else "\t" if "\t" in first else ","
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.startswith("#"):
            continue
        row = next(csv.reader([line], delimiter=by))
        yield number, [cell.replace(",", ".") for cell in row] if by == ";" else row


def numbers_of(
    titles: Titles, at: tuple[Path, int], row: list[str], scale: Mapping[str, float]
) -> dict[str, float]:
    """The numbers of a line by column, in SI.

    Args:
        titles: of the table.
        at: its file, and the number of the line.
        row: its cells.
        scale: what one of the unit of each column is in SI, in the order of the cells.

    Raises:
        DatabaseError: if one is none, or there are too few or too many.
    """
    place, number = at
    if len(row) != len(scale):
        raise DatabaseError(f"{place}:{number}: {len(row)} numbers; there are {len(scale)} columns")
    found = {}
    for cell, (name, unit) in zip(row, scale.items(), strict=True):
        try:
            value = float(cell)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            shown = f"'{cell.strip()[:40]}' is no number; it is the {name}"
            raise DatabaseError(f"{place}:{number}: {shown}{_hint(titles, cell, name)}")
        found[name] = value * unit
    return found


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
