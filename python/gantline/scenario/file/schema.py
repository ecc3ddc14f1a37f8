"""The JSON Schema of lift files, by which editors complete and check while typing."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from gantline.scenario.model import Scenario
from gantline.scenario.quantities import NAME_PATTERN, Quantity
from gantline.units import DIMENSIONS

__all__ = ["json_schema", "schema_text"]


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
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "$id": "lift.schema.json",
        **schema,
        "title": "gantline lift file",
        "description": "A lift of a crane in yard words; every quantity with its unit, such as '300 t'.",
    }


@cache
def schema_text() -> str:
    """The schema as the text of ``schema/lift.schema.json``."""
    return json.dumps(json_schema(), indent=2, ensure_ascii=False) + "\n"


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
