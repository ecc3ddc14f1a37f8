"""From a lift file to a scenario."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from os import PathLike
from pathlib import Path
from typing import Any

from gantline.scenario.errors import Problem, ScenarioError, closest
from gantline.scenario.file import odd_characters
from gantline.scenario.file.from_tree import from_tree
from gantline.scenario.file.library import is_library, with_libraries
from gantline.scenario.file.shipped import shipped
from gantline.scenario.file.tree import parse_text, read_text
from gantline.scenario.file.tree_path import PathError, node_of
from gantline.scenario.file.variants import check_cases
from gantline.scenario.gear import SlingDefaults
from gantline.scenario.mechanics import Mechanics
from gantline.scenario.model import Scenario

__all__ = ["FILE_NAME", "lift_file", "load_scenario", "parse_scenario"]

#: Name of the lift file in a folder that stands for a lift.
FILE_NAME = "scenario.yaml"
#: What messages call a lift that Python has built.
_MAPPING = "mapping"


def load_scenario(path: str | Path) -> Scenario:
    """Read a lift file, the ``scenario.yaml`` of a folder, or a lift that comes with gantline.

    Args:
        path: the file or its folder; where there is neither, the name of a lift of `shipped`.

    Returns:
        The scenario, checked as far as it can be without building the system.

    Raises:
        ScenarioError: with every problem that was found, each with line, path and what would be right.
        TypeError: if it is no path.
    """
    file = lift_file(path)
    source = str(file)
    return parse_scenario(read_text(file, source), source)


def lift_file(path: str | Path) -> Path:
    """The file that a lift is read from: itself, the ``scenario.yaml`` of a folder, or of one of `shipped`.

    Raises:
        ScenarioError: if it cannot be one; whether it can be read is not looked at.
        TypeError: if it is no path.
    """
    if not isinstance(path, (str, PathLike)):
        right = "gantline.parse_scenario takes the text of a lift file, or a mapping"
        raise TypeError(f"a lift file or its folder is needed, not {type(path).__name__}; {right}")
    if isinstance(path, str) and "\n" in path:
        sentence = "this is the text of a lift file and not its name; gantline.parse_scenario(text) reads it"
        raise ScenarioError("load_scenario", [Problem(None, "", sentence)])
    file = Path(path)
    if str(path) in shipped() and not file.exists():
        file = shipped()[str(path)]
    likely = _likely_lift(file)
    if likely is not None:
        sentence = f"is no file or folder; did you mean '{likely}', a lift that comes with gantline?"
        raise ScenarioError(str(file), [Problem(None, "", sentence)])
    if _is_folder(file):
        if not (file / FILE_NAME).is_file():
            holds = "with a recording" if any(file.glob("*.nc")) else f"without {FILE_NAME}"
            others = [one for one in file.glob("*.y*ml") if one.is_file()]
            right = (
                f"did you mean {others[0]}?" if len(others) == 1 else "a lift file or its folder is needed"
            )
            sentence = f"is a folder {holds}; {right}"
            raise ScenarioError(str(file), [Problem(None, "", sentence)])
        return file / FILE_NAME
    return file


def parse_scenario(text: str | Mapping[str, Any], source: str | None = None) -> Scenario:
    """Scenario of a lift file's text, or of the same as dictionaries and lists, as Python builds it.

    Args:
        text: the text; or a mapping whose values are written as in a lift file: `{"mass": "300 t"}`. A number
            stands where a lift file has one without a unit.
        source: the file that messages name, `scenario.yaml` of a text and `mapping` of a mapping if not
            given. Paths of files in the lift begin in its folder.

    Raises:
        ScenarioError: as `load_scenario`; lines are those of the text, which `Scenario.text` has; of a
            mapping without a `source` there are none.
        TypeError: if it is neither.
    """
    if isinstance(text, Mapping) and source is None:
        try:
            return _parsed(_written(text, _MAPPING), _MAPPING)
        except ScenarioError as error:
            # There is no file whose lines these would be.
            unplaced = [replace(problem, line=None) for problem in error.problems]
            raise type(error)(error.source, unplaced) from None
    if isinstance(text, Mapping) and source is not None:
        text = _written(text, source)
    if not isinstance(text, str):
        raise TypeError(f"a lift file's text or a mapping is needed, not {type(text).__name__}")
    return _parsed(text, FILE_NAME if source is None else source)


def _parsed(text: str, source: str) -> Scenario:
    return odd_characters.read(text, source, _checked)


def _checked(text: str, source: str) -> Scenario:
    # Those that no mapping directly below one has, too.
    sections = {*Scenario.keys()}.difference(Mechanics.keys(), SlingDefaults.keys())
    tree = parse_text(text, source, sections)
    if is_library(tree):
        sentence = "is a library and has no lift in it; a lift file names it in its 'library'"
        raise ScenarioError(source, [Problem(None, "", sentence)])
    scenario = from_tree(with_libraries(tree, source), source, text)
    check_cases(scenario)
    return scenario


def _written(values: Mapping[str, Any], source: str) -> str:
    """A mapping as the text of a lift file: JSON, which is YAML, a line for each value."""
    try:
        return f"{json.dumps(node_of(values, 1), ensure_ascii=False, indent=1)}\n"
    except PathError as error:
        raise ScenarioError(source, [Problem(None, "", str(error))]) from None


def _likely_lift(path: Path) -> str | None:
    """The lift that comes with gantline and may be meant by a path where nothing is; None for none.

    What has no folder and no ending looks like a name; in the sources of gantline each has its own folder.
    """
    try:
        if path.exists():
            return None
    except (OSError, ValueError):
        return None
    if len(path.parts) == 1 and not path.suffix:
        return closest(path.name, shipped())
    folder = path.parent if path.name == FILE_NAME else path
    return folder.name if folder.name in shipped() else None


def _is_folder(path: Path) -> bool:
    try:
        return path.is_dir()
    except (OSError, ValueError):  # a name that no file can have; reading it says so
        return False
