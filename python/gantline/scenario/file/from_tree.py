"""From the tree of a lift file to a checked scenario."""

from __future__ import annotations

from pydantic import ValidationError

from gantline.scenario.consistency.whole import check
from gantline.scenario.errors import ScenarioError
from gantline.scenario.file.alone import problems_of_types
from gantline.scenario.file.translate import translate
from gantline.scenario.file.tree import MapNode
from gantline.scenario.file.types import filled_in, misnamed, without
from gantline.scenario.model import Scenario

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
    problems, of_types = [*wrong.values()], problems_of_types(right)
    try:
        scenario = Scenario.model_validate(whole)
    except ValidationError as error:
        problems += translate(error.errors(include_url=False), whole)
    # What things have from a type is said of them, who may know more of it; of a type alone the rest.
    said = {(one.file, one.line, one.path) for one in problems}
    problems += [one for one in of_types if (one.file, one.line, one.path) not in said]
    if problems:
        raise ScenarioError(source, problems)
    scenario.read_from(source, text, whole, tree)
    check(scenario)
    return scenario
