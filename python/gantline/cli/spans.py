"""Several values of one quantity behind an option: a list, or a span with a number of values."""

from __future__ import annotations

from gantline.cli.lift import quantity_of
from gantline.cli.messages import stop

__all__ = ["count_of", "values_of_option"]

#: Of one span.
_MOST = 1000


def values_of_option(option: str, text: str | None, dimension: str) -> list[float] | None:
    """SI values of `'4 m, 4.5 m'` or `'2 m..6 m/9'`; None where the option was not given."""
    if text is None:
        return None
    span, slash, number = (word.strip() for word in text.rpartition("/"))
    first, dots, last = (word.strip() for word in span.partition(".."))
    if not (slash and dots):
        return [quantity_of(option, part.strip(), dimension) for part in text.split(",")]
    count = count_of(option, number)
    begin, end = quantity_of(option, first, dimension), quantity_of(option, last, dimension)
    return [begin + (end - begin) * k / (count - 1) for k in range(count)]


def count_of(option: str, text: str) -> int:
    """How many values a span has, of its text behind the `/`."""
    if not (text.isascii() and text.isdecimal() and 2 <= int(text[:9]) <= _MOST):
        stop(f"{option}: '{text}' is no number of values; a whole number from 2 to {_MOST} is right")
    return int(text)
