"""Directives that show the evidence: what the tests compare, and what the scenarios give in this build.

`test-cases FOLDER`: the tests of a folder with their docstrings, which hold the equation of each.
`scenario-figures`: every scenario is simulated, and its metrics stand beside what `expect.yaml` expects.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from docutils import nodes
from ruamel.yaml import YAML
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

import gantline
from gantline.units import format_quantity

ROOT = Path(__file__).resolve().parents[2]


def sentence_case(name: str) -> str:
    """A test's name as a phrase."""
    return name.removeprefix("test_").replace("_", " ")


def cell(text: str) -> str:
    """Text that stays in one cell of a Markdown table; equations in plain text are kept as they are."""
    plain = " ".join(text.split())
    for sign in "\\|*_[]<>$":
        plain = plain.replace(sign, f"\\{sign}")
    return plain


def cases(module: Path) -> Iterator[str]:
    """Markdown of one test module."""
    tree = ast.parse(module.read_text(encoding="utf-8"))
    yield f"### {cell((ast.get_docstring(tree) or module.stem).partition('.')[0])}\n"
    yield f"`{module.relative_to(ROOT)}`\n"
    yield "| case | compared with |\n|---|---|"
    for node in tree.body:
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
            yield f"| {cell(sentence_case(node.name))} | {cell(ast.get_docstring(node) or '')} |"
    yield ""


def measured(value: float, like: str) -> str:
    """A value in the unit of a written quantity, with one more digit than it; bare SI where that is zero."""
    number, _, unit = like.strip().partition(" ")
    if float(number) == 0:
        return f"{value:.1e}"
    digits = len(number.partition(".")[2]) + 1
    return format_quantity(value, unit, digits)


def figures(folder: Path) -> Iterator[str]:
    """Markdown of one scenario: expected and measured."""
    expected = YAML(typ="safe").load((folder / "expect.yaml").read_text(encoding="utf-8"))
    recording = gantline.simulate(folder)
    metrics = recording.metrics()
    yield f"### `{folder.name}`\n"
    yield f"{recording.title}.\n"
    yield "| metric | expected | within | measured | source |\n|---|---|---|---|---|"
    for name, entry in expected.items():
        value = measured(metrics[name], str(entry["value"])) if name in metrics else "absent"
        yield f"| `{name}` | {entry['value']} | {entry['within']} | {value} | {cell(entry['source'])} |"
    yield ""


def section(folder: Path) -> str:
    """The same as one text, which a process can hand back."""
    return "\n".join(figures(folder))


class TestCases(SphinxDirective):
    """Puts the tables of a folder of tests where the directive stands."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The tables."""
        self.env.note_reread()
        modules = sorted((ROOT / self.arguments[0]).glob("test_*.py"))
        text = "\n".join(line for module in modules for line in cases(module))
        return self.parse_text_to_nodes(text, allow_section_headings=True)


class ScenarioFigures(SphinxDirective):
    """Puts the tables of all scenarios where the directive stands."""

    def run(self) -> list[nodes.Node]:
        """The tables."""
        self.env.note_reread()
        folders = sorted(path.parent for path in (ROOT / "scenarios").glob("*/expect.yaml"))
        # Side by side: of all pages this one is read last, and takes longest.
        with ProcessPoolExecutor() as pool:
            text = "\n".join(pool.map(section, folders))
        return self.parse_text_to_nodes(text, allow_section_headings=True)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("test-cases", TestCases)
    app.add_directive("scenario-figures", ScenarioFigures)
    return {"parallel_read_safe": True}
