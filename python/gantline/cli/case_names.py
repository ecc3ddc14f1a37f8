"""How cases and their variants are called in tables, where names may be longer than there is room."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Sequence

__all__ = [
    "AS_GIVEN",
    "SHORTEST_LABEL",
    "case_name",
    "is_numbered",
    "listed_names",
    "numbered_in",
    "told_apart",
]

#: How the lift without any change is called.
AS_GIVEN = "as given"
#: Least room for a name.
SHORTEST_LABEL = 16


def case_name(case: str, more: str) -> str:
    """A case with what more there is to know of it, such as how many variants."""
    return f"{case or AS_GIVEN}{f' ({more})' if more else ''}"


def told_apart(names: Sequence[str], room: int, first: int = 0) -> list[str]:
    """Names no longer than `room`, with a number each where what is cut off is all that two differ by.

    Numbers begin behind the `first` ones.
    """
    cut = [_shortened(name, room) for name in names]
    if len(set(cut)) == len(set(names)):
        return cut
    return [_shortened(f"{_number(first + place)} {name}", room) for place, name in enumerate(names)]


def numbered_in(names: Sequence[str], lines: Sequence[str], width: int) -> list[str]:
    """What numbers stand for, where names have them in these lines."""
    return listed_names(names, width) if is_numbered((line.strip() for line in lines), 0) else []


def is_numbered(lines: Iterable[str], first: int) -> bool:
    """Whether names have numbers in these lines, behind the `first` ones."""
    return any(line.startswith(f"{_number(first)} ") for line in lines)


def listed_names(names: Sequence[str], width: int, first: int = 0) -> list[str]:
    """Each number with the whole name that it stands for."""
    return [
        line
        for place, name in enumerate(names, first)
        for line in textwrap.wrap(
            f"{_number(place)} {name}", max(width, 60), initial_indent="  ", subsequent_indent="     "
        )
    ]


def _number(place: int) -> str:
    return f"#{place + 1}"


def _shortened(text: str, room: int) -> str:
    return text if len(text) <= room else f"{text[: room - 1]}…"
