"""Things in a lift file by dotted path, and lift files with one thing changed.

A path such as ``slings.U1.1.length`` names keys from the top; a key with dots is found longest match first. A
part of a list is its place from 1, ``plan.2.speed`` or as messages have it ``plan[2].speed``, of a list of
three also ``x``, ``y`` or ``z``. The last key of a mapping need not be there yet. Cranes, trolleys and hooks
may be named as plans name them, ``goliath.L.height``, wherever they stand.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Set
from numbers import Real
from typing import Any, Final

from gantline.scenario.errors import ScenarioError, closest, nearest, shorten
from gantline.scenario.file.tree import ListNode, MapNode, Node, TextNode, like, parse_text
from gantline.scenario.file.types import filled_in

__all__ = ["PathError", "node_at", "node_of", "put", "text_node"]

_AXES: Final = ("x", "y", "z")
_PLACE: Final = re.compile(r"\[(\d+)\]")
#: The key that names libraries, which `gantline.scenario.file.library` puts in before this.
_LIBRARY: Final = "library"
#: How deep a text may be nested too.
_DEEPEST: Final = 32


class PathError(ValueError):
    """A path leads nowhere; the message is a plain sentence."""


def node_at(tree: MapNode, path: str) -> Node | None:
    """What stands at a path; None where its last key could stand and does not.

    Raises:
        PathError: if an earlier part of the path leads nowhere.
    """
    return _at(tree, _steps(tree, path))


def line_at(tree: MapNode, path: str) -> int:
    """The line of what stands at a path; where it could stand and does not, that of what would hold it.

    Raises:
        PathError: if an earlier part of the path leads nowhere.
    """
    steps = _steps(tree, path)
    node: Node = tree
    for step in steps:
        # What a type or a library gives stands elsewhere: another one would stand in the thing that has it.
        if isinstance(node, MapNode) and (str(step) not in node or str(step) in node.elsewhere):
            break
        node = _part(node, step)
    return node.line


def put(tree: MapNode, path: str, node: Node) -> MapNode:
    """The tree with a node in place of what stands at a path; the tree given stays as it is.

    What a type gives may be named as a part of what has that type: it then is said there.

    Raises:
        PathError: if the path leads nowhere.
    """
    if path == _LIBRARY or (_LIBRARY in tree and re.split(r"[.\[]", path)[0] == _LIBRARY):
        raise PathError("a library is read with its file; name what it gives, or edit the file")
    whole = filled_in(tree)
    *way, last = _steps(whole, path)
    changed = like(tree, {key: _copy(value) for key, value in tree.items()})
    holder: Node = changed
    given: Node = whole
    for step in way:
        given = _part(given, step)
        if isinstance(holder, MapNode) and str(step) not in holder:
            _set(holder, step, _begun(given))
        holder = _part(holder, step)
    _set(holder, last, node)
    return changed


def text_node(text: str, line: int) -> TextNode:
    """A scalar as if it had been written in a line."""
    node = TextNode(text)
    node.line = line
    return node


def node_of(value: Any, line: int, depth: int = 0) -> Node:
    """A value of Python as if it had been written in a line.

    Args:
        value: A text as in a lift file, also of a list or mapping: ``"[0 m, 0 m, 1 m]"``; a number or a truth
            value, where a lift file has one; or a list or mapping of such.
        line: Where it stands.
        depth: In how many lists and mappings it stands.

    Raises:
        PathError: if it is nothing that a lift file can say.
    """
    if depth > _DEEPEST:
        raise PathError(f"lists and mappings stand in one another {depth} deep; does one hold itself?")
    if isinstance(value, str):
        return _flow(value, line) if value.lstrip()[:1] in ("[", "{") else text_node(value, line)
    if isinstance(value, bool):
        return text_node(str(value).lower(), line)
    if isinstance(value, Real):
        return text_node(str(value), line)
    if isinstance(value, Mapping):
        mapping = MapNode({str(key): node_of(one, line, depth + 1) for key, one in value.items()})
        mapping.line, mapping.key_lines = line, dict.fromkeys(mapping, line)
        return mapping
    if isinstance(value, Iterable) and not isinstance(value, (bytes, Set)) and getattr(value, "ndim", 1) > 0:
        items = ListNode(node_of(one, line, depth + 1) for one in value)
        items.line = line
        return items
    sentence = f"{shorten(repr(value))} is no value of a lift file"
    raise PathError(f"{sentence}; a text such as '320 t', a number, a list or a mapping is right")


def _flow(text: str, line: int) -> Node:
    """A list or mapping in brackets."""
    try:
        tree = parse_text(f"value: {text}", "")
    except ScenarioError as error:
        raise PathError(f"'{shorten(text)}': {error.problems[0].sentence}") from None
    return node_of(tree["value"], line)


def _steps(tree: MapNode, path: str) -> list[str | int]:
    """Keys of mappings and indices of lists that lead to what a path names; the last key may not be there."""
    node: Node = tree
    rest, walked = _from_the_top(tree, _PLACE.sub(r".\1", path).split(".")), ""
    steps: list[str | int] = []
    while rest:
        if isinstance(node, TextNode):
            raise PathError(f"'{shorten(walked)}' is a single value; it has no '{shorten('.'.join(rest))}'")
        step: str | int
        if isinstance(node, MapNode):
            step, used = _key(node, rest, walked)
        else:
            step, used = _index(node, rest[0], walked), 1
        steps.append(step)
        shown, rest = ".".join(rest[:used]), rest[used:]
        walked = f"{walked}.{shown}" if walked else shown
        if rest:
            node = _part(node, step)
    return steps


def _at(tree: MapNode, steps: list[str | int]) -> Node | None:
    """What steps lead to; None where the last of them is a key that is not there."""
    node: Node | None = tree
    for step in steps:
        node = node.get(str(step)) if isinstance(node, MapNode) else _part(node, step)
    return node


def _part(node: Node | None, step: str | int) -> Node:
    assert isinstance(node, (MapNode, ListNode))
    found: Node = node[str(step)] if isinstance(node, MapNode) else node[int(step)]
    return found


def _set(holder: Node, step: str | int, node: Node) -> None:
    assert isinstance(holder, (MapNode, ListNode))
    if isinstance(holder, MapNode):
        holder[str(step)] = node
        holder.key_lines[str(step)] = node.line
    else:
        holder[int(step)] = node


def _begun(given: Node) -> Node:
    """What a thing says of its own before a part of what its type gives can be another: of lists all."""
    if not isinstance(given, MapNode):
        return _copy(given)
    begun = MapNode()
    begun.line, begun.key_lines = given.line, {}
    return begun


def _from_the_top(tree: MapNode, parts: list[str]) -> list[str]:
    """The parts of a path with the keys before a crane, trolley or hook with whose name it begins.

    Names are found longest match first, and after keys of the file.
    """
    beginnings = {".".join(parts[:used]): used for used in range(1, len(parts))}
    if any(beginning in tree for beginning in beginnings):
        return parts
    named = [(beginnings[name], place) for name, place in _movers(tree) if name in beginnings]
    used, place = max(named, default=(0, ()))
    return [*place, *parts[used:]]


def _movers(tree: MapNode) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Cranes, their trolleys and their hooks: the name that plans have, and the keys that lead there."""
    for crane, place, body in _mappings(tree, "cranes"):
        yield crane, place
        trolleys = [*_mappings(body, "trolleys")]
        for trolley, inner, _ in trolleys:
            yield f"{crane}.{trolley}", (*place, *inner)
        for holder, node in [((), body), *((inner, trolley) for _, inner, trolley in trolleys)]:
            for hook, inner, _ in _mappings(node, "hooks"):
                yield f"{crane}.{hook}", (*place, *holder, *inner)


def _mappings(node: MapNode, key: str) -> Iterator[tuple[str, tuple[str, ...], MapNode]]:
    """Of the mappings below a key: the name of each, the two keys that lead there, and itself."""
    below = node.get(key)
    for name, one in below.items() if isinstance(below, MapNode) else ():
        if isinstance(one, MapNode):
            yield name, (key, name), one


def _key(node: MapNode, rest: list[str], walked: str) -> tuple[str, int]:
    """The key of a mapping that a path goes on with, and of how many of its parts that is."""
    for used in range(len(rest), 0, -1):
        key = ".".join(rest[:used])
        if key in node:
            return key, used
    if len(rest) == 1 and rest[0]:
        return rest[0], 1
    # Of a name with dots the whole is more like the known one than its first part.
    words = [".".join(rest[:-1]), rest[0]]
    word = next((word for word in words if closest(word, node) is not None), rest[0])
    if not walked and closest(word, node) is None:
        whole = _only_place(node, rest)
        if whole is not None:
            raise PathError(f"there is no '{shorten(word)}' of this file; did you mean '{whole}'?")
    place = f" in '{shorten(walked)}'" if walked else ""
    raise PathError(f"there is no '{shorten(word)}'{place} of this file; {nearest(word, node)}")


def _only_place(tree: MapNode, parts: list[str]) -> str | None:
    """The only path that ends as a path does and has all its parts on the way, in order; None of several.

    People name a thing without where it stands in the file, ``S1.length``.
    """
    found = []
    for path in _paths(tree, ()):
        left = iter(".".join(path).split("."))
        if path[-1].split(".")[-1] == parts[-1] and all(part in left for part in parts):
            found.append(".".join(path))
    return found[0] if len(found) == 1 else None


def _paths(node: MapNode, before: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    for key, value in node.items():
        yield (*before, key)
        if isinstance(value, MapNode):
            yield from _paths(value, (*before, key))
        elif isinstance(value, ListNode) and len(value) == len(_AXES):
            yield from ((*before, key, axis) for axis in _AXES)


def _index(node: ListNode, part: str, walked: str) -> int:
    mappings = [(place, one) for place, one in enumerate(node, 1) if isinstance(one, MapNode)]
    has_axes = len(node) == len(_AXES) and not mappings
    if has_axes and part in _AXES:
        return _AXES.index(part)
    if part.isascii() and part.isdecimal() and 1 <= int(part[:9]) <= len(node):
        return int(part) - 1
    right = "'x', 'y', 'z' or a place" if has_axes else "a place"
    sentence = f"'{shorten(part)}' is no part of the list '{shorten(walked)}'"
    named = [place for place, one in mappings if part in one.values()]
    if len(named) == 1:
        raise PathError(f"{sentence} by name; it is '{shorten(walked)}.{named[0]}'")
    raise PathError(f"{sentence}; {right} from 1 to {len(node)} is right")


def _copy(node: Node) -> Node:
    """The same, with mappings and lists of its own; what a validation noted is left behind."""
    if isinstance(node, MapNode):
        return like(node, {key: _copy(value) for key, value in node.items()})
    if isinstance(node, ListNode):
        items = ListNode(_copy(item) for item in node)
        items.line = node.line
        return items
    return node
