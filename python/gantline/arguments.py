"""Arguments of another kind than is asked for, which would end inside, in Python's own words."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

__all__ = ["needed", "told"]

T = TypeVar("T")
_Told = TypeVar("_Told", bound=Callable[..., Any])


def needed(value: object, kind: type[T], what: str, right: str) -> T:
    """An argument as it is.

    Args:
        value: What was handed in.
        kind: What it has to be.
        what: The same in words, such as "a state".
        right: Where one comes from, half a sentence.

    Raises:
        TypeError: If it is something else.
    """
    if not isinstance(value, kind):
        raise TypeError(f"{what} is needed, not {type(value).__name__}; {right}")
    return value


def told(on_progress: _Told | None) -> _Told | None:
    """A function that is told how far something is, as it is, or None.

    Raises:
        TypeError: If it cannot be called.
    """
    if on_progress is not None and not callable(on_progress):
        right = "such as `on_progress=print`"
        raise TypeError(f"on_progress: a function is needed, not {type(on_progress).__name__}; {right}")
    return on_progress
