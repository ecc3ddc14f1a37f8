"""Types and libraries by themselves, without a lift that has them."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import TypeAdapter, ValidationError

from gantline.scenario.errors import Problem, ScenarioError
from gantline.scenario.file.library import is_library, refuse_other_keys
from gantline.scenario.file.translate import located, translate
from gantline.scenario.file.tree import MapNode, parse_text, read_text
from gantline.scenario.file.types import TYPED, misnamed
from gantline.scenario.model import Scenario

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

__all__ = ["check_library", "problems_of_types"]

#: Parts of the place of an error that says that a type is of no kind: section, name, the kind that was tried.
_OF_KIND = 3


def check_library(path: str | Path) -> dict[str, int] | None:
    """Look a library over, without what only lifts that name it know: what else there is by these names.

    Args:
        path: a file.

    Returns:
        How many things each of its sections has; None of what is no library.

    Raises:
        ScenarioError: with every problem that was found.
    """
    source = str(path)
    try:
        library = parse_text(read_text(Path(path), source), source)
    except ScenarioError:
        return None  # what reads lift files says it
    if not is_library(library):
        return None
    refuse_other_keys(library, source)
    problems = [*misnamed(library).values(), *problems_of_types(library)]
    typed = {of.types for of in TYPED}
    for section, given in library.items():
        if section not in typed and section != "format":
            problems += translate(_errors(section, section, given), library)
    if problems:
        raise ScenarioError(source, problems)
    return {section: len(given) for section, given in library.items() if section != "format"}


def problems_of_types(tree: MapNode) -> list[Problem]:
    """What is wrong in types by themselves, as that no thing names or that each says otherwise.

    What they leave out is said by what has them, and so are pairs of keys that go together or do not.
    """
    problems: list[Problem] = []
    for of in TYPED:
        types = tree.get(of.types)
        if isinstance(types, MapNode):
            given = MapNode({name: one for name, one in types.items() if isinstance(one, MapNode)})
            found = _errors(of.section, of.types, given)
            told = [one for one in found if one["type"] != "missing" and _is_of_value(one, tree)]
            problems += translate(told, tree)
    return problems


def _errors(section: str, place: str, given: MapNode) -> list[ErrorDetails]:
    """What is wrong in things that are read as those of a section, which stand at another place."""
    try:
        _reader(section).validate_python(given)
    except ValidationError as error:
        found = error.errors(include_url=False)
        for one in found:
            one["loc"] = (place, *one["loc"])
        return found
    return []


@cache
def _reader(section: str) -> TypeAdapter[Any]:
    """Reads things of a section; built where a lift file has types, or for a library."""
    things: Any = Scenario.model_fields[section].annotation
    return TypeAdapter(things)


def _is_of_value(error: ErrorDetails, tree: MapNode) -> bool:
    """Whether an error is that of a key or of a value by itself; so is that of a kind which there is not."""
    if error.get("ctx", {}).get("key") == "type" and len(error["loc"]) == _OF_KIND:
        return True
    return error["type"] == "extra_forbidden" or not isinstance(located(error["loc"], tree), MapNode)
