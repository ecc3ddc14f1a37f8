"""From the tree of a lift file to a checked scenario."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from pydantic import TypeAdapter, ValidationError

from gantline.scenario.consistency.whole import check
from gantline.scenario.errors import Problem, ScenarioError
from gantline.scenario.file.translate import located, translate
from gantline.scenario.file.tree import MapNode
from gantline.scenario.file.types import TYPED, filled_in, misnamed, without
from gantline.scenario.model import Scenario

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

__all__ = ["from_tree"]


def from_tree(tree: MapNode, source: str, text: str) -> Scenario:
    """The scenario that a tree describes, without its cases.

    Args:
        tree: as read, or changed.
        source: the file that messages name.
        text: the file's text.

    Raises:
        ScenarioError: with every problem that was found.
    """
    wrong = misnamed(tree)
    # What has no type has little else: what it lacks is no problem of its own.
    right = without(tree, wrong) if wrong else tree
    whole = filled_in(right)
    problems = [*wrong.values(), *_of_types(right)]
    try:
        scenario = Scenario.model_validate(whole)
    except ValidationError as error:
        problems += translate(error.errors(include_url=False), whole)
    if problems:
        raise ScenarioError(source, problems)
    scenario.read_from(source, text, whole, tree)
    check(scenario)
    return scenario


def _of_types(tree: MapNode) -> list[Problem]:
    """What is wrong in types by themselves, as that no thing names or that each says otherwise.

    What they leave out is said by what has them, and so are pairs of keys that go together or do not.
    """
    problems: list[Problem] = []
    for of in TYPED:
        types = tree.get(of.types)
        if not isinstance(types, MapNode):
            continue
        given = MapNode({name: one for name, one in types.items() if isinstance(one, MapNode)})
        try:
            _reader(of.section).validate_python(given)
        except ValidationError as error:
            inside = error.errors(include_url=False)
            for one in inside:
                one["loc"] = (of.types, *one["loc"])
            told = [one for one in inside if one["type"] != "missing" and _is_of_value(one, tree)]
            problems += translate(told, tree)
    return problems


@cache
def _reader(section: str) -> TypeAdapter[Any]:
    """Reads things of a section; built where a lift file has types."""
    things: Any = Scenario.model_fields[section].annotation
    return TypeAdapter(things)


def _is_of_value(error: ErrorDetails, tree: MapNode) -> bool:
    """Whether an error is that of a key or of a value by itself."""
    return error["type"] == "extra_forbidden" or not isinstance(located(error["loc"], tree), MapNode)
