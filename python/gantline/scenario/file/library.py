"""Libraries: files of types, ropes and shackles that the lifts of a yard have in common.

A lift file that names some has what they give as if it stood in its own sections, and messages name the file
in which what is wrong stands.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Final

from gantline.scenario.errors import Problem, ScenarioError, nearest, shorten
from gantline.scenario.file import odd_characters
from gantline.scenario.file.tree import (
    ListNode,
    MapNode,
    Node,
    TextNode,
    like,
    parse_text,
    problem_at,
    read_text,
)
from gantline.scenario.file.types import TYPED

__all__ = ["LIBRARY", "SECTIONS", "is_library", "refuse_other_keys", "with_libraries"]

#: The key of a lift file that names them.
LIBRARY: Final = "library"
#: What a library may give.
SECTIONS: Final = (
    *("ropes", "shackles", "hook_types", "equalizer_types", "lug_types"),
    *(of.types for of in TYPED),
)
#: Keys that a lift file has, and no library.
_OF_LIFTS: Final = frozenset(("lift", "duration", "plan", "slings", LIBRARY))
#: How what is wrong with a file ends that is none.
_NEEDED: Final = "; a lift file or its folder is needed"
#: Most libraries of one lift file.
_MOST: Final = 20


def is_library(tree: MapNode) -> bool:
    """Whether a file has sections of a library, and nothing else."""
    return any(key in SECTIONS for key in tree) and all(key in (*SECTIONS, "format") for key in tree)


def with_libraries(tree: MapNode, source: str) -> MapNode:
    """The tree of a lift file with what its libraries give in it; itself where it names none.

    Args:
        tree: of the lift file.
        source: the lift file as messages name it; names of libraries begin in its folder.

    Raises:
        ScenarioError: if one cannot be read, gives what no library does, or what the lift file gives, too.
    """
    sections: dict[str, MapNode] = {}
    problems: list[Problem] = []
    beside = ""
    for name in _named(tree):
        path = Path(source).parent / name
        try:
            text = read_text(path, str(path))
        except ScenarioError as error:
            why = error.problems[0].sentence
            if why.endswith(_NEEDED):
                why = f"{why.removesuffix(_NEEDED)}; a library beside the lift file is needed"
            sentence = f"'{shorten(name)}' {why.replace('a lift file', 'a library')}"
            raise ScenarioError(source, [problem_at(tree, (LIBRARY,), sentence)]) from None
        library = odd_characters.read(text, str(path), _checked)
        beside += f"# library: {name}\n" + "".join(f"# {line}".rstrip() + "\n" for line in text.splitlines())
        for section, given in library.items():
            if section not in SECTIONS:
                continue
            before = sections.get(section, tree.get(section, _empty(given)))
            if not isinstance(before, MapNode):
                continue  # what reads the lift file says so
            own = {key: _of_file(node, str(path), given.key_lines[key]) for key, node in given.items()}
            for key in own:
                if key in before:
                    sentence = f"'{shorten(key)}' is given in {path}, too; each name stands once"
                    problems.append(problem_at(like(tree, {**tree, **sections}), (section, key), sentence))
            merged = like(before, {**own, **before})
            merged.key_lines = {**given.key_lines, **before.key_lines}
            sections[section] = merged
    if problems:
        raise ScenarioError(source, problems)
    whole = like(tree, {**tree, **sections})
    whole.beside = beside
    return whole if beside else tree


def _checked(text: str, source: str) -> MapNode:
    library = parse_text(text, source)
    refuse_other_keys(library, source)
    return library


def _named(tree: MapNode) -> list[str]:
    """Libraries that a lift file names; none where it names them wrongly, which what reads it says."""
    given = tree.get(LIBRARY)
    names = given if isinstance(given, ListNode) else [given]
    texts = [str(name) for name in names if isinstance(name, TextNode) and name.strip()]
    return [*dict.fromkeys(texts)] if len(texts) == len(names) <= _MOST else []


def refuse_other_keys(library: MapNode, source: str) -> None:
    """Refuse what no library gives, and things that are no mappings.

    Raises:
        ScenarioError: with everything found.
    """
    problems: list[Problem] = []
    whole = [key for key in library if key in _OF_LIFTS]
    if len(whole) > 1:
        sentence = f"is a lift file, with {_and(whole)}; a library has no more than {_and(SECTIONS)}"
        raise ScenarioError(source, [Problem(None, "", sentence)])
    if library.get("format") != "1":
        found = f"'{shorten(str(library['format']))}'" if "format" in library else "none"
        sentence = f"found {found}; a library begins with 'format: 1', as a lift file does"
        problems.append(problem_at(library, ("format",), sentence))
    for section, given in library.items():
        if section == "format":
            continue
        if section == LIBRARY:
            sentence = "a library names no other one; a lift file names several, [cranes.yaml, ropes.yaml]"
            problems.append(problem_at(library, (section,), sentence))
        elif section not in SECTIONS:
            sentence = f"'{shorten(section)}' is not a section of a library; {nearest(section, SECTIONS)}"
            problems.append(problem_at(library, (section,), sentence))
        elif not isinstance(given, MapNode) or not given:
            problems.append(
                problem_at(library, (section,), "a mapping from names to what they give is needed")
            )
        else:
            wrong = [name for name, one in given.items() if not isinstance(one, MapNode)]
            problems += [problem_at(library, (section, name), "a mapping is needed") for name in wrong]
    if problems:
        raise ScenarioError(source, problems)


def _and(keys: Sequence[str]) -> str:
    *first, last = (f"'{one}'" for one in keys)
    return f"{', '.join(first)} and {last}"


def _of_file(node: MapNode, file: str, line: int) -> MapNode:
    """A thing of a library that knows in which file it stands."""
    own = like(node, node)
    own.file, own.line = file, line
    return own


def _empty(given: Node) -> MapNode:
    """A section that the lift file has not, where the library has its own."""
    made = MapNode()
    made.line, made.key_lines = given.line, {}
    return made
