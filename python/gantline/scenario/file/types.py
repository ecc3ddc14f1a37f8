"""Types of cranes, vessels, lines and so on: what several of them have in common stands once in a lift file.

A thing that names a type in its `type` has what the type gives, mapping by mapping and key by key, unless it
says it itself. The tree with all that filled in is what is validated; it still knows where in the file each
part stands, for messages. What is changed in a lift is changed in the tree as it was written.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from typing import Final, NamedTuple, get_args

from gantline.scenario.afloat.mooring import MooringLine
from gantline.scenario.cranes.crane import CRANE_TYPES
from gantline.scenario.errors import PathPart, Problem, closest, nearest, shorten
from gantline.scenario.file.tree import MapNode, Node, TextNode, like, problem_at, texts

__all__ = ["TYPED", "Typed", "filled_in", "misnamed", "without"]


class Typed(NamedTuple):
    """A section of the lift file whose things may name a type.

    Attributes:
        section: its key.
        types: that of the types.
        one: what one of its things is called in messages.
        kinds: words that stand in `type` where no name of a type does: what kind of thing it is.
        needs_kind: whether each is one of these.
    """

    section: str
    types: str
    one: str
    kinds: tuple[str, ...] = ()
    needs_kind: bool = False


#: Most values that things may have from one type, all together: far more than any lift has.
_MOST_VALUES: Final = 200_000

_LINES: Final = get_args(MooringLine.model_fields["type"].annotation)

#: The sections whose things may name a type.
TYPED: Final = (
    Typed("cranes", "crane_types", "crane", CRANE_TYPES, needs_kind=True),
    Typed("vessels", "vessel_types", "vessel"),
    Typed("mooring_lines", "mooring_line_types", "mooring line", _LINES),
    Typed("fenders", "fender_types", "fender"),
    Typed("spreaders", "spreader_types", "spreader"),
    Typed("compensators", "compensator_types", "compensator"),
    Typed("guides", "guide_types", "guide"),
)


def filled_in(tree: MapNode) -> MapNode:
    """The tree with what types give in the things that name them; the tree itself where none does."""
    sections: dict[str, MapNode] = {}
    for of in TYPED:
        things, types = tree.get(of.section), tree.get(of.types)
        if not isinstance(things, MapNode) or not isinstance(types, MapNode):
            continue
        whole = {
            name: _of_type(thing, types[thing["type"]], of)
            for name, thing in things.items()
            if isinstance(thing, MapNode) and _names_one(thing.get("type"), types, of)
        }
        if whole:
            sections[of.section] = like(things, {**things, **whole})
    return like(tree, {**tree, **sections}) if sections else tree


def misnamed(tree: MapNode) -> dict[tuple[PathPart, ...], Problem]:
    """Things whose type there is not, and types that cannot be, by path, with what is wrong."""
    return {path: problem for of in TYPED for path, problem in _misnamed(tree, of)}


def without(tree: MapNode, misnamed: Collection[tuple[PathPart, ...]]) -> MapNode:
    """The tree without what is misnamed or whose type is, and without a section that then is empty."""
    paths = {*misnamed}
    for of in TYPED:
        things = tree.get(of.section)
        for name, thing in things.items() if isinstance(things, MapNode) else ():
            if isinstance(thing, MapNode) and (of.types, thing.get("type")) in paths:
                paths.add((of.section, name))
    sections: dict[str, Node] = {}
    for section, things in tree.items():
        if isinstance(things, MapNode):
            left = {name: thing for name, thing in things.items() if (section, name) not in paths}
            if left or not things:
                sections[section] = things if len(left) == len(things) else like(things, left)
        else:
            sections[section] = things
    return like(tree, sections)


def _misnamed(tree: MapNode, of: Typed) -> Iterator[tuple[tuple[PathPart, ...], Problem]]:
    things, types = tree.get(of.section), tree.get(of.types, MapNode())
    if not isinstance(types, MapNode):
        return
    for name, kind in types.items():
        path = (of.types, name)
        given = kind.get("type") if isinstance(kind, MapNode) else None
        if name in of.kinds:
            sentence = f"'{name}' is a kind of {of.one}; another name for a type of yours is right"
            yield path, problem_at(tree, path, sentence)
        elif isinstance(kind, MapNode) and of.needs_kind and given is None:
            sentence = f"'type' is missing; a type of {of.one} says its kind, {_or(of.kinds)}"
            yield path, problem_at(tree, path, sentence)
        elif given is not None and not of.kinds:
            sentence = f"a type of {of.one} has no type itself; leave it out"
            yield path, problem_at(tree, (*path, "type"), sentence)
        elif isinstance(given, TextNode) and given in types and given not in of.kinds:
            sentence = f"'{shorten(given)}' is a type, too; a type says its kind, {_or(of.kinds)}"
            yield path, problem_at(tree, (*path, "type"), sentence)
    yield from _too_many(tree, of)
    for name, thing in things.items() if isinstance(things, MapNode) else ():
        given = thing.get("type") if isinstance(thing, MapNode) else None
        if not isinstance(given, TextNode) or given in of.kinds or given in types:
            continue
        # Of a word that is like no type the thing itself knows more: it may be a kind in other words.
        if not of.kinds or closest(given, types) is not None:
            path = (of.section, name)
            sentence = f"'{shorten(given)}' is not a name of '{of.types}'; {nearest(given, types)}"
            yield path, problem_at(tree, (*path, "type"), sentence)


def _too_many(tree: MapNode, of: Typed) -> Iterator[tuple[tuple[PathPart, ...], Problem]]:
    """A type that would make a small file a huge one, as aliases do."""
    things, types = tree.get(of.section), tree[of.types] if of.types in tree else MapNode()
    named = Counter(
        one["type"]
        for one in (things.values() if isinstance(things, MapNode) else ())
        if isinstance(one, MapNode) and isinstance(one.get("type"), TextNode)
    )
    for name, count in named.items():
        values = sum(1 for _ in texts(types[name])) if count > 1 and name in types else 0
        if values * count > _MOST_VALUES:
            sentence = f"{count} things have this type, with {values} values each"
            right = f"types give at most {_MOST_VALUES} in all"
            yield (of.types, name), problem_at(tree, (of.types, name), f"{sentence}; {right}")


def _or(words: tuple[str, ...]) -> str:
    *first, last = (f"'{one}'" for one in words)
    return f"{', '.join(first)} or {last}"


def _names_one(given: Node | None, types: MapNode, of: Typed) -> bool:
    return isinstance(given, TextNode) and given not in of.kinds and isinstance(types.get(given), MapNode)


def _of_type(thing: MapNode, kind: MapNode, of: Typed) -> MapNode:
    """A thing with what its type gives; `type` is then the kind of that type, where there are kinds."""
    name = thing["type"]
    own = {key: node for key, node in thing.items() if key != "type" or not of.kinds}
    return _over(like(thing, own), kind, (of.types, str(name)))


def _over(own: MapNode, given: MapNode, place: tuple[PathPart, ...]) -> MapNode:
    """A mapping in which what is not said is as in another one, which stands at a place of the file."""
    merged = like(own, {})
    lines, elsewhere = dict(given.key_lines), {}
    for key, node in given.items():
        mine = own.get(key, node)
        if isinstance(mine, MapNode) and isinstance(node, MapNode) and mine is not node:
            merged[key] = _over(mine, node, (*place, key))
        else:
            merged[key] = mine
        if key not in own:
            elsewhere[key] = (*place, key)
    merged.update({key: node for key, node in own.items() if key not in given})
    merged.key_lines = {key: own.key_lines.get(key, lines.get(key, own.line)) for key in merged}
    merged.elsewhere = elsewhere
    return merged
