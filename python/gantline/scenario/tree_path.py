"""Things in a lift file by dotted path, and lift files with one thing changed.

A path such as ``slings.U1.1.length`` names keys from the top; a key with dots is found longest match first. A
part of a list is its place from 1, of a list of three also ``x``, ``y`` or ``z``. The last key of a mapping
need not be there yet.
"""

from __future__ import annotations

from typing import Final

from gantline.scenario.errors import closest, nearest, shorten
from gantline.scenario.tree import ListNode, MapNode, Node, TextNode

__all__ = ["PathError", "node_at", "put", "text_node"]

_AXES: Final = ("x", "y", "z")


class PathError(ValueError):
    """A path leads nowhere; the message is a plain sentence."""


def node_at(tree: MapNode, path: str) -> Node | None:
    """What stands at a path; None where its last key could stand and does not.

    Raises:
        PathError: if an earlier part of the path leads nowhere.
    """
    holder, key = _holder(tree, path)
    if isinstance(holder, MapNode):
        return holder.get(str(key))
    found: Node = holder[int(key)]
    return found


def put(tree: MapNode, path: str, node: Node) -> MapNode:
    """The tree with a node in place of what stands at a path; the tree given stays as it is.

    Raises:
        PathError: if the path leads nowhere.
    """
    changed = _copy(tree)
    assert isinstance(changed, MapNode)
    holder, key = _holder(changed, path)
    if isinstance(holder, MapNode):
        holder[str(key)] = node
        holder.key_lines[str(key)] = node.line
    else:
        holder[int(key)] = node
    return changed


def text_node(text: str, line: int) -> TextNode:
    """A scalar as if it had been written in a line."""
    node = TextNode(text)
    node.line = line
    return node


def _holder(tree: MapNode, path: str) -> tuple[MapNode | ListNode, str | int]:
    """The mapping or list that holds what a path names, and its key or index there."""
    node: Node = tree
    rest, walked = path.split("."), ""
    while True:
        if isinstance(node, TextNode):
            raise PathError(f"'{shorten(walked)}' is a single value; it has no '{shorten('.'.join(rest))}'")
        step: str | int
        if isinstance(node, MapNode):
            step, used = _key(node, rest, walked)
        else:
            step, used = _index(node, rest[0], walked), 1
        shown, rest = ".".join(rest[:used]), rest[used:]
        if not rest:
            return node, step
        walked = f"{walked}.{shown}" if walked else shown
        node = node[str(step)] if isinstance(node, MapNode) else node[int(step)]


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
    place = f" in '{shorten(walked)}'" if walked else ""
    raise PathError(f"there is no '{shorten(word)}'{place} of this file; {nearest(word, node)}")


def _index(node: ListNode, part: str, walked: str) -> int:
    if len(node) == len(_AXES) and part in _AXES:
        return _AXES.index(part)
    if part.isascii() and part.isdecimal() and 1 <= int(part[:9]) <= len(node):
        return int(part) - 1
    right = "'x', 'y', 'z' or a place" if len(node) == len(_AXES) else "a place"
    sentence = f"'{shorten(part)}' is no part of the list '{shorten(walked)}'"
    raise PathError(f"{sentence}; {right} from 1 to {len(node)} is right")


def _copy(node: Node) -> Node:
    """The same, with mappings and lists of its own; what a validation noted is left behind."""
    if isinstance(node, MapNode):
        mapping = MapNode({key: _copy(value) for key, value in node.items()})
        mapping.line, mapping.key_lines = node.line, dict(node.key_lines)
        return mapping
    if isinstance(node, ListNode):
        items = ListNode(_copy(item) for item in node)
        items.line = node.line
        return items
    return node
