"""The JSON Schema by which editors check lift files."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from ruamel.yaml import YAML

from gantline.scenario import json_schema, schema_text, template
from gantline.scenario.file.tree import parse_text
from lift_text import BASE, MECHANICS, spoiled

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = ROOT / "schema" / "lift.schema.json"
TEXTS = {
    path.parent.name: path.read_text(encoding="utf-8")
    for path in (ROOT / "scenarios").glob("*/scenario.yaml")
}
TEXTS |= {"template": template(), "base": BASE, "mechanics": MECHANICS}


@cache
def validator() -> jsonschema.Draft7Validator:
    return jsonschema.Draft7Validator(json_schema())


def as_editors_read(text: str) -> Any:
    """The file as YAML readers of editors see it: numbers and truth values are no texts."""
    return json.loads(json.dumps(YAML(typ="safe", pure=True).load(text)))


def test_the_shipped_schema_is_the_one_of_the_models() -> None:
    assert SHIPPED.read_text(encoding="utf-8") == schema_text(), (
        "run: gantline schema -o schema/lift.schema.json"
    )


def test_the_schema_is_one() -> None:
    jsonschema.Draft7Validator.check_schema(json_schema())


@pytest.mark.parametrize("name", sorted(TEXTS))
def test_right_lifts_fit_the_schema(name: str) -> None:
    assert [error.message for error in validator().iter_errors(parse_text(TEXTS[name], name))] == []
    assert [error.message for error in validator().iter_errors(as_editors_read(TEXTS[name]))] == []


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("calculated: 60 t", "calculated: 60"),
        ("calculated: 60 t", "calculated: 60 kN"),
        ("duration: 20 s", "duratoin: 20 s"),
        ("rated_capacity: 100 t", "rated_capacty: 100 t"),
        ("type: fixed_hook", "type: goliath"),
        ("box: [8 m, 6 m, 3 m]", "box: [8 m, 6 m]"),
        ("hold: until_end}", "hold: until_end, require: {load_tilt: 1 deg}}"),
        ("format: 1", "format: 2"),
        ("mass: none}", "mass: nothing}"),
        ("  S2: {from: e1.2", "  S 2: {from: e1.2"),
    ],
)
def test_wrong_lifts_do_not_fit_the_schema(old: str, new: str) -> None:
    assert not validator().is_valid(as_editors_read(spoiled(old, new)))


def test_the_schema_speaks_of_what_people_write() -> None:
    schema = json_schema()
    mass = schema["$defs"]["mass"]["anyOf"][0]
    assert mass["type"] == "string" and "300 t" in mass["examples"]
    text = schema_text()
    assert '"default"' not in text and '"null"' not in text

    def described(name: str) -> bool:
        return all("description" in field for field in schema["$defs"][name]["properties"].values())

    assert all(described(name) for name in schema["$defs"] if "properties" in schema["$defs"][name])
