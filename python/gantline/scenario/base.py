"""The base of all scenario models."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, ClassVar, TypeVar

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    ModelWrapValidatorHandler,
    model_validator,
)
from pydantic.json_schema import JsonSchemaValue

from gantline.scenario.errors import closest, is_or_are, shorten
from gantline.scenario.file.tree import MapNode
from gantline.scenario.quantities import Name, Reader, found, refuse

__all__ = ["Element", "Named", "Types", "with_a_type"]


class Element(BaseModel):
    """A mapping of a lift file: known keys only, nothing converted behind the user's back, never changed."""

    # The validator of a lift has those of its parts in it: none of these is built by itself.
    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, defer_build=True)

    #: How messages name this mapping, such as "a sling".
    what: ClassVar[str] = "this mapping"
    #: Keys to which a value that stands in its place belongs.
    lone: ClassVar[tuple[str, ...]] = ()

    @model_validator(mode="wrap")
    @classmethod
    def _from_mapping(cls, data: Any, handler: ModelWrapValidatorHandler[Any]) -> Any:
        if isinstance(data, MapNode):
            data.allowed = cls.keys()
            data.explained = cls.explained
            data.what = cls.what
            cls.refuse_early(data)
        elif not isinstance(data, (dict, cls)):
            # What it cannot be without comes first: the others may be left out.
            keys = sorted(cls.keys(), key=lambda key: key not in cls.needed_keys())
            of_it = f"{cls.what} {is_or_are(cls.what)} a mapping with keys such as {', '.join(keys[:6])}"
            key, _, value = str(data).strip().partition(" ")
            if value and key in keys:
                right = f"; write {{{key}: {shorten(value)}}}"
            elif isinstance(data, str) and cls.lone and data.lower() not in ("none", "null"):
                right = f"; write {{{', '.join(f'{key}: {shorten(data)}' for key in cls.lone)}}}"
            else:
                right = ""
            raise refuse(f"found {found(data)}; {of_it}{right}", of=cls.what, keys=tuple(keys))
        return handler(data)

    def __setattr__(self, name: str, value: Any) -> None:
        """Say how a lift with other values is made; what pydantic itself keeps here begins with `_`."""
        if name.startswith("_"):
            super().__setattr__(name, value)
            return
        sentence = f"'{name}' cannot be set: a scenario stays as it was read"
        right = "Scenario.changed({'load.weight.calculated': '320 t'}) gives another one with other values"
        raise AttributeError(f"{sentence}; {right}")

    @classmethod
    def keys(cls) -> tuple[str, ...]:
        """Keys that this mapping may have, as written in a file; its own before those that others share."""
        return _keys_of(cls)

    @classmethod
    def needed_keys(cls) -> set[str]:
        """Those of them that it cannot be without."""
        return {field.alias or name for name, field in cls.model_fields.items() if field.is_required()}

    @classmethod
    def explained(cls, key: str) -> str:
        """What a key says, in the first sentence of its description; empty if it has none."""
        fields = ((field.alias or name, field) for name, field in cls.model_fields.items())
        description = next((field.description for name, field in fields if name == key), None) or ""
        return description.partition(". ")[0].removesuffix(".")

    @classmethod
    def refuse_early(cls, data: MapNode) -> None:
        """Refuse, in one sentence, what would otherwise give many; overridden where that happens."""


@cache
def _keys_of(model: type[Element]) -> tuple[str, ...]:
    """Asked of every mapping of a lift, once or more for each of its cases."""
    models = [one for one in model.__mro__ if issubclass(one, BaseModel)]
    shared = {name: sum(name in one.model_fields for one in models) for name in model.model_fields}
    fields = sorted(model.model_fields.items(), key=lambda item: shared[item[0]])
    return tuple(field.alias or name for name, field in fields)


def with_a_type(*kinds: str) -> BeforeValidator:
    """Refuses a mapping that does not say which of these kinds it is, and names them."""

    def refused(data: Any) -> Any:
        if isinstance(data, MapNode) and "type" not in data:
            *first, last = (f"'{kind}'" for kind in kinds)
            likely = closest("type", data)
            hint = "" if likely is None else f" (is '{shorten(likely)}' meant for 'type'?)"
            sentence = "'type' is missing; it says what kind of thing this is"
            raise refuse(f"{sentence}, {', '.join(first)} or {last}{hint}")
        return data

    return BeforeValidator(refused)


T = TypeVar("T")

#: A mapping of names to things of one kind; at least one.
Named = Annotated[dict[Name, T], Field(min_length=1)]


@dataclass(frozen=True)
class _TypeReader(Reader):
    """Reads what a type gives; things that name it are read with that in them."""

    def read(self, value: object) -> dict[str, Any]:
        """What it gives, as written."""
        if not isinstance(value, MapNode) or not value:
            raise refuse(f"found {found(value)}; a mapping of what things of this type have is needed")
        return dict(value)

    def shown(self) -> JsonSchemaValue:
        """A mapping; what may stand in it is shown by the schema as a whole."""
        return {"type": "object", "minProperties": 1}


#: Types by name: what several things of one section have in common.
Types = Named[Annotated[dict[str, Any], _TypeReader()]]
