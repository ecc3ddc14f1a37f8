"""Plain text tables with aligned columns."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

from gantline.units import format_quantity

ABSENT = "-"

#: What takes the place of a blank that no line may end at.
_KEPT = "\u00a0"


def table(
    head: Sequence[str], rows: Sequence[Sequence[str]], align: str, width: int | None = None, keys: int = 1
) -> list[str]:
    """Lines of a table.

    Args:
        head: Titles of the columns.
        rows: Cells of each row.
        align: For each column `l` (left) or `r` (right).
        width: Columns of text that a line may have: where it is too wide its last columns stand in further
            tables below, each behind the first ones; as wide as it is if not given.
        keys: How many first columns say what a row is of.

    Returns:
        The head and one line for each row, indented below it, without trailing blanks.
    """
    if width is not None:
        return _continued(head, rows, align, width, keys)
    indented = [[f"  {row[0]}", *row[1:]] for row in rows]
    widths = [max(len(row[column]) for row in [list(head), *indented]) for column in range(len(head))]
    return [_line(row, widths, align) for row in [list(head), *indented]]


def _continued(
    head: Sequence[str], rows: Sequence[Sequence[str]], align: str, width: int, keys: int
) -> list[str]:
    """A table in as many as its width needs, each with the first columns and one more at least."""
    lines, done = list[str](), keys
    while done < len(head):
        for end in range(len(head), done, -1):
            columns = [*range(keys), *range(done, end)]
            cells = [[row[column] for column in columns] for row in (head, *rows)]
            part = table(cells[0], cells[1:], "".join(align[column] for column in columns))
            # A column without a title says more of the one before it.
            if max(map(len, part)) <= width and (end == len(head) or head[end]):
                break
        lines, done = lines + part, end
    return lines


def filled(
    head: Sequence[str], rows: Sequence[Sequence[str]], align: str
) -> tuple[list[str], list[list[str]], str]:
    """Head, rows and alignment of a table without the columns in which no row has anything."""
    kept = [column for column in range(len(head)) if any(row[column] != ABSENT for row in rows)]
    return (
        [head[column] for column in kept],
        [[row[column] for column in kept] for row in rows],
        "".join(align[column] for column in kept),
    )


def cut(lines: list[str], most: int) -> list[str]:
    """A table of which rows in the middle are left out, and counted, if it has more than so many.

    Args:
        lines: Its head and rows.
        most: Rows that are shown.
    """
    left_out = len(lines) - 1 - most
    if left_out <= 0:
        return lines
    first = 1 + most // 2
    return [*lines[:first], f"  ... and {left_out} more", *lines[first + left_out :]]


def tables(
    first: Sequence[str], columns: Sequence[Sequence[str]], last: Sequence[str] | None = None, *, width: int
) -> list[list[str]]:
    """A table given by columns, continued in further ones where it is too wide.

    Args:
        first: Title and cells of the first column, which every table has.
        columns: Those of the others, aligned right.
        last: Those of a last one, aligned left, of the first table only.
        width: Columns of text that a line may have.

    Returns:
        The lines of each table.
    """
    rest, found = list(columns), list[list[str]]()
    while rest or not found:
        ends = [last] if last is not None and not found else []
        for count in range(max(len(rest), 1), 0, -1):
            head, *rows = zip(first, *rest[:count], *ends, strict=True)
            lines = table(head, rows, "l" + "r" * len(rest[:count]) + "l" * len(ends))
            if max(map(len, lines)) <= width:
                break
        found.append(lines)
        rest = rest[count:]
    return found


def wrapped(text: str, width: int, first: str = "", following: str = "  ") -> list[str]:
    """Lines of a text, none of which ends between a share and its '%' or within a name.

    Args:
        text: What is wrapped.
        width: Columns of text that a line may have; 60 where it has fewer.
        first: What the first line begins with.
        following: What the others begin with.
    """
    lines = textwrap.wrap(
        re.sub(r"(?<=\d) (?=%)", _KEPT, text),
        max(width, 60),
        initial_indent=first,
        subsequent_indent=following,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return [line.replace(_KEPT, " ") for line in lines]


def pairs(title: str, rows: Sequence[tuple[str, str]], width: int = 24) -> list[str]:
    """A title and lines of name and text below it."""
    return [title, *(f"  {name:<{width}}{text}".rstrip() for name, text in rows)]


def _line(cells: Sequence[str], widths: Sequence[int], align: str) -> str:
    aligned = [
        cell.ljust(width) if side == "l" else cell.rjust(width)
        for cell, width, side in zip(cells, widths, align, strict=True)
    ]
    return "  ".join(aligned).rstrip()


def show(value: float | None, unit: str, digits: int) -> str:
    """A value with its unit, or a dash."""
    return ABSENT if value is None else format_quantity(value, unit, digits)


def signed(change: float, unit: str, digits: int) -> str:
    """A change with its unit and its sign, by the same minus as values beside it; none of none."""
    text = format_quantity(change, unit, digits)
    return f"+{text}" if change > 0.0 and text != format_quantity(0.0, unit, digits) else text
