"""The JSON Schema of lift files, by which editors complete and check while typing."""

from __future__ import annotations

import json
from functools import cache
from typing import Any, Final

from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from gantline.scenario.file.library import SECTIONS
from gantline.scenario.file.types import TYPED, Typed
from gantline.scenario.model import Scenario
from gantline.scenario.quantities import NAME_PATTERN, NameText, Quantity
from gantline.units import DIMENSIONS

__all__ = ["json_schema", "library_schema", "library_schema_text", "schema_text"]

_DEFINITIONS: Final = "#/$defs/"
#: How the name of a definition ends of which any part may be left out.
_PART: Final = ".part"


class _Generator(GenerateJsonSchema):
    """Shows what may be written in a file: no SI defaults, no nulls, no titles made of field names."""

    def default_schema(self, schema: core_schema.WithDefaultSchema) -> JsonSchemaValue:
        return self.generate_inner(schema["schema"])

    def nullable_schema(self, schema: core_schema.NullableSchema) -> JsonSchemaValue:
        return self.generate_inner(schema["schema"])

    def dict_schema(self, schema: core_schema.DictSchema) -> JsonSchemaValue:
        return {**super().dict_schema(schema), "propertyNames": {"pattern": f"^{NAME_PATTERN}$"}}

    def field_title_should_be_set(self, schema: Any) -> bool:
        return False


def json_schema() -> dict[str, Any]:
    """JSON Schema (draft 7, which the YAML servers of editors know) of a lift file."""
    schema = Scenario.model_json_schema(by_alias=True, schema_generator=_Generator)
    quantities = {dimension: Quantity(dimension).shown() for dimension in DIMENSIONS}
    schema = _share(schema, quantities)
    schema["$defs"].update(quantities)
    for of in TYPED:
        _let_have_types(schema, of)
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "$id": "lift.schema.json",
        **schema,
        "title": "gantline lift file",
        "description": "A lift of a crane in yard words; every quantity with its unit, such as '300 t'.",
    }


def library_schema() -> dict[str, Any]:
    """JSON Schema of a library, the file of types, ropes and shackles that lifts name."""
    whole = json_schema()
    return {
        **whole,
        "$id": "library.schema.json",
        "title": "gantline library",
        "description": "Types, ropes and shackles that lift files name in their 'library'.",
        "properties": {key: whole["properties"][key] for key in ("format", *SECTIONS)},
        "required": ["format"],
    }


@cache
def schema_text() -> str:
    """The schema as the text of ``schema/lift.schema.json``."""
    return _text(json_schema())


@cache
def library_schema_text() -> str:
    """The schema of libraries as a text."""
    return _text(library_schema())


def _text(schema: dict[str, Any]) -> str:
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"


def _share(schema: Any, quantities: dict[str, JsonSchemaValue]) -> Any:
    """The same schema, with references in place of written-out quantities."""
    if isinstance(schema, list):
        return [_share(item, quantities) for item in schema]
    if not isinstance(schema, dict):
        return schema
    for dimension, shown in quantities.items():
        if schema.get("anyOf") == shown["anyOf"]:
            rest = {key: value for key, value in schema.items() if key != "anyOf"}
            return {"$ref": f"#/$defs/{dimension}", **rest}
    return {key: _share(value, quantities) for key, value in schema.items()}


def _let_have_types(schema: dict[str, Any], of: Typed) -> None:
    """Show what types of a section may give, and that what names one needs to say the rest alone."""
    named = schema["properties"][of.section]["patternProperties"]
    (pattern, whole), *_ = named.items()
    parts = _parts_of(whole, schema["$defs"])
    kinds = parts.get("oneOf", [parts])
    given = [{**_own(one, schema["$defs"]), "required": ["type"]} if of.needs_kind else one for one in kinds]
    of_types = schema["properties"][of.types]["patternProperties"]
    # Beside a reference nothing counts in draft 7.
    shown = {"oneOf": given} if len(given) > 1 else {"allOf": given}
    untyped = {} if of.kinds else {"not": {"required": ["type"]}}
    of_types[pattern] = {"minProperties": 1, **shown, **untyped}
    named[pattern] = {"anyOf": [whole, _of_any_kind([_own(one, schema["$defs"]) for one in kinds], of)]}


def _of_any_kind(kinds: list[dict[str, Any]], of: Typed) -> dict[str, Any]:
    """What names a type may say: what anything does that is of one of the kinds."""
    ways: dict[str, list[Any]] = {}
    for kind in kinds:
        for key, shown in kind["properties"].items():
            ways.setdefault(key, [])
            if shown not in ways[key]:
                ways[key].append(shown)
    own = {key: shown[0] if len(shown) == 1 else {"anyOf": shown} for key, shown in ways.items()}
    name = {
        **NameText().shown(),
        "description": f"A name of '{of.types}' that gives what is not said here.",
        **({"not": {"enum": list(of.kinds)}} if of.kinds else {}),
    }
    return {
        "type": "object",
        "properties": {**own, "type": name},
        "required": ["type"],
        "additionalProperties": False,
    }


def _own(shown: dict[str, Any], definitions: dict[str, Any]) -> dict[str, Any]:
    """What a reference refers to."""
    found: dict[str, Any] = definitions[shown["$ref"].removeprefix(_DEFINITIONS)]
    return found


def _parts_of(shown: Any, definitions: dict[str, Any]) -> Any:
    """The same of which any part may be left out, with definitions of such parts beside the others."""
    if isinstance(shown, list):
        return [_parts_of(item, definitions) for item in shown]
    if not isinstance(shown, dict):
        return shown
    if "$ref" in shown:
        name = shown["$ref"].removeprefix(_DEFINITIONS)
        if definitions[name].get("type") != "object":
            return shown
        part = f"{name}{_PART}"
        if part not in definitions:
            definitions[part] = {}  # what refers to itself ends here
            left = {key: value for key, value in definitions[name].items() if key != "required"}
            definitions[part] = _parts_of(left, definitions)
        return {**shown, "$ref": f"{_DEFINITIONS}{part}"}
    return {key: _parts_of(value, definitions) for key, value in shown.items()}
