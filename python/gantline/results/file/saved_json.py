"""What is read of a file of JSON: a value of the kind that belongs there, or an error that says it is not."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

__all__ = ["list_in", "number_in", "object_of", "text_in"]


def object_of(given: Any) -> Mapping[str, Any]:
    """An object.

    Raises:
        ValueError: If it is something else.
    """
    if not isinstance(given, dict):
        raise ValueError("an object was expected")
    return given


def list_in(given: Mapping[str, Any], name: str) -> list[Any]:
    """A list by its name in an object.

    Raises:
        ValueError: If there is none.
    """
    found = given.get(name)
    if not isinstance(found, list):
        raise ValueError(f"'{name}' is no list")
    return found


def text_in(given: Mapping[str, Any], name: str) -> str:
    """A text by its name in an object.

    Raises:
        ValueError: If there is none.
    """
    found = given.get(name)
    if not isinstance(found, str):
        raise ValueError(f"'{name}' is no text")
    return found


def number_in(given: Mapping[str, Any], name: str) -> float:
    """A number by its name in an object, neither infinite nor a truth value.

    Raises:
        ValueError: If there is none.
    """
    found = given.get(name)
    if isinstance(found, bool) or not isinstance(found, int | float) or not math.isfinite(found):
        raise ValueError(f"'{name}' is no number")
    return float(found)
