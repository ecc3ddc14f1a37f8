"""The reference of Python told of `Recording.is_equilibrium` "what counts is its last sample, and nothing is
dynamic." with the type "Whether it is of a lift at rest": Sphinx takes what stands before a colon in the
first line of a property's docstring for its type, and leaves it out of what the property is. So it did of
`Figure.moved` and of `Memory.residues`, which was "C exp(-at) (cos βt - (a/β) sin βt)".

Of `Verdict` and `Outcome`, which programs ask for by name, it named no value.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from importlib import import_module
from inspect import getmembers
from pathlib import Path

from gantline.checks import Outcome, Verdict

PAGE = Path(__file__).resolve().parents[2] / "docs" / "reference" / "python.md"


def classes_told_of() -> Iterator[type]:
    """Classes that the reference shows."""
    for name in re.findall(r"autoclass:: (\S+)", PAGE.read_text(encoding="utf-8")):
        module, _, owner = name.rpartition(".")
        yield getattr(import_module(module), owner)


def test_first_lines_of_properties_have_no_colon() -> None:
    told = {
        f"{owner.__name__}.{name}": (getattr(found, "__doc__", None) or "").splitlines()[:1]
        for owner in classes_told_of()
        for name, found in getmembers(owner, lambda one: isinstance(one, (property, cached_property)))
        if not name.startswith("_")
    }
    assert len(told) > 50
    assert {name: lines for name, lines in told.items() if lines and ": " in lines[0]} == {}


def test_outcomes_are_named_where_they_are_told_of() -> None:
    for kind in (Verdict, Outcome):
        assert [one.name for one in kind if f"`{one.name}`" not in (kind.__doc__ or "")] == []
