"""JSON held against the form that dataclasses describe: the first difference, in one phrase.

What a recording says of its lift comes back from a file that other programs may have changed. Types of the
fields are the form, so that nothing has to be said twice.
"""

from __future__ import annotations

import math
import types
from collections.abc import Mapping, Sequence
from dataclasses import MISSING, dataclass, fields, is_dataclass
from functools import cache
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

__all__ = ["FormError", "Length", "Quaternion", "Range", "Vector", "hold_form"]


@dataclass(frozen=True)
class Length:
    """How many entries a list has, where that is fixed."""

    count: int


Vector = Annotated[Sequence[float], Length(3)]
Range = Annotated[Sequence[float], Length(2)]
Quaternion = Annotated[Sequence[float], Length(4)]

_WORDS = {str: "text", bool: "true or false", int: "a whole number", float: "a number"}
_LONGEST = 40  # characters of what was found


class FormError(ValueError):
    """JSON that has another form; the message is a phrase that names the place."""


def hold_form(value: Any, form: Any, place: str) -> None:
    """Hold JSON against a form.

    Args:
        value: What `json.loads` gave.
        form: A type: `str`, `bool`, `int`, `float`, `None`, `Any`, unions, sequences and mappings of them,
            dataclasses. Keys that these do not know are passed over; one without a default has to be there.
        place: Where it stands, such as `rig.slings[2]`.

    Raises:
        FormError: At the first difference.
    """
    origin, inner = get_origin(form), get_args(form)
    if form is Any:
        return
    if origin is Annotated:
        hold_form(value, inner[0], place)
        if len(value) != inner[1].count:
            raise FormError(f"{place} has {len(value)} entries; expected {inner[1].count}")
    elif origin in (Union, types.UnionType):
        # The only unions are those with None.
        if value is not None:
            hold_form(value, next(one for one in inner if one is not types.NoneType), place)
    elif origin is not None and issubclass(origin, Mapping):
        _expect(value, dict, "an object", place)
        for key, one in value.items():
            hold_form(one, inner[1], f"{place}.{key}")
    elif origin is not None and issubclass(origin, Sequence):
        _expect(value, list | tuple, "a list", place)
        if inner[0] is float and all(type(one) is float and math.isfinite(one) for one in value):
            return
        for at, one in enumerate(value):
            hold_form(one, inner[0], f"{place}[{at}]")
    elif isinstance(form, type) and is_dataclass(form):
        _expect(value, dict, "an object", place)
        for key, hint, is_needed in _keys(form):
            if key in value:
                hold_form(value[key], hint, f"{place}.{key}")
            elif is_needed:
                raise FormError(f"{place} has no '{key}'")
    else:
        _hold_plain(value, form, place)


def _hold_plain(value: Any, form: Any, place: str) -> None:
    is_right = isinstance(value, int | float if form is float else form)
    if form is not bool and isinstance(value, bool):
        is_right = False
    if not is_right or (form is float and not math.isfinite(value)):
        raise FormError(f"{place} is {_shown(value)}; expected {_WORDS[form]}")


def _expect(value: Any, kind: Any, words: str, place: str) -> None:
    if not isinstance(value, kind):
        raise FormError(f"{place} is {_shown(value)}; expected {words}")


def _shown(value: Any) -> str:
    """What was found, in a few words."""
    if isinstance(value, dict):
        return "an object"
    if isinstance(value, list | tuple):
        return "a list"
    if value is None:
        return "null"
    text = repr(value) if not isinstance(value, bool) else str(value).lower()
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}..."


@cache
def _keys(form: type[Any]) -> tuple[tuple[str, Any, bool], ...]:
    """Key, type and whether it has to be there, of each entry of an object."""
    hints = get_type_hints(form, include_extras=True)
    renamed: Mapping[str, str] = getattr(form, "json_names", {})
    return tuple(
        (
            renamed.get(one.name, one.name),
            hints[one.name],
            one.default is MISSING and one.default_factory is MISSING,
        )
        for one in fields(form)
    )
