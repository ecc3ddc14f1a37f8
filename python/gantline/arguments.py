"""Arguments of another kind than is asked for, which would end inside, in Python's own words."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from numbers import Real
from os import PathLike
from pathlib import Path
from typing import Any, TypeGuard, TypeVar

__all__ = ["direction", "is_number", "listed", "needed", "number", "path_of", "told"]

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


def listed(value: object, what: str, right: str) -> list[Any]:
    """Several things as a list.

    Args:
        value: What was handed in.
        what: What it has to be in words, such as "a list of tanks".
        right: What one is like, half a sentence.

    Raises:
        TypeError: If it is not several, or a text.
    """
    if not isinstance(value, Iterable) or isinstance(value, str):
        raise TypeError(f"{what} is needed, not {type(value).__name__}; {right}")
    return list(value)


def path_of(value: object, what: str) -> Path:
    """A path as one.

    Args:
        value: What was handed in.
        what: What it is of in words, such as "a file to write".

    Raises:
        TypeError: If it is none.
    """
    if not isinstance(value, str | PathLike):
        raise TypeError(f"{what} is needed, not {type(value).__name__}; a text such as 'lift', or a Path")
    return Path(value)


def is_number(value: object) -> TypeGuard[float]:
    """Whether it is a number, those of NumPy among them; truth values are none."""
    return isinstance(value, Real) and not isinstance(value, bool)


def number(value: object, name: str, unit: str) -> float:
    """A number as a float.

    Args:
        value: What was handed in, one of NumPy too.
        name: The argument.
        unit: What it is counted in, such as "radians".

    Raises:
        TypeError: If it is none, such as a text with a unit, or not finite.
    """
    if not (is_number(value) and math.isfinite(value)):
        raise TypeError(f"{name}: {value!r} is no number of {unit}")
    return float(value)


def direction(value: object, name: str) -> list[float]:
    """A direction of the world as its parts along x, y and z, of any length above zero.

    Args:
        value: What was handed in, an array too.
        name: The argument.

    Raises:
        ValueError: If it is none, such as one in the plane alone.
    """
    parts = list(value) if isinstance(value, Iterable) and not isinstance(value, str) else []
    if len(parts) != 3 or not all(is_number(one) and math.isfinite(one) for one in parts) or not any(parts):
        raise ValueError(f"{name}: {value!r} is no direction; x, y and z of the world, such as [1, 0, 0]")
    return [float(one) for one in parts]


def told(on_progress: _Told | None) -> _Told | None:
    """A function that is told how far something is, as it is, or None.

    Raises:
        TypeError: If it cannot be called.
    """
    if on_progress is not None and not callable(on_progress):
        right = "such as `on_progress=print`"
        raise TypeError(f"on_progress: a function is needed, not {type(on_progress).__name__}; {right}")
    return on_progress
