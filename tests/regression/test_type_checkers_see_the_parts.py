"""To a type checker every name of `gantline` that nothing imported was anything.

A module with `__getattr__` has, for a checker, every attribute there may be: `gantline.simulte(...)` passed
`mypy --strict`, and so did `gantline.export.write_csv(1)`, since `gantline.export` itself was anything. So
what is loaded on first use is imported for checkers, and `__getattr__` is hidden from them.
"""

from __future__ import annotations

import ast
import inspect
from collections.abc import Iterator

import gantline


def branches() -> Iterator[tuple[str, list[ast.stmt]]]:
    for node in ast.parse(inspect.getsource(gantline)).body:
        if isinstance(node, ast.If):
            yield ast.unparse(node.test), node.body


def test_what_is_loaded_on_first_use_is_imported_for_checkers() -> None:
    told = [body for test, body in branches() if test == "TYPE_CHECKING"]
    names = {
        alias.asname or alias.name
        for body in told
        for node in body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert names | {"__version__"} == set(dir(gantline))


def test_checkers_do_not_see_the_loading() -> None:
    hidden = [node for test, body in branches() if test == "not TYPE_CHECKING" for node in body]
    assert [node.name for node in hidden if isinstance(node, ast.FunctionDef)] == ["__getattr__"]
    seen = ast.parse(inspect.getsource(gantline)).body
    assert "__getattr__" not in [node.name for node in seen if isinstance(node, ast.FunctionDef)]
