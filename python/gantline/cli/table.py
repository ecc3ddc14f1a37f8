"""Plain text tables with aligned columns."""

from __future__ import annotations

from collections.abc import Sequence

ABSENT = "-"


def table(head: Sequence[str], rows: Sequence[Sequence[str]], align: str) -> list[str]:
    """Lines of a table.

    Args:
        head: Titles of the columns.
        rows: Cells of each row.
        align: For each column `l` (left) or `r` (right).

    Returns:
        The head and one line for each row, indented below it, without trailing blanks.
    """
    indented = [[f"  {row[0]}", *row[1:]] for row in rows]
    widths = [max(len(row[column]) for row in [list(head), *indented]) for column in range(len(head))]
    return [_line(row, widths, align) for row in [list(head), *indented]]


def pairs(title: str, rows: Sequence[tuple[str, str]], width: int = 24) -> list[str]:
    """A title and lines of name and text below it."""
    return [title, *(f"  {name:<{width}}{text}".rstrip() for name, text in rows)]


def _line(cells: Sequence[str], widths: Sequence[int], align: str) -> str:
    aligned = [
        cell.ljust(width) if side == "l" else cell.rjust(width)
        for cell, width, side in zip(cells, widths, align, strict=True)
    ]
    return "  ".join(aligned).rstrip()
