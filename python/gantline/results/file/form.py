"""JSON held against the form that dataclasses describe: the first difference, in one phrase.

What a recording says of its lift comes back from a file that other programs may have changed. Types of the
fields are the form, so that nothing has to be said twice. Phrases are others than those on lift files, see
`gantline.scenario.file.translate`: nobody writes a recording by hand, so there is no line to point to and
no misspelt key to guess, and entries of lists count from 0 as in JSON.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Annotated, Any

from pydantic import ConfigDict, Field, TypeAdapter, ValidationError
from pydantic_core import ErrorDetails, PydanticSerializationError, to_json

__all__ = ["FormError", "Quaternion", "Range", "Vector", "hold_form"]

Vector = Annotated[Sequence[float], Field(min_length=3, max_length=3)]
Range = Annotated[Sequence[float], Field(min_length=2, max_length=2)]
Quaternion = Annotated[Sequence[float], Field(min_length=4, max_length=4)]

#: What was expected, by type of the validator's error.
_WORDS = {
    "string_type": "text",
    "bool_type": "true or false",
    "int_type": "a whole number",
    "int_from_float": "a whole number",
    "float_type": "a number",
    "finite_number": "a number",
    "list_type": "a list",
    "dict_type": "an object",
    "mapping_type": "an object",
    "dataclass_type": "an object",
}
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
    try:
        # From Python a strict validator takes instances of dataclasses alone, from JSON it takes objects.
        _validator(form).validate_json(to_json({place: value}, inf_nan_mode="constants"))
    except (PydanticSerializationError, ValidationError) as problem:
        first = problem.errors(include_url=False)[0] if isinstance(problem, ValidationError) else None
        if first is None or first["type"] == "json_invalid":
            # Writing gives up at some depth and at half a surrogate pair, reading at a lesser depth.
            words = f"{place} is nested too deeply, or has text that is no Unicode"
        else:
            words = _phrase(first)
        raise FormError(words) from None


@cache
def _validator(form: Any) -> TypeAdapter[Any]:
    """Of an object with one entry of a form; its key is where error messages begin."""
    # A dataclass takes its settings from what is around it.
    settings = ConfigDict(strict=True, allow_inf_nan=False)
    return TypeAdapter(dict[str, form], config=settings)


def _phrase(problem: ErrorDetails) -> str:
    kind, context = problem["type"], problem.get("ctx", {})
    if kind == "missing":
        return f"{_place(problem['loc'][:-1])} has no '{problem['loc'][-1]}'"
    place = _place(problem["loc"])
    if kind in ("too_short", "too_long"):
        expected = context["min_length" if kind == "too_short" else "max_length"]
        return f"{place} has {context['actual_length']} entries; expected {expected}"
    return f"{place} is {_shown(problem['input'])}; expected {_WORDS.get(kind, 'something else')}"


def _place(path: Sequence[str | int]) -> str:
    inner = (f"[{part}]" if isinstance(part, int) else f".{part}" for part in path[1:])
    return f"{path[0]}{''.join(inner)}"


def _shown(value: Any) -> str:
    """What was found, in a few words."""
    if isinstance(value, dict):
        return "an object"
    if isinstance(value, list):
        return "a list"
    if value is None:
        return "null"
    text = repr(value) if not isinstance(value, bool) else str(value).lower()
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}..."
