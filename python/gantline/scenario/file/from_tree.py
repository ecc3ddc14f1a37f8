"""From the tree of a lift file to a checked scenario."""

from __future__ import annotations

from pydantic import ValidationError

from gantline.scenario.consistency.whole import check
from gantline.scenario.errors import ScenarioError
from gantline.scenario.file.translate import translate
from gantline.scenario.file.tree import MapNode
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
    try:
        scenario = Scenario.model_validate(tree)
    except ValidationError as error:
        raise ScenarioError(source, translate(error.errors(include_url=False), tree)) from None
    scenario.read_from(source, text, tree)
    check(scenario)
    return scenario
