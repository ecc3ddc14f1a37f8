"""Directives that take text from where it is kept, in every build anew, so it cannot go stale.

`lift-keys`: all keys of a lift file as tables, made of the JSON Schema.
`rope-classes`: the rope classes with their factors, as a table.
`module-text`: a module's docstring as Markdown.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from functools import cached_property
from importlib import import_module
from itertools import filterfalse
from operator import attrgetter
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from gantline.rope_data import rope_classes
from gantline.scenario import json_schema

Schema = dict[str, Any]

#: Most words of a choice that a table writes out.
MOST_WORDS = 8

#: How values are written whose type says all.
BY_TYPE = {"object": "a mapping", "integer": "a number", "number": "a number", "boolean": "`true` or `false`"}

#: Most places of a list that a table writes out.
MOST_PLACES = 3


def written_out(schema: Any, shared: Schema) -> Any:
    """The same schema with shared kinds of value, which are no mappings, in place of references to them."""
    if isinstance(schema, list):
        return [written_out(item, shared) for item in schema]
    if not isinstance(schema, dict):
        return schema
    name = schema.get("$ref", "").rsplit("/", 1)[-1]
    if name in shared:
        return {**shared[name], **{key: value for key, value in schema.items() if key != "$ref"}}
    return {key: written_out(value, shared) for key, value in schema.items()}


def whole_schema() -> Schema:
    """The schema of a lift file with references to mappings only."""
    root = json_schema()
    shared = {name: kind for name, kind in root["$defs"].items() if "properties" not in kind}
    whole: Schema = written_out(root, shared)
    return whole


def targets(schema: Schema, path: str) -> Iterator[tuple[str, str]]:
    """Definitions that a value may be, each with the path at which it then stands in a file.

    What types may give is the same with any part of it left out.
    """
    if "$ref" in schema and not schema["$ref"].endswith(".part"):
        yield schema["$ref"].rsplit("/", 1)[1], path
    for named in schema.get("patternProperties", {}).values():
        yield from targets(named, f"{path}.<name>")
    if isinstance(schema.get("items"), dict):
        yield from targets(schema["items"], f"{path}[]")
    for kind in ("oneOf", "anyOf", "allOf"):
        for option in schema.get(kind, []):
            yield from targets(option, path)


def kind_of(definition: Schema) -> str:
    """What tells this definition from its alternatives: `type: hinge`, or its first required key."""
    constant = definition["properties"].get("type", {}).get("const")
    return f"type: {constant}" if constant else definition["required"][-1]


def goes_without_saying(schema: Schema) -> bool:
    """Whether this is the zero that may stand in place of any quantity, or a number as a text."""
    pattern = schema.get("pattern", "") if "examples" not in schema else ""
    is_number = re.match(pattern, "0") or re.match(pattern, "1")
    return schema.get("const") == 0 or bool(pattern and is_number and not re.match(pattern, "a"))


def written(schema: Schema) -> str:
    """How a value is written."""
    if "const" in schema:
        return f"`{schema['const']}`"
    if "enum" in schema:
        words = dict.fromkeys(str(v).lower() if isinstance(v, bool) else str(v) for v in schema["enum"])
        if len(words) > MOST_WORDS:
            return f"`{next(iter(words))}`, …"
        return " or ".join(f"`{word}`" for word in words)
    if schema.get("examples"):
        return f"`{schema['examples'][0]}`"
    if isinstance(schema.get("items"), dict):
        inside = written(schema["items"]).strip("`")
        if inside in ("", "a text or name"):
            return "a list"
        number = schema.get("minItems", 1)
        if number > MOST_PLACES:
            return f"a list of {number}, each {written(schema['items'])}"
        return f"`[{', '.join([inside] * number)}]`"
    if (kind := str(schema.get("type"))) in BY_TYPE:
        return BY_TYPE[kind]
    given = [option for kind in ("anyOf", "oneOf") for option in schema.get(kind, [])]
    options = [option for option in map(written, filterfalse(goes_without_saying, given)) if option]
    if not options and "string" in schema.get("type", ""):
        return "a text or name"
    return " or ".join(dict.fromkeys(options))


def sections(root: Schema) -> Iterator[str]:
    """Markdown of every mapping that a lift file may hold, each once, in the order of a file."""
    waiting: list[tuple[str, str, Schema]] = [("", "", root)]
    seen: dict[str, str] = {}
    while waiting:
        name, path, definition = waiting.pop(0)
        rows = []
        found: list[tuple[str, str, Schema]] = []
        for key, value in definition["properties"].items():
            inside = list(targets(value, f"{path}.{key}" if path else key))
            for target, place in inside:
                if target not in seen:
                    mapping = root["$defs"][target]
                    seen[target] = f"{place} ({kind_of(mapping)})" if len(inside) > 1 else place
                    found.append((target, seen[target], mapping))
            see = ", ".join(f"`{seen[target]}`" for target, _ in inside)
            how = f"see {see}" if see else written(value) or "a text or name"
            meaning = value.get("description") or " ".join(root["$defs"][t]["description"] for t, _ in inside)
            needed = "yes" if key in definition.get("required", []) else ""
            rows.append(f"| `{key}` | {needed} | {how} | {meaning} |")
        waiting = found + waiting
        title = f"`{path}`" if name else "The file"
        head = "| key | needed | written | meaning |\n|---|---|---|---|\n"
        yield f"## {title}\n\n{definition.get('description', '')}\n\n{head}" + "\n".join(rows) + "\n"


class LiftKeys(SphinxDirective):
    """Puts the tables where the directive stands."""

    def run(self) -> list[nodes.Node]:
        """The tables."""
        self.env.note_reread()
        text = "\n".join(sections(whole_schema()))
        return self.parse_text_to_nodes(text, allow_section_headings=True)


class RopeClasses(SphinxDirective):
    """Puts the table of rope classes where the directive stands."""

    def run(self) -> list[nodes.Node]:
        """The table."""
        self.env.note_reread()
        titles = ("construction", "or a designation", "W", "C", "K", "E [kN/mm²]", "factors from")
        head = f"| {' | '.join(titles)} |\n{'|---' * len(titles)}|\n"
        rows = [
            f"| `{one.name}` | {', '.join(f'`{word}`' for word in one.designations)} | {one.mass_factor:.3f} "
            f"| {one.area_factor:.3f} | {one.breaking_force_factor:.3f} | {one.modulus / 1e9:.0f} "
            f"| {one.factors_from} |"
            for one in rope_classes().values()
        ]
        return self.parse_text_to_nodes(head + "\n".join(rows))


class ModuleText(SphinxDirective):
    """Puts the docstring of a module, which is Markdown, where the directive stands."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The docstring without its first sentence."""
        self.env.note_reread()
        text = inspect.getdoc(import_module(self.arguments[0])) or ""
        return self.parse_text_to_nodes(text.partition("\n\n")[2])


def keep_formulas_whole(_app: Sphinx, doctree: nodes.document, _page: str) -> None:
    """Hand displayed formulas on as they stand: Sphinx puts rows into `split`, which takes no number."""
    for formula in doctree.findall(nodes.math_block):
        formula["no-wrap"] = True
        formula.children = [nodes.Text(f"\\[{formula.astext()}\\]")]


def where_written(_app: Sphinx, module: str, name: str) -> str | None:
    """The module with the source of a cached property, which itself says `functools`; None of all else."""
    try:
        value = attrgetter(name)(import_module(module))
    except AttributeError:  # of a field without a default
        return None
    return value.func.__module__ if isinstance(value, cached_property) else None


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives, and what changes formulas and links to the source."""
    app.connect("doctree-resolved", keep_formulas_whole)
    app.setup_extension("sphinx.ext.viewcode")  # has the event
    app.connect("viewcode-follow-imported", where_written)
    app.add_directive("lift-keys", LiftKeys)
    app.add_directive("rope-classes", RopeClasses)
    app.add_directive("module-text", ModuleText)
    return {"parallel_read_safe": True}
