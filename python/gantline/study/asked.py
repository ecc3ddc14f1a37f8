"""What programs hand to studies, where a slip would be taken for something else or end inside."""

from __future__ import annotations

from collections.abc import Iterable

from gantline.arguments import listed

__all__ = ["count_of", "names_of"]


def names_of(what: str, given: Iterable[str]) -> list[str]:
    """Names in a list; a single text has letters, which are no names.

    Raises:
        TypeError: If it is a text, or nothing that has several.
    """
    if isinstance(given, str):
        raise TypeError(f"{what}: '{given}' is a text, and a list of names is needed, such as ['{given}']")
    return listed(given, f"{what}: a list of names", "a single one is a list too")


def count_of(what: str, given: object) -> int:
    """A whole number from 1 on.

    Raises:
        TypeError: If it is no whole number.
        ValueError: If there are to be none.
    """
    if isinstance(given, bool) or not hasattr(given, "__index__"):
        raise TypeError(f"{what}: {given!r} is no whole number from 1 on")
    number: int = given.__index__()
    if number < 1:
        raise ValueError(f"{what}: {number} are none; a whole number from 1 on is needed")
    return number
